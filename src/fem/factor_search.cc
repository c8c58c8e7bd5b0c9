#include "fem/factor_search.h"

#include <algorithm>
#include <cmath>

#include "base/text.h"

namespace upbead {

namespace {

bool is_close(double lower, double upper) {
  return upper - lower <= FactorSearch::closeness * lower;
}

}  // namespace

void FactorSearch::take(double F, const LimitAnswer& answer) {
  rests_ = answer.found == RestFound::rest ? rests_ + 1 : 0;
  if (answer.found == RestFound::rest) lower_ = std::max(lower_.value_or(F), F);
  if (answer.found == RestFound::none) {
    upper_ = std::min(upper_.value_or(F), F);
    estimate_ = F * answer.factor;
  }
  if (answer.found == RestFound::open) {
    open_from_ = std::min(open_from_.value_or(F), F);
    open_to_ = std::max(open_to_.value_or(F), F);
  }
  if (open_from_ && ((lower_ && *lower_ > *open_to_) || (upper_ && *upper_ < *open_from_)))
    open_from_ = open_to_ = std::nullopt;
}

/// After a failure slightly below the factor at which its motion would resist. From a rest near that in growing steps,
/// of which the first closes the bracket; else the middle.
std::optional<double> FactorSearch::between() const {
  if (is_close(*lower_, *upper_)) return std::nullopt;
  if (open_from_) {
    if (!is_close(*lower_, *open_from_)) return std::sqrt(*lower_ * *open_from_);
    if (!is_close(*open_to_, *upper_)) return std::sqrt(*open_to_ * *upper_);
    return std::nullopt;
  }
  const double below = estimate_ * (1. - 0.4 * closeness), middle = std::sqrt(*lower_ * *upper_);
  if (rests_ == 0 && below > *lower_ * (1. + 0.1 * closeness) && below < *upper_) return below;
  constexpr double near = 1.25;
  if (*upper_ > near * estimate_) return middle;
  return std::min(std::max(middle, *lower_ * (1. + 0.95 * closeness)),
                  *lower_ * (1. + 0.95 * closeness * std::pow(3., std::max(rests_ - 1, 0))));
}

std::optional<double> FactorSearch::next() const {
  if (lower_ && upper_) return between();
  if (!lower_ && !upper_ && !open_from_) return first_;
  if (!upper_) {
    const double last = std::max(lower_.value_or(smallest), open_to_.value_or(smallest));
    if (lower_ || last < largest)
      return last < largest ? std::optional(std::min(growth_ * last, largest)) : std::nullopt;
  }
  const double last = std::min(upper_.value_or(largest), open_from_.value_or(largest));
  if (last <= smallest) return std::nullopt;
  const double below = estimate_ * (1. - 0.4 * closeness);
  return std::max(smallest, !open_from_ && below > 0.25 * last && below < last ? below : 0.5 * last);
}

double FactorSearch::done() const {
  if (!lower_ || !upper_) return 0.;
  const double whole = std::log(2.) / closeness;
  return std::clamp(std::log(std::log(2.) / std::log(*upper_ / *lower_)) / std::log(whole), 0., 1.);
}

std::string FactorSearch::why() const {
  if (!open_from_) return {};
  const std::string to = *open_to_ > *open_from_ ? " to " + significant(*open_to_, 4) : "";
  return "with the strength over " + significant(*open_from_, 4) + to +
         " the search ended before it found a rest or a motion in which the ground fails";
}

}  // namespace upbead
