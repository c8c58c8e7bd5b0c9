#include "upbead/model/gauges.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "base/text.h"
#include "model/record.h"

namespace upbead {

namespace {

using Pairs = std::vector<std::array<double, 2>>;

constexpr double far = 1e6;  ///< m, beyond any wall

/// Appends the point to which the share of the first (side 0) or last transducer extends outward.
void append_end(const Gauges& gauges, int side, Pairs& pairs) {
  const double at = side == 0 ? gauges.place.front() : gauges.place.back(), outward = side == 0 ? -1. : 1.;
  if (gauges.beyond[side] == Beyond::constant) pairs.push_back({at + outward * far, 1.});
  if (gauges.beyond[side] == Beyond::to_zero) pairs.push_back({gauges.zero_at[side], 0.});
}

/// Integrals of a piecewise linear function y(x), and of x y(x), over [from, to].
std::array<double, 2> integrals(const Pairs& pairs, double from, double to) {
  std::array<double, 2> sum{0., 0.};
  for (std::size_t i = 0; i + 1 < pairs.size(); ++i) {
    const auto [x0, y0] = pairs[i];
    const auto [x1, y1] = pairs[i + 1];
    const double a = std::clamp(x0, from, to), b = std::clamp(x1, from, to);
    if (b <= a) continue;
    const auto y = [&, x0 = x0, y0 = y0, x1 = x1, y1 = y1](double x) { return y0 + (y1 - y0) * (x - x0) / (x1 - x0); };
    const double middle = 0.5 * (a + b);
    sum[0] += 0.5 * (b - a) * (y(a) + y(b));
    sum[1] += (b - a) / 6. * (a * y(a) + 4. * middle * y(middle) + b * y(b));  // Simpson's rule, exact for parabolas
  }
  return sum;
}

/// Of the integral of |p|: a resultant that is less, as of a standing wave on a bed, cancels, and errors are measured
/// by this share.
constexpr double least_resultant = 0.1;

Gauges sizes_of(const Gauges& gauges) {
  Gauges sizes = gauges;
  for (std::vector<double>& pressure : sizes.pressure)
    for (double& p : pressure) p = std::abs(p);
  return sizes;
}

/// Of all pressures together, over time.
std::vector<double> sum_of_sizes(const Gauges& gauges) {
  std::vector<double> sum(gauges.time.size(), 0.);
  for (const std::vector<double>& pressure : gauges.pressure)
    for (std::size_t t = 0; t < sum.size(); ++t) sum[t] += std::abs(pressure[t]);
  return sum;
}

Gauges every_other(const Gauges& gauges) {
  Gauges fewer = gauges;
  fewer.name.clear();
  fewer.place.clear();
  fewer.pressure.clear();
  for (std::size_t i = 0; i < gauges.count(); ++i) {
    if (i % 2 != 0 && i + 1 != gauges.count()) continue;
    fewer.name.push_back(gauges.name[i]);
    fewer.place.push_back(gauges.place[i]);
    fewer.pressure.push_back(gauges.pressure[i]);
  }
  return fewer;
}

/// Transducers of one record have the same samples: the first such warning, or that for the steepest rise, stands for
/// all.
void join(const std::string& name, const std::string& others_are, NumberedWarnings& list) {
  const auto rest = std::stable_partition(list.begin(), list.end(),
                                          [&](const NumberedWarning& warning) { return warning.name != name; });
  const auto others = list.end() - rest - 1;
  if (others < 1) return;
  NumberedWarning worst = *std::min_element(rest, list.end(), [&](const NumberedWarning& a, const NumberedWarning& b) {
    return name == "record_too_coarse" ? a.value < b.value : a.voids > b.voids;
  });
  worst.what += "; " + std::to_string(others) + " more of its row " + others_are;
  list.erase(rest, list.end());
  list.push_back(worst);
}

}  // namespace

std::vector<std::array<double, 2>> share(const Gauges& gauges, std::size_t i) {
  Pairs pairs;
  if (i > 0)
    pairs.push_back({gauges.place[i - 1], 0.});
  else
    append_end(gauges, 0, pairs);
  pairs.push_back({gauges.place[i], 1.});
  if (i + 1 < gauges.count())
    pairs.push_back({gauges.place[i + 1], 0.});
  else
    append_end(gauges, 1, pairs);
  return pairs;
}

Resultant resultant(const Gauges& gauges, double from, double to) {
  Resultant sum{std::vector<double>(gauges.time.size(), 0.), std::vector<double>(gauges.time.size(), 0.)};
  for (std::size_t i = 0; i < gauges.count(); ++i) {
    const auto [force, moment] = integrals(share(gauges, i), from, to);
    for (std::size_t t = 0; t < gauges.time.size(); ++t) {
      sum.force[t] += force * gauges.pressure[i][t];
      sum.moment[t] += moment * gauges.pressure[i][t];
    }
  }
  return sum;
}

InterpolationError interpolation_error(const Gauges& gauges) {
  if (gauges.count() < 3) return {};
  const double from = gauges.place.front(), to = gauges.place.back();
  const Resultant all = resultant(gauges, from, to), some = resultant(every_other(gauges), from, to);
  const std::vector<double> sizes = resultant(sizes_of(gauges), from, to).force;
  std::size_t t = index_of_largest(all.force);
  const std::size_t busiest = index_of_largest(sizes);
  InterpolationError error;
  error.has_resultant = std::abs(all.force[t]) > least_resultant * sizes[busiest];
  if (!error.has_resultant) t = busiest;
  if (sizes[t] == 0.) return {};
  const double scale = error.has_resultant ? std::abs(all.force[t]) : least_resultant * sizes[t];
  error.time = gauges.time[t];
  error.force = std::abs(some.force[t] - all.force[t]) / scale / 3.;
  if (error.has_resultant && some.force[t] != 0.)
    error.arm = std::abs(some.moment[t] / some.force[t] - all.moment[t] / all.force[t]) / 3. / (to - from);
  return error;
}

NumberedWarnings gauge_warnings(const std::string& name, const Gauges& gauges, const std::vector<double>& total,
                                const std::optional<double>& end) {
  constexpr double tolerable = 0.05, tolerable_cell = 0.1;
  NumberedWarnings list;
  std::vector<RecordAtHeight> records;
  for (std::size_t i = 0; i < gauges.count(); ++i)
    records.push_back({gauges.place[i], {name + "." + gauges.name[i], gauges.time, gauges.pressure[i], end}});
  for (const RecordAtHeight& at : records) append(list, record_warnings(at.record));
  append(list, drop_warnings({name, gauges.time, sum_of_sizes(gauges), end}, list));
  join("record_too_coarse", "are sampled too coarsely", list);
  join("record_gap", "have it, too", list);
  join("record_dropout", "lost it, too", list);
  join("record_begun", "begin so, too", list);
  join("record_offset", "are so, too", list);
  join("record_cut", "are cut, too", list);
  join("record_saturated", "are at their end, too", list);
  append(list, swapped_records(records));
  if (const InterpolationError error = interpolation_error(gauges); error.force > tolerable)
    list.push_back(
        {"gauges_too_sparse", error.force, tolerable, "1",
         "the force by the " + std::to_string(gauges.count()) + " transducers of '" + name + "' may err by about " +
             significant(100. * error.force, 2) + " % " +
             (error.has_resultant ? "when it is largest, at t = " + significant(error.time) + " s, and its arm by " +
                                        significant(100. * error.arm, 2) + " % of the row's length"
                                  : "of a tenth of the integral of |p|, at t = " + significant(error.time) +
                                        " s (pressures of both signs cancel)") +
             ": the pressure is narrower than they see",
         "compare with a load cell (load_cell), or set transducers closer"});
  if (!gauges.load_cell.empty()) {
    const double cell = gauges.load_cell[index_of_largest(gauges.load_cell)], sum = total[index_of_largest(total)];
    if (const double error = std::abs(sum / cell - 1.); !(error <= tolerable_cell))
      list.push_back({"load_cell_differs", error, tolerable_cell, "1",
                      "the largest force by the transducers of '" + name + "' is " + significant(sum) +
                          " N/m, by the load cell " + significant(cell) + " N/m",
                      "look at units, heights and the row's ends, or at what the cell carries besides"});
  }
  return list;
}

}  // namespace upbead
