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

namespace {

OutputSchema<TroughBound> trough_bound_outputs() {
  using T = TroughBound;
  return OutputSchema<T>()
      .key("force", &T::force, "N/m", "P, seaward positive")
      .key("force_moment", &T::force_moment, "N m/m", "of it about the bottom's level")
      .key("safety_sliding", inner(&T::seaward, &Stability::safety_sliding), "",
           "against sliding seaward, without the suction under the base")
      .key("safety_overturning", inner(&T::seaward, &Stability::safety_overturning), "", "about the toe")
      .key("toe_pressure", inner(&T::seaward, &Stability::heel_pressure), "Pa",
           "p_e, under the seaward edge; null where the caisson overturns");
}

OutputSchema<StandingAnswer> standing_answer_outputs() {
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

}  // namespace

OutputSchema<StandingResult> standing_outputs() {
  using R = StandingResult;
  return OutputSchema<R>()
      .object("standing", &R::answer, standing_answer_outputs(),
              "the standing wave of finite height before the wall; null where there is none")
      .key("why_no_standing", &R::why_not, "", "why; empty where there is one")
      .object("trough_bound", &R::bound, trough_bound_outputs(),
              "a bound of the trough, after Sainflou (1928), where there is none; null where there is one");
}

OutputSchema<BreakingImpact> impact_outputs() {
  using I = BreakingImpact;
  return OutputSchema<I>()
      .key("relative_mound", &I::relative_mound, "", "(h - d)/h, h_b* of the parameter map")
      .key("relative_height", &I::relative_height, "", "H_1/3/h, H_s* of the parameter map")
      .key("relative_berm", &I::relative_berm, "", "B_eq/L, B* of the parameter map")
      .key("breaker", &I::breaker, "m", "H_b, from which a wave breaks on the wall; an assumption")
      .key("breaker_before", &I::breaker_before, "m", "height from which it breaks before; an assumption")
      .key("share", &I::share, "", "of the waves of the sea that are between these heights, after Rayleigh")
      .key("breaks", &I::breaks, "", "whether H is at least H_b")
      .key("relative_peak", &I::relative_peak, "", "F* of the quantile; an assumption")
      .key("peak", &I::peak, "N/m", "F* rho g H_b^2")
      .key("median_peak", &I::median_peak, "N/m", "the same of the middle F*")
      .key(
          "sr443", &I::sr443, "N/m",
          "15 rho g h^2 (H_1/3/h)^3.134, mean of the highest 1/250 of the forces (Allsop, Vicinanza and McKenna 1996), "
          "as another measure; an assumption; null beyond 0.35 < H_1/3/h < 0.6");
}

}  // namespace upbead
