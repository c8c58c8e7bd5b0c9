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
    estimate_ = F * answer.resisting;
  }
  if (answer.found == RestFound::open) {
    open_from_ = std::min(open_from_.value_or(F), F);
    open_to_ = std::max(open_to_.value_or(F), F);
  }
  if (open_from_ && ((lower_ && *lower_ > *open_to_) || (upper_ && *upper_ < *open_from_)))
    open_from_ = open_to_ = std::nullopt;
}

/// By the motion of the last failure, slightly below the factor at which it would resist; from a rest near that in
/// growing steps; else the middle.
std::optional<double> FactorSearch::between() const {
  if (is_close(*lower_, *upper_)) return std::nullopt;
  if (open_from_) {
    if (!is_close(*lower_, *open_from_)) return std::sqrt(*lower_ * *open_from_);
    if (!is_close(*open_to_, *upper_)) return std::sqrt(*open_to_ * *upper_);
    return std::nullopt;
  }
  const double middle = std::sqrt(*lower_ * *upper_);
  if (rests_ > 0) return std::min(middle, *lower_ * (1. + 0.9 * closeness * std::pow(3., rests_ - 1)));
  const double below = estimate_ * (1. - 0.4 * closeness);
  return below > *lower_ * (1. + 0.1 * closeness) && below < *upper_ ? below : middle;
}

std::optional<double> FactorSearch::next() const {
  if (lower_ && upper_) return between();
  if (!lower_ && !upper_ && !open_from_) return 1.;
  if (!upper_) {
    const double last = std::max(lower_.value_or(smallest), open_to_.value_or(smallest));
    if (lower_ || last < largest) return last < largest ? std::optional(std::min(2. * last, largest)) : std::nullopt;
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
