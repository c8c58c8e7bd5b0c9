#include "model/record.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/text.h"

namespace upbead {

namespace {

constexpr double exactly = 1e-6;  ///< of the range: samples that differ by less count as equal
constexpr std::size_t least_flat = 5;
constexpr double least_drift = 0.03, most_drift = 0.5;  ///< of the peak; a larger one is a load that lasts
constexpr std::size_t least_of_record = 50;             ///< samples; fewer may be the corners of a load that stops
constexpr double most_of_rise = 0.1;  ///< of the slope of the rise: a faster change is the load itself
constexpr int least_in_rise = 20;
constexpr double most_at_begin = 0.05;  ///< of the largest value, and of the peak where it ends

struct Extent {
  double least, most;
  double range() const { return most - least; }
  double size() const { return std::max(std::abs(least), std::abs(most)); }
};

Extent extent_of(const std::vector<double>& value) {
  const auto [least, most] = std::minmax_element(value.begin(), value.end());
  return {*least, *most};
}

double mean(const std::vector<double>& value, std::size_t first, std::size_t last) {
  double sum = 0.;
  for (std::size_t i = first; i < last; ++i) sum += value[i];
  return sum / static_cast<double>(last - first);
}

/// The median, as an event that begins early hardly changes it.
double median(const std::vector<double>& value, std::size_t first, std::size_t last) {
  std::vector<double> part(value.begin() + static_cast<std::ptrdiff_t>(first),
                           value.begin() + static_cast<std::ptrdiff_t>(last));
  const auto middle = part.begin() + static_cast<std::ptrdiff_t>(part.size() / 2);
  std::nth_element(part.begin(), middle, part.end());
  return *middle;
}

/// Finds the warnings of one record that is not dead.
class Inspection {
 public:
  explicit Inspection(const Record& record)
      : who_("record '" + record.name + "'"),
        time_(record.time),
        value_(record.value),
        n_(value_.size()),
        extent_(extent_of(value_)),
        jumps_(record.end && time_.back() + (time_.back() - time_.front()) / static_cast<double>(n_) < *record.end),
        at_ends_(std::max<std::size_t>(5, n_ / 50)),
        start_(median(value_, 0, at_ends_)) {
    for (std::size_t i = 0; i < n_; ++i)
      if (std::abs(value_[i] - start_) > std::abs(value_[top_] - start_)) top_ = i;
    peak_ = std::abs(value_[top_] - start_);
    rise_ = slope_of_rise();
  }

  NumberedWarnings begun() {
    check_begin();
    return std::move(list_);
  }

  NumberedWarnings run() {
    check_saturation(1., extent_.most);
    check_saturation(-1., extent_.least);
    check_begin();
    check_end();
    check_before_the_event();
    check_rise();
    check_spikes();
    return std::move(list_);
  }

 private:
  void add(const std::string& name, double value, double limit, const std::string& what, const std::string& cure) {
    list_.push_back({name, value, limit, "1", who_ + " " + what, cure});
  }

  bool rests(std::size_t first, std::size_t last) const {
    const auto [least, most] = std::minmax_element(value_.begin() + static_cast<std::ptrdiff_t>(first),
                                                   value_.begin() + static_cast<std::ptrdiff_t>(last));
    return *most - *least <= 0.1 * peak_;
  }

  /// Looks for a run of equal samples at an extreme that the record rises to and leaves. `sign`: of the extreme.
  void check_saturation(double sign, double extreme) {
    const auto is_there = [&](std::size_t i) { return std::abs(value_[i] - extreme) <= exactly * extent_.range(); };
    const auto is_away = [&](std::size_t i) { return sign * (extreme - value_[i]) > 0.1 * extent_.range(); };
    std::size_t first_away = 0, last_away = n_;  // one past the last
    while (first_away < n_ && !is_away(first_away)) ++first_away;
    while (last_away > 0 && !is_away(last_away - 1)) --last_away;
    for (std::size_t i = 0; i < n_; ++i) {
      if (!is_there(i)) continue;
      std::size_t end = i;
      while (end < n_ && is_there(end)) ++end;
      const bool came = first_away<i, left = last_away> end;
      // a record that stays at zero between its events is not saturated
      const bool rests = std::abs(extreme - start_) <= 0.1 * extent_.range();
      if (end - i >= least_flat && came && left && !rests && !is_round(i, end, extreme)) {
        add("record_saturated", static_cast<double>(end - i), static_cast<double>(least_flat),
            "holds its extreme value " + significant(extreme) + " for " + std::to_string(end - i) + " samples at t = " +
                significant(time_[i]) + " s: the instrument was at its end, the true peak is larger",
            "use a record that is not cut; give a load that is meant so by its corners");
        list_.back().voids = true;
        return;
      }
      i = end;
    }
  }

