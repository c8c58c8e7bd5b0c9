#include "output/limits.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <string>

namespace upbead {

namespace {

/// A limit, and the check that would judge it.
struct LimitRow {
  const char* key;
  std::optional<double> Limits::*limit;
  const char* unit;
  bool is_least, of_run;
  FailureMode mode;
  const char *check, *why_not;
};

constexpr const char
    *no_base = "no part knows N', F_T and M' of the base: give [mesh], [loads.NAME] and W'",
    *no_strength = "no run of regions with a strength was made",
    *no_wave =
        "formulas alone judge it, and no wave was computed by them: give a load kind = \"wave\", or [section] "
        "and [waves.NAME]",
    *stays =
        "nothing that stays was computed: no region has a law by which soil yields, and there is "
        "no [cycles]",
    *no_lives = "no lives were drawn: give [life] and [limits] sliding";

constexpr LimitRow limit_rows[] = {
    {"sliding", &Limits::sliding, "m", false, true, FailureMode::sliding_distance, "sliding distance",
     "no part found a sliding distance: a run needs [sliding] with friction and submerged_weight"},
    {"base_pressure", &Limits::base_pressure, "Pa", false, true, FailureMode::heel_pressure, "heel pressure p_e",
     "no part knows W' and the loads on the base: give a run [sliding] and loads, or [section] and [waves.NAME]"},
    {"dynamic_base_pressure", &Limits::dynamic_base_pressure, "Pa", false, true, FailureMode::heel_pressure,
     "heel pressure in motion", no_base},
    {"overturning", &Limits::overturning, "", true, false, FailureMode::overturning, "overturning", no_wave},
    {"safety", &Limits::safety, "", true, true, FailureMode::strength, "strength at rest", no_strength},
    {"circles", &Limits::circles, "", true, true, FailureMode::slip_circles, "slip circles", no_strength},
    {"peak_safety", &Limits::peak_safety, "", true, true, FailureMode::strength, "strength at the peak", no_strength},
    {"liquefaction", &Limits::liquefaction, "", true, true, FailureMode::momentary_liquefaction,
     "momentary liquefaction", "no run was made"},
    {"sliding_factor", &Limits::sliding_factor, "", true, true, FailureMode::sliding, "sliding by formulas", no_wave},
    {"seaward_sliding_factor", &Limits::seaward_sliding_factor, "", true, true, FailureMode::sliding_seaward,
     "sliding seaward by formulas", no_wave},
    {"settlement", &Limits::settlement, "m", false, true, FailureMode::settlement, "settlement", stays},
    {"tilt", &Limits::tilt, "rad", false, true, FailureMode::tilt, "tilt", stays},
    {"pressure_ratio", &Limits::pressure_ratio, "", false, true, FailureMode::residual_pressure,
     "residual pore pressure", "there is no [cycles]"},
    {"lives_beyond", &Limits::lives_beyond, "", false, true, FailureMode::sliding_distance, "share of lives",
     no_lives}};

const LimitRow& row_of(std::optional<double> Limits::*limit) {
  const auto found = std::find_if(std::begin(limit_rows), std::end(limit_rows),
                                  [limit](const LimitRow& row) { return row.limit == limit; });
  assert(found != std::end(limit_rows));
  return *found;
}

/// Whether it judges that limit, or says why it does not.
bool judges(const Check& check, const LimitRow& row) {
  return check.limit == row.key && (check.holds || !check.why_not.empty());
}

}  // namespace

Check held_to(Check check, const Limits& limits, std::optional<double> Limits::*limit,
              const std::optional<double>& natural) {
  const LimitRow& row = row_of(limit);
  const std::optional<double>& capacity = limits.*limit ? limits.*limit : natural;
  check.limit = row.key;
  return row.is_least ? at_least_as(check, capacity) : at_most(check, capacity);
}

Checks unjudged_limits(const Limits& limits, const Checks& checks, bool of_run) {
  Checks list;
  for (const LimitRow& row : limit_rows) {
    if (!(limits.*row.limit) || (of_run && !row.of_run)) continue;
    if (std::any_of(checks.begin(), checks.end(), [&](const Check& check) { return judges(check, row); })) continue;
    const Check check = check_of(row.mode, row.check, row.unit, {}, std::string("limits.") + row.key, "");
    list.push_back(not_checked(held_to(check, limits, row.limit), row.why_not));
  }
  return list;
}

}  // namespace upbead
