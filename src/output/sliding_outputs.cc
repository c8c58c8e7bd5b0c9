#include "output/sliding_outputs.h"

namespace upbead {

namespace {

OutputSchema<Slip> slip_outputs() {
  return OutputSchema<Slip>()
      .key("start", &Slip::start, "s", "when it starts")
      .key("stop", &Slip::stop, "s", "when it stops or turns")
      .key("distance", &Slip::distance, "m", "landward positive")
      .key("peak_velocity", &Slip::peak_velocity, "m/s", "largest velocity on the way");
}

OutputSchema<HistorySliding> forces_outputs() {
  using H = HistorySliding;
  return OutputSchema<H>()
      .key("resistance", &H::resistance, "N/m", "mu W'")
      .key("peak_sliding_force", &H::peak_force, "N/m", "F_Smax")
      .key("peak_sliding_force_time", &H::peak_force_time, "s", "when")
      .key("shear_at_peak", &H::shear_at_peak, "N/m", "F_T then")
      .key("uplift_at_peak", &H::uplift_at_peak, "N/m", "U then")
      .key("peak_sliding_force_seaward", &H::peak_seaward, "N/m", "largest -F_T + mu U, which slides it seaward")
      .key("peak_sliding_force_seaward_time", &H::peak_seaward_time, "s", "when")
      .key(
          "peak_force_on_normal", &H::peak_on_normal, "N/m",
          "largest F_T minus mu times the change of N', by U and by the caisson's vertical motion: held to mu W' where "
          "the ground shakes")
      .key("peak_force_seaward_on_normal", &H::peak_seaward_on_normal, "N/m", "the same of -F_T")
      .key("ratio", &H::ratio, "", "r = F_Smax / (mu W')")
      .key("least_normal_force", &H::least_normal_force, "N/m",
           "least N' = W' - U + change of the normal force; below 0 the caisson would lift");
}

OutputSchema<HistorySliding> distances_outputs() {
  using H = HistorySliding;
  return OutputSchema<H>()
      .key("sliding_history", inner(&H::by_history, &Sliding::residual), "m",
           "S by eq. (4) on F_T(t) and U(t): where the caisson comes to rest")
      .key("sliding_history_largest", inner(&H::by_history, &Sliding::largest), "m", "largest distance on the way")
      .list("slips[]", inner(&H::by_history, &Sliding::slips), slip_outputs(), "each slip")
      .key("sliding_normal_force", inner(&H::with_normal_force, &Sliding::residual), "m",
           "as `sliding_history`, friction acting on N' with the caisson's vertical motion");
}

OutputSchema<DesignSliding> design_outputs() {
  using D = DesignSliding;
  return OutputSchema<D>()
      .key("value", &D::value, "m", "S to design by")
      .key("measure", &D::measure, "",
           "key of this S: the measure that models most of the mechanics, among those that the scene allows")
      .key("why", &D::why, "", "why this one")
      .key("error_estimate", &D::error_estimate, "m", "its own; null where there is none")
      .key("largest", &D::largest, "m", "of largest magnitude on the way, by the same measure")
      .key("end_velocity", &D::end_velocity, "m/s",
           "of its slip when the run ends; 0 of `sliding_coupled`, which is followed until the caisson rests under the "
           "loads of the end")
      .key("rests", &D::rests, "",
           "whether the loads at the end of the run let the caisson come to rest; false: `value` and all other S are "
           "only how far it came until then, and have no bound")
      .reason("why_not_all", &D::why_not_all,
              "why the value is not the whole distance though it will rest: with all its friction it would slide on by "
              "more than 1 %; else null");
}

OutputSchema<UpliftCourses> course_outputs() {
  using U = UpliftCourses;
  return OutputSchema<U>()
      .key("held", &U::held, "m", "U follows P up to the largest P, then stays at its peak")
      .key("in_phase", &U::in_phase, "m", "U follows P");
}

OutputSchema<CoupledSummary> coupled_outputs() {
  using C = CoupledSummary;
  return OutputSchema<C>()
      .key("largest", inner(&C::slip, &Sliding::largest), "m", "largest distance on the way")
      .list("slips[]", inner(&C::slip, &Sliding::slips), slip_outputs(), "each slip")
      .key("dissipated", &C::dissipated, "J/m", "energy taken by friction")
      .key("peak_shear", &C::peak_shear, "N/m", "F_T of largest magnitude")
      .key("least_normal", &C::least_normal, "N/m", "least N'")
      .key("lifted_time", &C::lifted_time, "s", "time in which N' would have been negative")
      .key("vectors", &C::vectors, "", "of its reduced model; 0 where the bonded caisson does not reach mu N'")
      .key("error", &C::error, "", "difference of the forces between nested models, over their largest values")
      .key("glued_error", &C::glued_error, "", "error of F_T while the caisson sticks, over its peak")
      .key("growth", &C::growth, "1/s",
           "of the fastest vibration that friction feeds ([flutter](contact.md#flutter)); 0: none")
      .key("damping_time", &C::damping_time, "s",
           "beta of the damping beta K that was added against flutter: its damping ratio is omega beta/2")
      .key("damping_effect", &C::damping_effect, "m", "change of S where that damping is doubled")
      .key("error_estimate", &C::error_estimate, "m",
           "of S by cells and errors of F_T; null where that of `sliding` is");
}

OutputSchema<EqualImpulse> impulse_outputs() {
  using E = EqualImpulse;
  return OutputSchema<E>()
      .key("tau_0", &E::duration, "s", "its duration")
      .key("sliding_paper", &E::paper, "m", "S by eq. (7)")
      .key("sliding_exact", &E::exact, "m", "S integrated");
}

OutputSchema<PulseSliding> pulse_outputs() {
  using P = PulseSliding;
  const auto parts = [](const P& p) { return Json{p.paper_parts.accelerating, p.paper_parts.braking}; };
  return OutputSchema<P>()
      .key("tau_0F", &P::standing_duration, "s",
           "of `[sliding.wave]`, eqs. (8)-(11); null without that table, as the next five")
      .key("k", &P::factor, "", "k(alpha*)")
      .key("tau_0", &P::duration, "s", "k tau_0F")
      .key("sliding_paper", &P::paper, "m", "S_CAL: eq. (7) with F_Smax and tau_0")
      .key("sliding_paper_parts[]", parts, "m",
           "its parts S_1 (until F_S has fallen to mu W') and S_2 (braking without F_S)")
      .key("sliding_exact", &P::exact, "m",
           "eqs. (4) and (6) integrated, same pulse: 1.94 times eq. (7) at r = 1, 1.12 times at r = 3");
}

OutputSchema<HistoryDuration> duration_outputs() {
  using D = HistoryDuration;
  return OutputSchema<D>()
      .key("ratio", &D::ratio, "", "r")
      .key("sliding", &D::sliding, "m", "S at this r")
      .key("by_paper", &D::by_paper, "s",
           "of the pulse that slides as far by eq. (7); null where it has no value, as the next three")
      .key("by_exact", &D::by_exact, "s", "of the pulse that slides as far, integrated")
      .key("by_excess", &D::by_excess, "s", "total time above mu W', over (1 - 1/r)")
      .key("by_impulse", &D::by_impulse, "s", "twice the impulse of the lobe with the peak, over the peak");
}

}  // namespace

OutputSchema<SlidingSummary> sliding_outputs() {
  using S = SlidingSummary;
  const auto coupled_slip = [](const S& s) {
    return s.coupled ? std::optional(s.coupled->slip.residual) : std::nullopt;
  };
  return OutputSchema<S>()
      .key(
          "caisson", [](const S&) { return "bonded"; }, "",
          "`bonded`: F_T, F_Smax and S by eq. (4) are of the bonded caisson, also in a run with friction node by node, "
          "whose own peak F_T is `response.peak_shear` and whose S is `contact.solved.slip`")
      .key("friction", &S::friction, "", "mu")
      .key("weight", &S::weight, "N/m", "W")
      .key("submerged_weight", &S::submerged_weight, "N/m", "W'")
      .key("buoyant_weight", &S::submerged_weight, "N/m", "the same, by its older name")
      .key("drag", &S::drag, "N s/m2", "F_D over the velocity")
      .key("uplift", &S::uplift, "", "`none`, `prescribed` or `computed`")
      .object("design", &S::design, design_outputs(),
              "the S to design by; the other measures show how much S depends on what is modelled")
      .keys_of(&S::history, forces_outputs())
      .keys_of(&S::history, distances_outputs())
      .key("error_estimate", &S::error_estimate, "m",
           "[upper bound of the error](accuracy.md) of `sliding_history`; null where `response.error_estimate` is")
      .reason("why_no_error_estimate", &S::why_no_estimate, "why `error_estimate` is null; else null")
      .key("sliding_coupled", coupled_slip, "m",
           "S of a caisson that slides as a rigid block on the moving ground, in the end; 0 where the bonded caisson "
           "does not reach mu N'; null where it cannot be computed")
      .reason("why_not_coupled", &S::why_not_coupled, "why `sliding_coupled` is null; null where it is not")
      .object("coupled", &S::coupled, coupled_outputs(), "details of `sliding_coupled`; null with it")
      .object("uplift_courses", &S::courses, course_outputs(),
              "`sliding_history` under two assumed courses of U(t), which shows how much the assumption matters; null "
              "unless the uplift is prescribed by its peak")
      .keys_of(&S::pulse, pulse_outputs())
      .object("equal_impulse", &S::equal_impulse, impulse_outputs(),
              "the triangular pulse of the same peak and impulse as F_S; null where F_S is nowhere landward")
      .object("duration", inner(&S::history, &HistorySliding::own), duration_outputs(),
              "tau_0 *of this history* at its own r: of the triangular pulse of equal peak; null where F_S is nowhere "
              "landward")
      .list("duration_table[]", inner(&S::history, &HistorySliding::table), duration_outputs(),
            "the same against mu W' = F_Smax / r for r = 1.05 to 2: tau_0 is no property of the history alone");
}

}  // namespace upbead
