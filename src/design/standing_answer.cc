#include "standing_answer.h"

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

WavePressure resultants(const WallPressure& at, double width) {
  WavePressure p;
  p.force = std::abs(at.force);
  p.force_moment = std::abs(at.force_moment);
  p.pu = std::max(at.edge_pressure, 0.);
  p.uplift = at.uplift;
  p.uplift_moment = 2. / 3. * at.uplift * width;
  return p;
}

/// The section seen from the sea: its heel is the toe.
Section mirrored(Section section) {
  if (section.centroid) section.centroid = section.width - *section.centroid;
  return section;
}

}  // namespace

StandingResult standing_answer(const Section& section, const Water& water, const DesignWave& wave) {
  if (wave.angle != 0.) return {{}, "the wave does not come straight at the wall"};
  if (section.dissipating_blocks) return {{}, "wave-dissipating blocks leave no standing wave"};
  try {
    const StandingWave standing({section.water_depth, wave.height, wave.period}, water);
    StandingAnswer a{standing.wavelength(), standing.residual(), standing_extremes(standing, section), {}, {}};
    a.landward = stability(section, resultants(a.worst.landward, section.width));
    WallPressure trough = a.worst.seaward;
    trough.uplift = trough.edge_pressure = 0.;
    a.seaward = stability(mirrored(section), resultants(trough, section.width));
    return {a, ""};
  } catch (const NumericsError& error) {
    return {{}, error.what()};
  }
}

OutputSchema<StandingAnswer> standing_outputs() {
  using A = StandingAnswer;
  const auto landward = [](auto member) { return inner(&A::worst, &StandingExtremes::landward, member); };
  const auto seaward = [](auto member) { return inner(&A::worst, &StandingExtremes::seaward, member); };
  return OutputSchema<A>()
      .key("wavelength", &A::wavelength, "m", "L, which depends on H")
      .key("residual", &A::residual, "", "of the conditions at the surface, over 2H")
      .key("crest", inner(&A::worst, &StandingExtremes::crest), "m", "of the surface at the wall, above still water")
      .key("trough", inner(&A::worst, &StandingExtremes::trough), "m", "likewise")
      .key("force", landward(&WallPressure::force), "N/m", "largest P")
      .key("force_moment", landward(&WallPressure::force_moment), "N m/m", "of it about the bottom's level")
      .key("pu", landward(&WallPressure::edge_pressure), "Pa", "then at the bottom's seaward edge")
      .key("uplift", landward(&WallPressure::uplift), "N/m", "U then")
      .key("safety_sliding", inner(&A::landward, &Stability::safety_sliding), "", "against sliding landward")
      .key("safety_overturning", inner(&A::landward, &Stability::safety_overturning), "", "about the heel")
      .key("heel_pressure", inner(&A::landward, &Stability::heel_pressure), "Pa", "p_e")
      .key("trough_force", seaward(&WallPressure::force), "N/m", "least P, seaward")
      .key("trough_moment", seaward(&WallPressure::force_moment), "N m/m", "of it about the bottom's level")
      .key("trough_safety_sliding", inner(&A::seaward, &Stability::safety_sliding), "",
           "against sliding seaward, without the suction under the base")
      .key("trough_safety_overturning", inner(&A::seaward, &Stability::safety_overturning), "", "about the toe")
      .key("toe_pressure", inner(&A::seaward, &Stability::heel_pressure), "Pa",
           "under the seaward edge, in the trough");
}

std::vector<std::string> standing_head() {
  return {"wave", "L", "crest", "trough", "P", "U", "S.F. sliding", "p_e", "P seaward", "S.F. sliding", "p_toe"};
}

std::vector<std::string> standing_row(const std::string& name, const StandingAnswer& a, const Limits& limits) {
  std::vector<std::string> row{name};
  for (const double value : {a.wavelength, a.worst.crest, a.worst.trough, a.worst.landward.force / 1e3,
                             a.worst.landward.uplift / 1e3, a.landward.safety_sliding, a.landward.heel_pressure / 1e3,
                             a.worst.seaward.force / 1e3, a.seaward.safety_sliding, a.seaward.heel_pressure / 1e3})
    row.push_back(significant(value, 4));
  if (too_much_pressure(a.landward, limits)) row[7] += "!";
  if (too_much_pressure(a.seaward, limits)) row.back() += "!";
  return row;
}

double severity_of_heel(const Stability& s) {
  return s.safety_overturning > 1. && s.safety_sliding > 0. ? s.heel_pressure : HUGE_VAL;
}

bool too_much_pressure(const Stability& s, const Limits& limits) {
  return limits.base_pressure && severity_of_heel(s) > *limits.base_pressure;
}

bool overturns_too_easily(const Stability& s, const Limits& limits) {
  return limits.overturning && s.safety_overturning < *limits.overturning;
}

}  // namespace upbead