  /// Whether a flat top is that of a smooth curve that is sampled finely: a parabola falls by (3/1)^2 times as much
  /// within three half widths, a record that is cut by far more.
  bool is_round(std::size_t first, std::size_t end, double extreme) const {
    const std::size_t width = end - first;
    double fall = 0.;
    if (first >= width) fall = std::abs(value_[first - width] - extreme);
    if (end - 1 + width < n_) fall = std::max(fall, std::abs(value_[end - 1 + width] - extreme));
    return fall < 100. * exactly * extent_.range();
  }

  /// Last time before the peak at which the record's distance from its start is at most `share` of the peak.
  double crossing(double share) const {
    std::size_t i = top_;
    while (i > 0 && std::abs(value_[i] - start_) > share * peak_) --i;
    return time_[i];
  }

  /// Slope from 10 to 90 % of the peak, the usual measure of a rise (1/s of the peak).
  double slope_of_rise() const {
    const double rise = crossing(0.9) - crossing(0.1);
    return rise > 0. ? 0.8 / rise : HUGE_VAL;
  }

  /// Slope between the means of the first and the last third of [first, last) (1/s of the peak).
  double slope(std::size_t first, std::size_t last) const {
    const std::size_t third = std::max<std::size_t>(1, (last - first) / 3);
    const double change = mean(value_, last - third, last) - mean(value_, first, first + third);
    return std::abs(change) / peak_ / (mean(time_, last - third, last) - mean(time_, first, first + third));
  }

  /// Distance of a value from those of some samples; 0 within them: the first or last samples of a smooth rise or fall
  /// are no rest.
  double beyond(double value, std::size_t first, std::size_t last) const {
    const auto [least, most] = std::minmax_element(value_.begin() + static_cast<std::ptrdiff_t>(first),
                                                   value_.begin() + static_cast<std::ptrdiff_t>(last));
    return std::max({*least - value, value - *most, 0.});
  }

  /// A load is zero before its record: one that begins in the middle of an event jumps there, and its front is lost.
  void check_begin() {
    const double share = std::abs(value_.front()) / extent_.size();
    if (std::min(share, std::abs(start_) / extent_.size()) <= most_at_begin) return;
    const std::size_t third = std::max<std::size_t>(1, at_ends_ / 3);
    const double change = std::abs(mean(value_, at_ends_ - third, at_ends_) - mean(value_, 0, third));
    const bool moves = change > least_drift * peak_ && slope(0, at_ends_) > most_of_rise * rise_;
    const bool comes_back = std::abs(median(value_, n_ - at_ends_, n_)) < 0.5 * std::abs(start_);
    const std::string with = " with " + significant(100. * share, 2) + " % of its largest value";
    if (moves || comes_back)
      add("record_begun", share, most_at_begin,
          "begins at t = " + significant(time_.front()) + " s" + with +
              ": what came before is lost, and it jumps there from zero",
          "give the record from its rest on, or an earlier record_start");
    else
      add("record_offset", share, most_at_begin,
          "begins and ends" + with +
              ": an instrument that does not read zero at rest, or still water in its values; it "
              "jumps there from zero",
          "take off what it reads at rest, by zero = SECONDS where it has that key; give a load that stays by its "
          "corners");
    list_.back().voids = true;
  }

  void check_end() {
    const double end = median(value_, n_ - at_ends_, n_), drift = std::abs(end - start_) / peak_;
    const double apart = std::min(beyond(end, 0, at_ends_), beyond(start_, n_ - at_ends_, n_)) / peak_;
    const bool is_on = std::abs(value_.back()) > most_at_begin * extent_.size();  // one that began on may be off now
    if (jumps_ && is_on && n_ >= least_of_record && drift >= most_drift) return check_cut();
    if (!rests(0, at_ends_) || !rests(n_ - at_ends_, n_)) return;  // the record is not at rest at both ends
    if (slope(n_ - at_ends_, n_) > most_of_rise * rise_) return check_cut();
    if (apart > least_drift && drift < most_drift)
      add("record_drifting", drift, least_drift,
          "ends " + significant(100. * drift, 2) +
              " % of its peak away from where it starts: it drifts, or is cut before it has come back",
          "take the drift off, or give a longer record");
  }

