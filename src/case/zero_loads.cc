#include <algorithm>

#include "base/text.h"
#include "case_warnings.h"

namespace upbead {

namespace {

/// First time at which a function of time is not zero, by its samples and its kinks; none where it never is.
std::optional<double> first_action(const TimeFunction& f) {
  std::vector<double> times = f.samples().empty() ? f.kinks() : f.samples();
  const std::vector<double>& kinks = f.kinks();
  for (std::size_t i = 0; f.samples().empty() && i + 1 < kinks.size(); ++i)
    times.push_back(0.5 * (kinks[i] + kinks[i + 1]));  // a pulse is smooth between its kinks
  std::sort(times.begin(), times.end());
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double before = i > 0 ? times[i - 1] : times[i] - 1.;
    if (f(times[i]) != 0. || f(times[i], 0.5 * (before + times[i])) != 0.) return before;
  }
  return f(kinks.empty() ? 0. : kinks.back() + 1.) != 0. ? std::optional(0.) : std::nullopt;
}

NumberedWarning zero_load(const std::string& name, const std::optional<double>& from, double end) {
  const std::string when = from ? "is zero until t = " + significant(*from, 4) + " s, after the end of the run at " +
                                      significant(end, 4) + " s"
                                : "is zero throughout";
  return {"load_zero", from.value_or(end), end, "s",
          "'" + name + "' " + when +
              ": nothing of it is felt; look at its columns and units, at record_start, or give a longer time.end"};
}

/// When the first of some transducers sees something (s).
std::optional<double> first_action(const Gauges& gauges) {
  for (std::size_t t = 0; t < gauges.time.size(); ++t)
    for (const std::vector<double>& pressure : gauges.pressure)
      if (pressure[t] != 0.) return t > 0 ? gauges.time[t - 1] : gauges.time[t];
  return std::nullopt;
}

}  // namespace

NumberedWarnings zero_load_warnings(const Case& input) {
  NumberedWarnings list;
  const double end = input.scene.time.end;
  const auto look = [&](const std::string& name, const std::optional<double>& from) {
    if (!from || *from >= end) list.push_back(zero_load(name, from, end));
  };
  for (const auto& [name, source] : input.sources)
    if (const Load& load = input.scene.loads.at(name); load.factor != 0.)
      look("loads." + name, first_action(load.history));
  for (const auto& [name, by] : input.gauges)
    if (by.load.factor != 0.) look("loads." + name, first_action(by.gauges));
  if (!input.uplift_history.empty()) look("sliding.uplift", first_action(input.scene.sliding->uplift->history));
  return list;
}

}  // namespace upbead
