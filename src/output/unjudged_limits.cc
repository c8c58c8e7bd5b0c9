#include "output/unjudged_limits.h"

#include <algorithm>
#include <string>
#include <vector>

namespace upbead {

namespace {

/// A limit, and how the names of the checks that judge it begin.
struct LimitRow {
  const char* key;
  std::optional<double> Limits::*limit;
  const char* unit;
  bool is_least, of_run;
  std::vector<std::string> names;
  const char* why;
};

const std::vector<LimitRow>& limit_rows() {
  using L = Limits;
  static const char* const no_base = "no part knows N', F_T and M' of the base: give [mesh], [loads.NAME] and W'";
  static const char* const no_strength = "no run of regions with a strength was made";
  static const char* const no_wave = "no wave was computed by formulas: give [section] and [waves.NAME]";
  static const char* const stays =
      "nothing that stays was computed: no region has a law by which soil yields, and there is no [cycles]";
  static const std::vector<LimitRow> rows{
      {"sliding",
       &L::sliding,
       "m",
       false,
       false,
       {"sliding distance", "expected sliding distance", "displacement with the ground"},
       "no part found a sliding distance"},
      {"base_pressure", &L::base_pressure, "Pa", false, false, {"heel pressure p_e", "toe pressure p_e"}, no_wave},
      {"dynamic_base_pressure",
       &L::dynamic_base_pressure,
       "Pa",
       false,
       true,
       {"heel pressure in motion", "toe pressure in motion"},
       no_base},
      {"overturning", &L::overturning, "", true, false, {"overturning", "margin against overturning"}, no_wave},
      {"safety", &L::safety, "", true, true, {"strength at rest"}, no_strength},
      {"circles", &L::circles, "", true, true, {"slip circles"}, no_strength},
      {"peak_safety", &L::peak_safety, "", true, true, {"strength at the peak"}, no_strength},
      {"liquefaction", &L::liquefaction, "", true, true, {"momentary liquefaction"}, "no run was made"},
      {"sliding_factor", &L::sliding_factor, "", true, false, {"sliding by formulas"}, no_wave},
      {"seaward_sliding_factor", &L::seaward_sliding_factor, "", true, false, {"sliding seaward by formulas"}, no_wave},
      {"settlement", &L::settlement, "m", false, true, {"settlement"}, stays},
      {"tilt", &L::tilt, "rad", false, true, {"tilt"}, stays},
      {"pressure_ratio", &L::pressure_ratio, "", false, true, {"residual pore pressure"}, "there is no [cycles]"},
      {"lives_beyond",
       &L::lives_beyond,
       "",
       false,
       false,
       {"share of lives"},
       "no lives were drawn: give [life] and [limits] sliding"}};
  return rows;
}

bool judges(const Check& check, const LimitRow& row) {
  const auto begins = [&](const std::string& name) { return check.name.rfind(name, 0) == 0; };
  const bool says = check.holds || !check.why_not.empty();
  return says && std::any_of(row.names.begin(), row.names.end(), begins);
}

}  // namespace

Checks unjudged_limits(const Limits& limits, const Checks& checks, bool of_run) {
  Checks list;
  for (const LimitRow& row : limit_rows()) {
    const std::optional<double>& limit = limits.*row.limit;
    if (!limit || (of_run && !row.of_run)) continue;
    if (std::any_of(checks.begin(), checks.end(), [&](const Check& check) { return judges(check, row); })) continue;
    Check check = check_of(row.names.front(), row.unit, {}, std::string("limits.") + row.key, "");
    check = row.is_least ? at_least_as(check, limit) : at_most(check, limit);
    list.push_back(not_checked(check, row.why));
  }
  return list;
}

}  // namespace upbead
