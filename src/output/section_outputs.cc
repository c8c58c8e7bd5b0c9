#include "output/section_outputs.h"

namespace upbead {

OutputSchema<Stability> stability_outputs() {
  using S = Stability;
  return OutputSchema<S>()
      .key("safety_sliding", &S::safety_sliding, "", "safety factor against sliding, with alpha_I")
      .key("safety_overturning", &S::safety_overturning, "", "safety factor against overturning, with alpha_I")
      .key("heel_pressure", &S::heel_pressure, "Pa",
           "p_e, under the landward edge, with alpha_I; null where the caisson overturns or floats")
      .key("toe_pressure", &S::heel_pressure, "Pa", "the same: the heel's, by the name of older versions");
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
      .key("heel_pressure", inner(&A::landward, &Stability::heel_pressure), "Pa",
           "p_e, under the landward edge; null where the caisson overturns or floats")
      .key("trough_force", seaward(&WallPressure::force), "N/m", "least P, seaward")
      .key("trough_moment", seaward(&WallPressure::force_moment), "N m/m", "of it about the bottom's level")
      .key("trough_safety_sliding", inner(&A::seaward, &Stability::safety_sliding), "",
           "against sliding seaward, without the suction under the base")
      .key("trough_safety_overturning", inner(&A::seaward, &Stability::safety_overturning), "", "about the toe")
      .key("toe_pressure", inner(&A::seaward, &Stability::heel_pressure), "Pa",
           "p_e, under the seaward edge, in the trough; null likewise");
}

}  // namespace upbead