  /// A load that has not come back to its start where the record ends jumps to zero there.
  void check_cut() {
    const double rest = std::abs(value_.back() - start_) / peak_;
    const bool is_record = n_ >= least_of_record;
    if (!(beyond(value_.back(), 0, at_ends_) > least_drift * peak_) || !(rest < most_drift || is_record)) return;
    add("record_cut", rest, least_drift,
        "has not come back where it ends, at t = " + significant(time_.back()) + " s, " + significant(100. * rest, 2) +
            " % of its peak away from where it starts: the load jumps to zero there",
        "give a longer record, or let it come back to zero");
    list_.back().voids = jumps_ && rest > most_at_begin;
  }

  /// The drift before the record first exceeds a tenth of its peak.
  void check_before_the_event() {
    std::size_t event = 0;
    while (event < n_ && std::abs(value_[event] - start_) <= 0.1 * peak_) ++event;
    if (event < 4 * least_flat) return;
    const std::size_t part = event / 4;  // the foot of the event itself is no drift
    const double drift = std::abs(mean(value_, event / 2, event / 2 + part) - mean(value_, 0, part)) / peak_;
    if (slope(0, event) > most_of_rise * rise_) return;  // the foot of a smooth rise
    if (drift > least_drift)
      add("record_drifting", drift, least_drift,
          "moves by " + significant(100. * drift, 2) +
              " % of its peak before anything happens, until t = " + significant(time_[event]) + " s: it drifts",
          "take the trend off");
  }

  void check_rise() {
    std::size_t foot = top_;
    while (foot > 0 && std::abs(value_[foot] - start_) > 0.1 * peak_) --foot;
    const int n = static_cast<int>(top_ - foot);
    if (n < least_in_rise && foot > 0)
      add("record_too_coarse", n, least_in_rise,
          "has " + std::to_string(n) + " samples in its rise of " + significant(time_[top_] - time_[foot]) +
              " s to its peak, fewer than " + std::to_string(least_in_rise) + ": the true peak may lie between them",
          "sample every " + significant((time_[top_] - time_[foot]) / least_in_rise, 2) + " s");
  }

  void check_spikes() {
    int spikes = 0;
    double when = 0.;
    for (std::size_t i = 1; i + 1 < n_; ++i) {
      const double a = value_[i - 1], b = value_[i], c = value_[i + 1], range = extent_.range();
      if (std::abs(a - c) > 0.05 * range || std::min(std::abs(b - a), std::abs(b - c)) < 0.2 * range) continue;
      if (spikes++ == 0) when = time_[i];
    }
    if (spikes > 0)
      add("record_spikes", spikes, 0.,
          "has " + std::to_string(spikes) + " lone samples far off both neighbours, the first at t = " +
              significant(when) + " s: faults of the instrument, or it is sampled too coarsely",
          "take the lone samples out");
  }

