// What acts in a case until when: where its loads go on after the end, and the end of a case that gives none.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "upbead/base/numbered_warning.h"
#include "upbead/base/time_function.h"
#include "upbead/case/case.h"

namespace upbead {

/// A load, or an uplift, as corners over time: linear enough between them, constant after the last. A jump has two
/// values at one time.
struct Action {
  std::string name;            ///< "loads.wave", "sliding.uplift"
  std::string cut = {};        ///< the warning where the run ends before it
  std::string begins_by = {};  ///< the key that says when it begins
  std::vector<double> time = {}, value = {};
  bool swings = false;    ///< goes on for ever after the last corner, as a harmonic does
  bool trifling = false;  ///< hardly presses on the caisson beside others: nothing is lost where it is cut
};

/// What acts by one history; `half_period`: of one that swings for ever.
Action action_of(const std::string& name, const std::string& cut, const std::string& begins_by, const TimeFunction& f,
                 const std::optional<double>& half_period = {});

/// What acts by several values at equal times: the sum of their sizes, and nothing after them.
Action action_of(const std::string& name, const std::string& begins_by, const std::vector<double>& time,
                 const std::vector<std::vector<double>>& values);

std::vector<Action> actions_of(const Case& input);

/// When all that acts in a case is over, or has come to stay (s). What swings for ever counts for ten periods.
double end_of_actions(const Case& input);

/// Warnings load_zero, where nothing of a load is felt until `end`, and load_cut (wave_cut for a load by a wave), where
/// it changes after `end` by more than a twentieth of its largest value: docs/warnings.md. `key`: what gives the end.
NumberedWarnings end_warnings(const std::vector<Action>& actions, double end, const std::string& key = "time.end");

constexpr double rebound = 0.6;  ///< of a period by Dunkerley's rule, which is 1.25 times the true one and more: 3/4

/// Warning answer_cut: the run ends before a section of that period (s) has answered a load's last peak: most within
/// half a period after a short pulse (Chopra, Dynamics of Structures, ch. 4), and in the rebound within 3/4.
NumberedWarnings answer_warnings(const std::vector<Action>& actions, double end, double period,
                                 const std::string& key = "time.end");

/// Whether the case leaves its end to the loads.
bool end_is_open(const Case& input);

}  // namespace upbead
