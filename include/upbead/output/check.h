// The checks of a section, by whatever route: demand against capacity; and the verdict that they make together.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "upbead/base/numbered_warning.h"

namespace upbead {

/// The way to fail that a check is about, in the order of the sheet.
enum class FailureMode {
  strength,
  slip_circles,
  momentary_liquefaction,
  residual_pressure,
  sliding,
  sliding_seaward,
  sliding_distance,
  overturning,
  overturning_seaward,
  heel_pressure,
  toe_pressure,
  settlement,
  tilt,
  failure_of_life,  ///< by its probability
  other             ///< one of its own, called as the check
};

/// What a factor of safety compares.
struct Balance {
  double acting = 0., resisting = 0.;
  std::string unit;  ///< of both
};

/// One check of a section: demand against capacity.
struct Check {
  FailureMode mode = FailureMode::other;
  std::string name;                ///< "sliding distance", "heel pressure p_e"; says nothing to the program
  std::string limit;               ///< the key of [limits] that it is held to, given or not; "": to none of them
  std::string unit;                ///< of demand and capacity
  std::optional<double> demand;    ///< none: beyond what can be computed, or not checked
  std::optional<double> capacity;  ///< none: not given
  /// Above 1 where the check holds: capacity over demand, or, for a quantity that must not fall below its limit, demand
  /// over capacity. None without a capacity, or where there is no demand.
  std::optional<double> margin;
  std::optional<bool> holds;       ///< none without a capacity, or where it was not checked
  std::string measure;             ///< the key of the summary, and what it means
  std::string assumption;          ///< that the check relies on; "" where there is none to mention
  std::string by{"dynamics"};      ///< the route: formulas, dynamics (of the solved scene), statics
  std::string wave;                ///< the load or wave that demands it; "": all loads of the scene
  std::string level;               ///< of still water, at which it is worst; "": that of the section
  std::string why_not;             ///< it was not checked; "" where it was
  bool has_rival = false;          ///< formulas and dynamics both judge this: with one mode they should agree
  bool at_least = false;           ///< whether the demand must not fall below the capacity
  std::optional<Balance> balance;  ///< of a demand that is a factor: what acts and what resists, where they are known
  std::optional<double> probability;  ///< of a demand that is a reliability index: of failure
};

using Checks = std::vector<Check>;

/// What all checks say together. It is drawn from them and from the warnings whenever it is told, so that it cannot
/// differ from them.
struct Verdict {
  std::optional<bool> holds;       ///< none: no check has a limit, or the verdict is void
  std::string text;                ///< one sentence, the governing check first
  std::optional<Check> governing;  ///< the worst of those with a limit
  int failing = 0, checked = 0;    ///< checks that fail, and those with a limit
  int unjudged = 0;                ///< limits that were given, and could not be checked
  std::string why_void;            ///< a warning says that no verdict may be drawn; "" where none does
};

}  // namespace upbead