  std::string who_;
  const std::vector<double>&time_, &value_;
  std::size_t n_;
  Extent extent_;
  bool jumps_;           ///< to zero after its last sample
  std::size_t at_ends_;  ///< number of samples that define the start, and of those that define the end
  double start_;
  std::size_t top_ = 0;  ///< sample farthest from the start
  double peak_ = 0.;
  double rise_ = 0.;  ///< slope (1/s of the peak)
  NumberedWarnings list_;
};

/// Warning record_begun of the samples from t = 0 on, where those before are known and not taken.
NumberedWarnings begun_before(const Record& record) {
  const auto first = std::lower_bound(record.time.begin(), record.time.end(), 0.) - record.time.begin();
  const Record taken{record.name,
                     {record.time.begin() + first, record.time.end()},
                     {record.value.begin() + first, record.value.end()}};
  if (taken.value.size() < 10 || !(extent_of(taken.value).range() > 0.)) return {};
  return Inspection(taken).begun();
}

/// At most `most` samples: those with the largest pressures.
std::vector<std::size_t> telling_samples(const std::vector<RecordAtHeight>& at) {
  constexpr std::size_t most = 2000;
  std::vector<double> size(at.front().record.value.size(), 0.);
  for (const RecordAtHeight& one : at)
    for (std::size_t t = 0; t < size.size(); ++t) size[t] += std::abs(one.record.value[t]);
  std::vector<std::size_t> samples(size.size());
  std::iota(samples.begin(), samples.end(), 0U);
  if (samples.size() <= most) return samples;
  const auto larger = [&](std::size_t a, std::size_t b) { return size[a] > size[b]; };
  std::nth_element(samples.begin(), samples.begin() + most, samples.end(), larger);
  samples.resize(most);
  return samples;
}

/// Sum over samples and heights of squared second differences of the pressures.
double roughness(const std::vector<RecordAtHeight>& at, const std::vector<std::size_t>& order,
                 const std::vector<std::size_t>& samples) {
  double sum = 0.;
  for (std::size_t i = 1; i + 1 < at.size(); ++i) {
    const double below = at[i].height - at[i - 1].height, above = at[i + 1].height - at[i].height;
    const auto &p = at[order[i - 1]].record.value, &q = at[order[i]].record.value, &r = at[order[i + 1]].record.value;
    for (const std::size_t t : samples) {
      const double bend = q[t] - (above * p[t] + below * r[t]) / (above + below);
      sum += bend * bend;
    }
  }
  return sum;
}

}  // namespace

bool is_measured(const Record& record) {
  const std::vector<double>& t = record.time;
  if (t.size() < 10) return false;
  if (t.size() >= 50) return true;
  const double interval = (t.back() - t.front()) / static_cast<double>(t.size() - 1);
  for (std::size_t i = 1; i < t.size(); ++i)
    if (std::abs(t[i] - t[i - 1] - interval) > 0.01 * interval) return false;
  return true;
}

NumberedWarnings record_warnings(const Record& record) {
  if (!is_measured(record)) return lost_samples(record);
  const Extent extent = extent_of(record.value);
  if (extent.range() <= exactly * extent.size())
    return {{"record_dead", extent.range(), exactly * extent.size(), "1",
             "record '" + record.name + "' has the same value " + significant(extent.most) +
                 " throughout: the instrument was dead",
             "leave the record out, or write it as a pulse if it is meant"}};
  NumberedWarnings list = Inspection(record).run();
  if (record.time.front() < 0.) append(list, begun_before(record));
  append(list, lost_samples(record));
  return list;
}

NumberedWarnings drop_warnings(const Record& record, const NumberedWarnings& told) {
  constexpr double lasts = 0.5, at_peak = 0.9;  // of the largest value
  const bool is_cut = std::any_of(told.begin(), told.end(), [](const auto& one) { return one.name == "record_cut"; });
  if (is_cut || !record.end || !(record.time.back() < *record.end * (1. - 1e-9))) return {};
  const double drop = std::abs(record.value.back()) / extent_of(record.value).size();
  if (!(drop >= lasts)) return {};
  return {
      {"load_drops", drop, lasts, "1",
       "the record of '" + record.name + "' ends at " + significant(record.time.back(), 4) + " s with " +
           significant(100. * drop, 3) + " % of its largest value, and the load drops to zero there at once: " +
           (drop >= at_peak ? "its largest value may not have come, and its fall is not felt" : "it is cut, or stays"),
       "give the whole record; let one that stays go on until time.end, and one that falls end with a row of zero",
       drop >= at_peak}};
}

NumberedWarnings swapped_records(const std::vector<RecordAtHeight>& records) {
  constexpr double limit = 0.25;
  if (records.size() < 4) return {};
  std::vector<std::size_t> order(records.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  const std::vector<std::size_t> samples = telling_samples(records);
  const double as_given = roughness(records, order, samples);
  double least = as_given;
  std::pair<std::size_t, std::size_t> pair{0, 0};
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      std::swap(order[i], order[j]);
      if (const double now = roughness(records, order, samples); now < least) {
        least = now;
        pair = {i, j};
      }
      std::swap(order[i], order[j]);
    }
  if (least >= limit * as_given) return {};
  const auto& [a, b] = pair;
  return {{"records_swapped", least / as_given, limit, "1",
           "records '" + records[a].record.name + "' and '" + records[b].record.name +
               "' look exchanged: with them at each other's height, " + significant(records[b].height) + " and " +
               significant(records[a].height) + " m, the pressures bend " + significant(as_given / least, 2) +
               " times less over the height",
           "look at the cables, or at the list of heights"}};
}

}  // namespace upbead
