#include "case/time_end.h"

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "case/cfd/flow_source.h"
#include "case/wave_load.h"
#include "case/wave_train.h"

namespace upbead {

namespace {

constexpr int parts = 32;               ///< of a smooth piece
constexpr int periods = 10;             ///< of what swings for ever
constexpr double over = 1e-3;           ///< of the largest value: less is no load any more
constexpr double tolerable_cut = 0.05;  ///< of the largest value

/// Samples and kinks, and times between the kinks of a pulse, which is smooth there.
std::vector<double> times_of(const TimeFunction& f) {
  std::vector<double> times = f.samples();
  const std::vector<double>& kinks = f.kinks();
  times.insert(times.end(), kinks.begin(), kinks.end());
  for (std::size_t i = 0; f.samples().empty() && i + 1 < kinks.size(); ++i)
    for (int part = 1; part < parts; ++part) times.push_back(kinks[i] + (kinks[i + 1] - kinks[i]) * part / parts);
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

/// `half_period`: of what swings for ever.
void add_course(const TimeFunction& f, const std::optional<double>& half_period, Action& action) {
  const std::vector<double> times = times_of(f);
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double before = i > 0 ? 0.5 * (times[i - 1] + times[i]) : times[i] - 1.;
    for (const double value : {f(times[i], before), f(times[i])}) {
      action.time.push_back(times[i]);
      action.value.push_back(value);
    }
  }
  if (times.empty() || !half_period) return;
  const double last = times.back();
  action.swings = f(last + 0.3 * *half_period) != f(last + 0.7 * *half_period) ||
                  f(last + 0.3 * *half_period) != f(last + 1.1 * *half_period);
  for (int i = 1; action.swings && i <= 2 * periods * parts; ++i) {
    action.time.push_back(last + i * *half_period / parts);
    action.value.push_back(f(action.time.back()));
  }
}

/// The sum of the sizes of several values at equal times, and nothing after them.
void add_sum(const std::vector<double>& time, const std::vector<const std::vector<double>*>& values, Action& action) {
  action.time = time;
  action.value.assign(time.size(), 0.);
  for (const auto* one : values)
    for (std::size_t t = 0; t < one->size(); ++t) action.value[t] += std::abs((*one)[t]);
  if (time.empty()) return;
  action.time.push_back(time.back());
  action.value.push_back(0.);
}

Action action_of(const Gauges& gauges, const std::string& name) {
  Action action{name, "load_cut", "record_start"};
  std::vector<const std::vector<double>*> pressures;
  for (const std::vector<double>& pressure : gauges.pressure) pressures.push_back(&pressure);
  add_sum(gauges.time, pressures, action);
  return action;
}

double largest_of(const Action& action) {
  double largest = 0.;
  for (const double value : action.value) largest = std::max(largest, std::abs(value));
  return largest;
}

/// When it begins (s); none where it is always zero.
std::optional<double> begin_of(const Action& action) {
  for (std::size_t i = 0; i < action.time.size(); ++i)
    if (action.value[i] != 0.) return action.time[i > 0 ? i - 1 : 0];
  return std::nullopt;
}

double end_of(const Action& action) {
  if (action.time.empty()) return 0.;
  if (action.swings) return action.time.back();
  const double least = over * largest_of(action);
  for (std::size_t i = action.time.size(); i-- > 1;)
    if (std::abs(action.value[i - 1] - action.value.back()) > least) return action.time[i];
  return action.time.front();
}

/// What happens after the end of the run.
struct Rest {
  double change = 0.;     ///< largest difference to the value at the end, over the largest value of all
  double share = 0.;      ///< largest value until the end, over the largest value of all
  double peak_time = 0.;  ///< of the largest value of all (s)
};

Rest rest_of(const Action& action, double end) {
  Rest rest;
  double at_end = 0., until = 0., all = 0.;
  for (std::size_t i = 0; i < action.time.size(); ++i) {
    const double t = action.time[i], v = action.value[i];
    if (std::abs(v) > all) rest.peak_time = t;
    all = std::max(all, std::abs(v));
    if (t <= end) {
      at_end = v;
    } else if (i > 0 && action.time[i - 1] <= end) {
      at_end += (v - at_end) * (end - action.time[i - 1]) / (t - action.time[i - 1]);
      until = std::max(until, std::abs(at_end));
    }
    if (t <= end) until = std::max(until, std::abs(v));
    if (t > end * (1. + 1e-9)) rest.change = std::max(rest.change, std::abs(v - at_end));
  }
  if (all > 0.) rest.change /= all;
  if (all > 0.) rest.share = until / all;
  return rest;
}

NumberedWarning zero_load(const Action& action, const std::optional<double>& from, double end) {
  const std::string when =
      from ? "is zero until t = " + significant(*from, 4) + " s, the run ends at " + significant(end, 4) + " s"
           : "is zero throughout";
  return {"load_zero",
          from.value_or(end),
          end,
          "s",
          "'" + action.name + "' " + when + ": nothing of it is felt",
          "look at the columns and units of the load, " +
              (from ? "give time.end after it or leave time.end out, or let it begin earlier by " + action.begins_by
                    : "and at " + action.begins_by)};
}

NumberedWarning cut_load(const Action& action, const Rest& rest, double end) {
  const double until = end_of(action);
  std::string text = "'" + action.name + "' acts until " + significant(until, 4) + " s, the run ends at " +
                     significant(end, 4) + " s: the rest of it is not felt";
  if (rest.share < 1. - over)
    text += ", nor is ITS LARGEST VALUE, which comes at " + significant(rest.peak_time, 4) +
            " s: until the end it has " + significant(100. * rest.share, 2) +
            " % of that, and no peak of this run is one of the whole load";
  return {action.cut, until, end,
          "s",        text,  "give a longer time.end, or leave time.end out, which covers all loads and their echo"};
}

}  // namespace

std::vector<Action> actions_of(const Case& input) {
  std::vector<Action> list;
  for (const auto& [name, source] : input.sources) {
    const Load& load = input.scene.loads.at(name);
    if (load.factor == 0.) continue;
    list.push_back({"loads." + name, "load_cut", source.pulse ? "pulse.start" : "record_start"});
    const bool harmonic = source.pulse && source.pulse->shape == PulseShape::harmonic;
    add_course(load.history, harmonic ? load.duration : std::nullopt, list.back());
  }
  for (const auto& [name, wave] : acting_waves(input)) {
    list.push_back({"loads." + name, "wave_cut", "its period"});
    add_course(wave->history, {}, list.back());
  }
  for (const auto& [name, by] : input.gauges)
    if (by.load.factor != 0.) list.push_back(action_of(by.gauges, "loads." + name));
  for (const auto& [name, by] : input.flows) {
    const std::optional<FlowHistory>& force = by.flow->force;
    if (by.load.factor == 0. || !force) continue;
    list.push_back({"loads." + name, "load_cut", "flow_start"});
    add_sum(force->time, {&force->landward, &force->up}, list.back());
  }
  for (const auto& [name, by] : input.trains)
    if (by->load.factor != 0.) {
      list.push_back({"loads." + name, "load_cut", "growth"});
      add_course(input.scene.loads.at(name + ".cosine").history, 0.5 * by->train.period, list.back());
    }
  if (!input.uplift_history.empty()) {
    list.push_back({"sliding.uplift", "load_cut", "record_start"});
    add_course(input.scene.sliding->uplift->history, {}, list.back());
  }
  if (input.uplift_gauges) list.push_back(action_of(input.uplift_gauges->gauges, "sliding.uplift"));
  return list;
}

double end_of_actions(const Case& input) {
  double end = 0.;
  for (const Action& action : actions_of(input)) end = std::max(end, end_of(action));
  return end;
}

NumberedWarnings end_warnings(const Case& input, double end) {
  NumberedWarnings list;
  for (const Action& action : actions_of(input)) {
    const std::optional<double> from = begin_of(action);
    const Rest rest = rest_of(action, end);
    if (!from || *from >= end)
      list.push_back(zero_load(action, from, end));
    else if (!action.swings && rest.change > tolerable_cut)
      list.push_back(cut_load(action, rest, end));
  }
  return list;
}

bool end_is_open(const Case& input) {
  return input.document.find("time.end") == nullptr;
}

}  // namespace upbead
