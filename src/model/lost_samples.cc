#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "model/record.h"

namespace upbead {

namespace {

constexpr double many_steps = 5.;  ///< of those around it: rows are missing
constexpr double off_rest = 0.03;  ///< of the peak
constexpr std::size_t beside = 10, fewest_beside = 3;
constexpr double lost_jump = 0.2;             ///< of the range, within a sample
constexpr double above_usual = 3.;            ///< times the largest change of the record elsewhere
constexpr std::size_t dropped = 3, held = 5;  ///< equal samples

double middle(std::vector<double> part) {
  const auto at = part.begin() + static_cast<std::ptrdiff_t>(part.size() / 2);
  std::nth_element(part.begin(), at, part.end());
  return *at;
}

/// Equal samples, [first, end).
struct Flat {
  std::size_t first, end;
  std::size_t size() const { return end - first; }
};

class Losses {
 public:
  explicit Losses(const Record& record)
      : who_("record '" + record.name + "'"), time_(record.time), value_(record.value), n_(value_.size()) {
    for (std::size_t i = 0; i < n_;) {
      const std::size_t first = i;
      while (i < n_ && value_[i] == value_[first]) ++i;
      if (i - first >= dropped) flats_.push_back({first, i});
    }
    const auto [least, most] = std::minmax_element(value_.begin(), value_.end());
    range_ = *most - *least;
    rest_ = middle({value_.begin(), value_.begin() + static_cast<std::ptrdiff_t>(std::max<std::size_t>(5, n_ / 50))});
    peak_ = std::max(*most - rest_, rest_ - *least);
  }

  NumberedWarnings run() const {
    NumberedWarnings list;
    if (is_sampled()) add_gap(list);
    if (is_measured({"", time_, value_})) add_dropout(list);
    return list;
  }

 private:
  double step(std::size_t i) const { return time_[i] - time_[i - 1]; }
  double change(std::size_t i) const { return std::abs(value_[i] - value_[i - 1]); }

  /// Steps [first, end), without those of jumps.
  double usual_step(std::size_t first, std::size_t end) const {
    std::vector<double> steps;
    for (std::size_t i = first; i < end; ++i)
      if (step(i) > 0.) steps.push_back(step(i));
    return steps.size() < fewest_beside ? HUGE_VAL : middle(steps);
  }

  /// As is_measured(), but for rows that are missing: corners of a history are no samples.
  bool is_sampled() const {
    if (n_ < 10 || n_ >= 50) return n_ >= 50;
    const double usual = usual_step(1, n_);
    std::size_t equal = 0;
    for (std::size_t i = 1; i < n_; ++i) equal += std::abs(step(i) - usual) <= 0.01 * usual ? 1 : 0;
    return 5 * equal >= 4 * (n_ - 1);
  }

  double usual_before(std::size_t i) const { return usual_step(i > beside ? i - beside : 1, i); }
  double usual_after(std::size_t i) const { return usual_step(i + 1, std::min(i + 1 + beside, n_)); }

  /// A step is long beside those on both sides of it: those of CFD programs grow and shrink. Near an end of the record
  /// one side has too few.
  double usual_around(std::size_t i) const {
    const double before = usual_before(i), after = usual_after(i);
    return is_near_end(i) ? std::min(before, after) : std::max(before, after);
  }
  bool is_near_end(std::size_t i) const { return std::isinf(usual_before(i)) || std::isinf(usual_after(i)); }

  /// Whether it is long beside the next step on either side: most are not, and are judged quickly.
  bool may_be_gap(std::size_t i) const {
    const double before = i > 1 ? step(i - 1) : HUGE_VAL, after = i + 1 < n_ ? step(i + 1) : HUGE_VAL;
    return step(i) > many_steps * std::min(before, after);
  }

