#include "standing_table.h"

#include "base/text.h"
#include "upbead/waves/edge_pressures.h"

namespace upbead {

std::vector<std::string> standing_head() {
  return {"wave", "L", "crest", "trough", "P", "U", "S.F. sliding", "p_e", "P seaward", "S.F. sliding", "p_toe"};
}

std::vector<std::string> standing_row(const std::string& name, const StandingAnswer& a, const Limits& limits) {
  std::vector<std::string> row{name};
  for (const double value : {a.wavelength, a.worst.crest, a.worst.trough, a.worst.landward.force / 1e3,
                             a.worst.landward.uplift / 1e3, a.landward.safety_sliding})
    row.push_back(significant(value, 4));
  row.push_back(judged_heel(a.landward, limits));
  for (const double value : {a.worst.seaward.force / 1e3, a.seaward.safety_sliding})
    row.push_back(significant(value, 4));
  row.push_back(judged_heel(a.seaward, limits));
  return row;
}

std::string judged_heel(const Stability& s, const Limits& limits) {
  return (s.heel_pressure ? significant(*s.heel_pressure / 1e3, 4) : "none") +
         (too_much_pressure(s, limits) ? "!" : "");
}

bool too_much_pressure(const Stability& s, const Limits& limits) {
  return limits.base_pressure && above_all(s.heel_pressure) > *limits.base_pressure;
}

bool overturns_too_easily(const Stability& s, const Limits& limits) {
  return limits.overturning && s.safety_overturning < *limits.overturning;
}

}  // namespace upbead
