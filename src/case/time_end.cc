#include "case/time_end.h"

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "case/load_source.h"

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

/// When it last comes near its largest value (s), where it may stay.
double last_peak_of(const Action& action) {
  constexpr double near = 0.9;
  const double least = near * largest_of(action);
  double last = 0.;
  for (std::size_t i = 0; i < action.time.size(); ++i)
    if (std::abs(action.value[i]) >= least && (i == 0 || std::abs(action.value[i - 1]) < least)) last = action.time[i];
  return last;
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

NumberedWarning zero_load(const Action& action, const std::optional<double>& from, double end, const std::string& key) {
  const std::string when =
      from ? "is zero until t = " + significant(*from, 4) + " s, the run ends at " + significant(end, 4) + " s"
           : "is zero throughout";
  return {
      "load_zero",
      from.value_or(end),
      end,
      "s",
      "'" + action.name + "' " + when + ": nothing of it is felt",
      "look at the columns and units of the load, " +
          (from ? "give " + key + " after it or leave " + key + " out, or let it begin earlier by " + action.begins_by
                : "and at " + action.begins_by),
      true};
}

NumberedWarning cut_load(const Action& action, const Rest& rest, double end, const std::string& key) {
  const double until = end_of(action);
  std::string text = "'" + action.name + "' acts until " + significant(until, 4) + " s, the run ends at " +
                     significant(end, 4) + " s: the rest of it is not felt";
  if (rest.share < 1. - over)
    text += ", nor is ITS LARGEST VALUE, which comes at " + significant(rest.peak_time, 4) +
            " s: until the end it has " + significant(100. * rest.share, 2) +
            " % of that, and no peak of this run is one of the whole load";
  return {action.cut,
          until,
          end,
          "s",
          text,
          "give a longer " + key + ", or leave " + key + " out, which covers all loads and their echo",
          rest.share < 1. - over};
}

}  // namespace

Action action_of(const std::string& name, const std::string& cut, const std::string& begins_by, const TimeFunction& f,
                 const std::optional<double>& half_period) {
  Action action{name, cut, begins_by};
  const std::vector<double> times = times_of(f);
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double before = i > 0 ? 0.5 * (times[i - 1] + times[i]) : times[i] - 1.;
    for (const double value : {f(times[i], before), f(times[i])}) {
      action.time.push_back(times[i]);
      action.value.push_back(value);
    }
  }
  if (times.empty() || !half_period) return action;
  const double last = times.back();
  action.swings = f(last + 0.3 * *half_period) != f(last + 0.7 * *half_period) ||
                  f(last + 0.3 * *half_period) != f(last + 1.1 * *half_period);
  for (int i = 1; action.swings && i <= 2 * periods * parts; ++i) {
    action.time.push_back(last + i * *half_period / parts);
    action.value.push_back(f(action.time.back()));
  }
  return action;
}

Action action_of(const std::string& name, const std::string& begins_by, const std::vector<double>& time,
                 const std::vector<std::vector<double>>& values) {
  Action action{name, "load_cut", begins_by, time, std::vector<double>(time.size(), 0.)};
  for (const std::vector<double>& one : values)
    for (std::size_t t = 0; t < one.size(); ++t) action.value[t] += std::abs(one[t]);
  if (time.empty()) return action;
  action.time.push_back(time.back());
  action.value.push_back(0.);
  return action;
}

std::vector<Action> actions_of(const Case& input) {
  std::vector<Action> list;
  for (const LoadSource* source : sources_of(input))
    if (source->action) list.push_back(*source->action);
  return list;
}

double end_of_actions(const Case& input) {
  double end = 0.;
  for (const Action& action : actions_of(input)) end = std::max(end, end_of(action));
  return end;
}

NumberedWarnings end_warnings(const std::vector<Action>& actions, double end, const std::string& key) {
  NumberedWarnings list;
  for (const Action& action : actions) {
    const std::optional<double> from = begin_of(action);
    const Rest rest = rest_of(action, end);
    if (!from || *from >= end)
      list.push_back(zero_load(action, from, end, key));
    else if (!action.swings && !action.trifling && rest.change > tolerable_cut)
      list.push_back(cut_load(action, rest, end, key));
  }
  return list;
}

NumberedWarnings answer_warnings(const std::vector<Action>& actions, double end, double period,
                                 const std::string& key) {
  const Action* last = nullptr;
  double answered = end;
  for (const Action& action : actions) {
    if (action.swings || action.trifling) continue;
    const std::optional<double> from = begin_of(action);
    if (!from || *from >= end || rest_of(action, end).change > tolerable_cut) continue;  // told as load_zero, load_cut
    const double until = last_peak_of(action) + rebound * period;
    if (until <= answered) continue;
    answered = until;
    last = &action;
  }
  if (last == nullptr) return {};
  return {{"answer_cut", answered, end, "s",
           "the run ends at " + significant(end, 4) + " s, but the caisson swings with a period of about " +
               significant(period, 3) + " s, so that it answers '" + last->name + "' most, and rebounds, until " +
               significant(answered, 3) +
               " s: forces, pressures, margins and S may be larger after the end, and are not judged",
           "give " + key + " = " + significant(answered, 3) + " or more, or leave " + key +
               " out, which covers all loads and their echo",
           true}};
}

bool end_is_open(const Case& input) {
  return input.document.find("time.end") == nullptr;
}

}  // namespace upbead