  /// What lies at rest on both sides may be left out by a person, unless it is noise; a lone last row is no noise.
  void add_gap(NumberedWarnings& list) const {
    std::size_t worst = 0, number = 0;
    const auto off = [&](std::size_t i) {
      return std::max(std::abs(value_[i - 1] - rest_), std::abs(value_[i] - rest_)) > off_rest * peak_;
    };
    for (std::size_t i = 1; i < n_; ++i) {
      if (!may_be_gap(i) || !(step(i) > many_steps * usual_around(i)) ||
          !(off(i) || (change(i) > 0. && !is_near_end(i))))
        continue;
      ++number;
      if (worst == 0 || off(i) > off(worst) || (off(i) == off(worst) && step(i) > step(worst))) worst = i;
    }
    if (worst == 0) return;
    const double usual = usual_around(worst);
    list.push_back({"record_gap", step(worst), many_steps * usual, "s",
                    who_ + " has no samples from " + significant(time_[worst - 1], 4) + " to " +
                        significant(time_[worst], 4) + " s, " + significant(step(worst) / usual, 3) +
                        " times its step" + (number > 1 ? ", and " + std::to_string(number - 1) + " more gaps" : "") +
                        ": a straight line is drawn over what was lost",
                    "use a whole record, or add the rows where it is known to be straight", off(worst)});
  }

  bool is_spike(std::size_t i) const {
    return i > 0 && i + 1 < n_ && std::abs(value_[i + 1] - value_[i - 1]) <= 0.05 * range_ &&
           std::min(change(i), change(i + 1)) >= 0.2 * range_;
  }

  /// The largest change from a sample to the next but where equal samples begin or end, at jumps and at spikes.
  double usual_change() const {
    std::vector<bool> edge(n_ + 1, false);
    for (const Flat& f : flats_) edge[f.first] = edge[f.end] = true;
    double largest = 0.;
    for (std::size_t i = 1; i < n_; ++i)
      if (!edge[i] && step(i) > 0. && !is_spike(i) && !is_spike(i - 1)) largest = std::max(largest, change(i));
    return largest;
  }

  /// Equal samples that a jump ends, and that a jump began, or that hold what a moving record had last; or that last
  /// to the end. Between flat parts they are a drawn box.
  bool is_lost(const Flat& f, double jump) const {
    const auto jumps = [&](std::size_t i) { return step(i) > 0. && change(i) >= jump; };
    const bool moves_before = f.first > 1 && change(f.first - 1) > 0. && !is_spike(f.first - 1),
               begins = moves_before && jumps(f.first);
    if (f.end == n_) return begins;
    const bool moves_after = f.end + 1 < n_ && change(f.end + 1) > 0. && !is_spike(f.end);
    const bool holds = moves_before && f.size() >= held && std::abs(value_[f.first] - rest_) > 0.1 * peak_;
    return moves_after && jumps(f.end) && (begins || holds);
  }

  void add_dropout(NumberedWarnings& list) const {
    const double jump = std::max(lost_jump * range_, above_usual * usual_change());
    const Flat* longest = nullptr;
    std::size_t number = 0;
    for (const Flat& f : flats_) {
      if (!is_lost(f, jump)) continue;
      ++number;
      if (!longest || f.size() > longest->size()) longest = &f;
    }
    if (!longest) return;
    list.push_back({"record_dropout", static_cast<double>(longest->size()), static_cast<double>(dropped), "1",
                    who_ + " stays at exactly " + significant(value_[longest->first], 4) + " for " +
                        std::to_string(longest->size()) + " samples from t = " + significant(time_[longest->first], 4) +
                        " s on, between jumps within a sample" +
                        (number > 1 ? ", and " + std::to_string(number - 1) + " more times" : "") +
                        ": its signal was lost there",
                    "use a whole record, or leave the transducer out", true});
  }

  std::string who_;
  const std::vector<double>&time_, &value_;
  std::size_t n_;
  std::vector<Flat> flats_;
  double range_ = 0., rest_ = 0., peak_ = 0.;
};

}  // namespace

NumberedWarnings lost_samples(const Record& record) {
  return record.value.size() < 10 ? NumberedWarnings() : Losses(record).run();
}

}  // namespace upbead
