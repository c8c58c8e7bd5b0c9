#include "base/version.h"
#include "output/checks.h"
#include "output/section_outputs.h"
#include "output/summary_outputs.h"
#include "output/versions.h"

namespace upbead {

namespace {

OutputSchema<Discretisation> discretisation_outputs() {
  using D = Discretisation;
  return OutputSchema<D>()
      .key("cells", &D::cells, "", "cells")
      .key("unknowns", &D::unknowns, "", "unknowns")
      .key("degree", &D::degree, "", "degree of the displacement")
      .key("scheme", &D::scheme, "", "scheme in time: `reduced`, or what marched")
      .key("time_step", &D::time_step, "s", "largest step")
      .key("steps", &D::steps, "", "steps")
      .key("solves", &D::solves, "", "solves")
      .key("factorisations", &D::factorisations, "", "factorisations")
      .key("processes", &D::processes, "", "processes: that shared the work");
}

OutputSchema<ShearResponse> forces_on_caisson_outputs() {
  using R = ShearResponse;
  return OutputSchema<R>()
      .key("peak_force", &R::peak_force, "N/m", "largest horizontal wave force on the caisson, landward: peak P")
      .key("peak_force_time", &R::peak_force_time, "s", "when")
      .key("peak_force_seaward", &R::peak_force_seaward, "N/m", "least P")
      .key("peak_force_seaward_time", &R::peak_force_seaward_time, "s", "when")
      .key("impulse", &R::impulse, "N s/m", "integral of P over the run")
      .key("peak_shear", &R::peak_shear, "N/m",
           "largest shear force at the bottom, landward, found inside the steps: peak F_T")
      .key("peak_shear_time", &R::peak_shear_time, "s", "when")
      .key("peak_shear_seaward", &R::peak_shear_seaward, "N/m",
           "largest shear force seaward: least F_T; in an undamped scene it may be the larger swing")
      .key("peak_shear_seaward_time", &R::peak_shear_seaward_time, "s", "when")
      .key("shear_to_force_ratio", &R::shear_to_force_ratio, "",
           "ratio of the peaks: peak F_T / peak P, landward, or seaward where the largest abs(P) is seaward; null "
           "where there is no P")
      .key("largest_displacement", &R::largest_displacement, "m",
           "displacement x_G of largest magnitude, with its sign: landward positive, of the centre of gravity")
      .key("largest_displacement_time", &R::largest_displacement_time, "s", "when")
      .key("peak_displacement", &R::peak_displacement, "m",
           "largest displacement x_G landward; `largest_displacement` may be a larger one seaward")
      .key("peak_rotation", &R::peak_rotation, "rad",
           "largest rotation landward; `largest_rotation` may be a larger one seaward")
      .key("largest_rotation", &R::largest_rotation, "rad", "rotation of largest magnitude, with its sign")
      .key("peak_shear_paper", &R::peak_shear_paper, "N/m",
           "largest P - m x_G'' of the caisson, the paper's reading; differs from `peak_shear` only where water is "
           "modelled")
      .key("peak_shear_experiment", &R::peak_shear_experiment, "N/m",
           "largest P + P_water,front - m x_G'', what the paper's experiment evaluates")
      .key("shear_to_impulse", &R::shear_to_impulse, "1/s",
           "the same peak F_T as in `shear_to_force_ratio` / impulse; null where there is none")
      .key(
          "arm", &R::arm, "m",
          "height of the force above the bottom when P is largest: of its line of action; null without horizontal load")
      .key("peak_base_moment", &R::peak_base_moment, "N m/m",
           "largest moment at the bottom, about its middle, landward")
      .key("largest_base_moment", &R::largest_base_moment, "N m/m", "the one of largest magnitude, with its sign")
      .key("reaction_mismatch", &R::reaction_mismatch, "",
           "largest difference of both routes to F_T over the largest abs(F_T), or, where that is less, over a "
           "millionth of the largest of abs(P), change of the normal force, uplift, and base moment over the bottom's "
           "width; round-off; above 1e-7 the next [way](reduced.md#the-ladder) is tried");
}

OutputSchema<ErrorEstimate> error_outputs() {
  using E = ErrorEstimate;
  return OutputSchema<E>()
      .key("mesh", &E::mesh, "", "part from the size of the cells")
      .key("time", &E::time, "", "part from the time steps of the march; 0 where a reduced model answers")
      .key("reduced_model", &E::reduced_model, "",
           "part from the limited number of vectors of the reduced model; 0 where it was marched")
      .key("far_boundary", &E::far_boundary, "", "part from waves that the far sides reflect");
}

std::string word_of_base(const Summary& s) {
  return s.contact && s.contact->solved ? "friction" : "bonded";
}

OutputSchema<Summary> response_outputs() {
  using S = Summary;
  const auto total = [](const std::optional<ErrorEstimate>& error) {
    return error ? std::optional(error->total()) : std::nullopt;
  };
  const auto mismatch = [](const S& s) { return s.energy ? std::optional(s.energy->mismatch()) : std::nullopt; };
  return OutputSchema<S>()
      .key(
          "caisson", [](const S& s) { return word_of_base(s); }, "",
          "`bonded`, or `friction` where it was followed node by node: that of all numbers here, of `base` and of the "
          "histories; those of `sliding` are of the bonded one")
      .keys_of(&S::response, forces_on_caisson_outputs())
      .key("energy_mismatch", mismatch, "",
           "work of the loads minus the sum of all energies stored and taken (the entries of `energy`), over the "
           "largest "
           "work; round-off; above 1e-6 the next way is tried; null where a reduced model answered")
      .key(
          "error_estimate", [total](const S& s) { return total(s.error); }, "",
          "relative error of `peak_shear`: the sum of `error_sources`, meant as an upper bound; null unless "
          "`mesh.refine = \"auto\"` or `accuracy.estimate = true` ([how it is found, how good it is](accuracy.md))")
      .object("error_sources", &S::error, error_outputs(), "where it comes from; null with it")
      .key(
          "history_error_estimate", [total](const S& s) { return total(s.history_error); }, "",
          "the same of F_T at any time, over its largest magnitude; the far sides are taken as given (`far_boundary` "
          "is 0; [`walls_too_near`](warnings.md#far-sides) warns of them); null with `error_estimate`")
      .object("history_error_sources", &S::history_error, error_outputs(), "where it comes from; null with it");
}

OutputSchema<MeasuredSummary> measured_outputs() {
  using M = MeasuredSummary;
  using C = Comparison;
  return OutputSchema<M>()
      .key("reading", &M::reading, "", "the history that it is compared with")
      .keys_of(&M::comparison,
               OutputSchema<C>()
                   .key("peak_measured", &C::peak_measured, "", "of largest magnitude, in the unit of the record")
                   .key("peak_computed", &C::peak_computed, "", "in the direction of the measured one, in that unit")
                   .key("peak_ratio", &C::peak_ratio, "", "computed over measured")
                   .key("rms", &C::rms, "", "root of the mean square of the difference, in that unit")
                   .key("rms_relative", &C::rms_relative, "", "that over the root of the mean square of the record")
                   .key("phase", &C::phase, "s", "time by which the computed history lags the record"));
}

OutputSchema<EnergyAccount> energy_outputs() {
  using E = EnergyAccount;
  return OutputSchema<E>()
      .key("work", &E::work, "J/m",
           "done by the loads, and by the reaction of a moving base on its velocity: the sum of the next ten")
      .key("kinetic", &E::kinetic, "J/m", "stored")
      .key("strain", &E::strain, "J/m", "stored")
      .key("fluid", &E::fluid, "J/m", "stored in compressed fluid and raised surfaces")
      .key("lifted", &E::lifted, "J/m",
           "stored where the caisson has parted from its ground: forces at rest times openings")
      .key("drag", &E::drag, "J/m", "taken by flow through the pores")
      .key("damping", &E::damping, "J/m", "taken by material damping, of motion relative to a base that is shaken")
      .key("radiated", &E::radiated, "J/m",
           "gone through absorbing sides, by motion relative to an outcrop that is shaken")
      .key("friction", &E::friction, "J/m", "taken at the bottom, by friction and where nodes close")
      .key("plastic", &E::plastic, "J/m", "taken by soil that yields")
      .key("scheme", &E::scheme, "J/m", "taken by the time scheme; may be negative")
      .key("mismatch", &E::mismatch, "", "`response.energy_mismatch`");
}

OutputSchema<ReductionSummary> reduction_outputs() {
  using R = ReductionSummary;
  const auto loose = [](const R& r) {
    Json object = Json::object();
    for (const LooseReading& reading : r.loose) object[reading.name] = reading.error;
    return object;
  };
  return OutputSchema<R>()
      .key("vectors", &R::vectors, "", "of the Krylov space")
      .key("modes", &R::modes, "", "modes")
      .key("error", &R::error, "", "of the history of F_T, over its peak")
      .key("error_peak", &R::error_peak, "", "of its peaks")
      .key("error_of_others", &R::error_of_others, "",
           "the largest of all other readings, each over its own largest value")
      .key("error_of_states", &R::error_of_states, "",
           "of the states that fields and strengths are made of: the root of the energy of the difference, over that "
           "of the largest state; null where the case asks for neither")
      .key("highest_frequency", &R::highest_frequency, "Hz", "highest frequency checked")
      .key("loose.NAME", loose, "",
           "the readings besides F_T that have not come close enough, with their error (only where the case asks for a "
           "reduced model)");
}

OutputSchema<BaseSummary> base_outputs() {
  using B = BaseSummary;
  return OutputSchema<B>()
      .key("heel_pressure_at_rest", &B::heel_pressure_at_rest, "Pa", "of the landward edge, before the wave")
      .key("toe_pressure_at_rest", &B::toe_pressure_at_rest, "Pa", "of the seaward edge, before the wave")
      .key("eccentricity_at_rest", &B::eccentricity_at_rest, "m", "of W', landward of the middle")
      .key(
          "peak_heel_pressure", &B::peak_heel_pressure, "Pa",
          "largest pressure of the landward edge in motion; null where the resultant leaves the base there: a bonded "
          "base pulls, a real one overturns or rocks. It is not the p_e for which limits of bearing pressure are made: "
          "that is in `checks`, by formulas")
      .key("peak_heel_pressure_time", &B::peak_heel_pressure_time, "s", "when, or when the resultant first leaves")
      .key("peak_toe_pressure", &B::peak_toe_pressure, "Pa", "the same of the seaward edge")
      .key("static_heel_pressure", &B::static_heel_pressure, "Pa",
           "largest pressure of the landward edge under the loads without motion: Goda's p_e where the load is Goda's; "
           "null where their resultant leaves the base")
      .key("static_toe_pressure", &B::static_toe_pressure, "Pa", "the same of the seaward edge")
      .key("peak_toe_pressure_time", &B::peak_toe_pressure_time, "s", "when")
      .key("largest_eccentricity", &B::largest_eccentricity, "m", "e = M'/N' of largest magnitude, landward positive")
      .key("largest_eccentricity_time", &B::largest_eccentricity_time, "s", "when")
      .key("least_normal_force", &B::least_normal_force, "N/m", "least N'")
      .key("least_normal_force_time", &B::least_normal_force_time, "s", "when")
      .key("least_overturning_margin", &B::least_overturning_margin, "",
           "least of (moment of W' - U)/(moment of all that the wave does), about the heel or the toe: Goda's safety "
           "factor against overturning where nothing moves; null where nothing overturns")
      .key("least_overturning_margin_time", &B::least_overturning_margin_time, "s", "when")
      .key("lifts_time", &B::lifts_time, "s",
           "when an edge first has no pressure: from then on a base that cannot pull parts from its mound there, and "
           "one that is bonded pulls; with friction node by node when a node opens; null where both edges always press")
      .reason("lifts", &B::lifts, "which edge that is: `seaward`, `landward`, or `all`; null with it")
      .key("peak_computed_pressure", &B::peak_computed_pressure, "Pa",
           "largest effective stress under a node of the base, as solved; **no pressure to judge by**: at the edges of "
           "a "
           "rigid base it is singular and grows with finer cells; without friction node by node on stresses at "
           "rest that are linear, and without a prescribed uplift; null unless `output.base = true` or contact was "
           "solved")
      .key("peak_computed_pressure_at", &B::peak_computed_pressure_at, "m", "x of that node")
      .key("peak_computed_pressure_time", &B::peak_computed_pressure_time, "s", "when")
      .key("limit", &B::limit, "Pa",
           "of heel and toe pressure in motion, `limits.dynamic_base_pressure`; null where none is given");
}

OutputSchema<HarbourSummary> harbour_outputs() {
  using H = HarbourSummary;
  return OutputSchema<H>()
      .key("front", &H::front, "m", "height y of still water in front of the caisson")
      .key("back", &H::back, "m", "and behind it")
      .key("push", &H::push, "N/m", "of both on the caisson at rest, landward")
      .key("weight_gained", &H::weight_gained, "N/m",
           "by which W' is more than that in water as high as the higher level; in no other number");
}

OutputSchema<NaturalPeriod> period_outputs() {
  using P = NaturalPeriod;
  return OutputSchema<P>()
      .key("period", &P::period, "s", "of the free swing")
      .key("damping_ratio", &P::damping_ratio, "", "of critical")
      .key("share", &P::share, "",
           "of its largest contribution to F_T under these loads in the sum of those of all modes that swing");
}

OutputSchema<SoilSummary> soil_outputs() {
  using S = SoilSummary;
  return OutputSchema<S>()
      .key("iterations", &S::iterations, "", "iterations")
      .key("converged", &S::converged, "", "settled: whether the last change was below 1 %")
      .key("change", &S::change, "", "of the peak of abs(F_T) in the last one, relative")
      .key("peak_linear", &S::linear, "N/m",
           "largest abs(F_T) with stiffness and damping at vanishing strain; without a caisson a strain, as `peak`")
      .key("peak", &S::settled, "N/m", "largest abs(F_T), settled")
      .key("largest_strain", &S::largest_strain, "", "largest effective strain")
      .key("least_modulus_ratio", &S::least_modulus_ratio, "", "least stiffness over that at vanishing strain")
      .key("largest_damping", &S::largest_damping, "", "largest damping ratio");
}

OutputSchema<ResidualSummary> residual_outputs() {
  using R = ResidualSummary;
  const auto left = [](const R& r) { return r.pore_pressure ? std::optional(r.pore_pressure->value) : std::nullopt; };
  const auto left_at = [](const R& r) { return r.pore_pressure ? std::optional(r.pore_pressure->at) : std::nullopt; };
  return OutputSchema<R>()
      .key("displacement_x", &R::displacement_x, "m", "of the centre of gravity, landward")
      .key("displacement_y", &R::displacement_y, "m", "upward; settlement is negative")
      .key("rotation", &R::rotation, "rad", "positive when the top moved landward")
      .key("pore_pressure", left, "Pa",
           "excess pore pressure of largest magnitude in the soil at the end; null where no soil has pore water")
      .key("pore_pressure_at[]", left_at, "m", "where that is; null with it");
}

OutputSchema<StartBound> bound_outputs() {
  using B = StartBound;
  return OutputSchema<B>()
      .key("start", &B::start, "", "`virgin`, `k0` or `gravity`")
      .key("peak_shear", &B::peak_shear, "N/m", "peak F_T from there")
      .key("shear_to_force_ratio", &B::shear_to_force_ratio, "", "that over peak P; null where there is no P")
      .object(
          "residual", [](const B& b) { return &b.residual; }, residual_outputs(), "of the caisson at the end");
}

OutputSchema<RestSummary> rest_outputs() {
  using R = RestSummary;
  return OutputSchema<R>()
      .key("steps", &R::steps, "", "in which weights were put on")
      .key("iterations", &R::iterations, "", "of Newton's method in them, each with a factorisation")
      .key("share_at_strength", &R::share_at_strength, "", "of the area of this soil: where its strength is reached")
      .key("out_of_balance", &R::out_of_balance, "", "forces out of balance over the weights");
}

OutputSchema<SafetySummary> safety_outputs() {
  using S = SafetySummary;
  return OutputSchema<S>()
      .key("lower", &S::lower, "",
           "largest factor at which a state at rest was found; null where none was with up to 16 times its strength")
      .key("upper", &S::upper, "",
           "smallest factor at which it was shown that there is none; null where it stands with a twentieth of its "
           "strength, "
           "or nothing was shown")
      .key("fails_at", &S::fails_at, "", "where it shears most as it fails; empty where it does not")
      .reason("why_open", &S::why_open,
              "why the bounds are more than 0.5 % apart, or missing; null where they are not");
}

OutputSchema<PeakStrain> peak_strain_outputs() {
  using P = PeakStrain;
  return OutputSchema<P>()
      .key("peak_strain", &P::value, "", "largest shear strain of a cell that may yield, at its middle, at any time")
      .key("peak_strain_at[]", &P::at, "m", "where that is")
      .key(
          "peak_strain_over_neighbours", &P::over_neighbours, "",
          "that over the mean of the cells beside it: [above 3](warnings.md#soil-that-yields) a slip line is as narrow "
          "as the cells; null where these do not yield");
}

OutputSchema<MobilisedRegion> mobilised_region_outputs() {
  using R = MobilisedRegion;
  return OutputSchema<R>()
      .key("region", &R::region, "", "its name")
      .key("law", &R::law, "", "`hysteretic` or `mohr_coulomb`")
      .key("initial", &R::initial, "",
           "largest share of its strength that a cell mobilises at rest, by its law; 1: all")
      .key("initial_share", &R::initial_share, "", "share of the area that mobilises all of it at rest")
      .key("largest", &R::largest, "", "largest share at any time")
      .key("at[]", &R::at, "m", "where that is")
      .key("time", &R::time, "s", "and when")
      .key("share", &R::share, "", "share of the area that mobilises all of it at some time");
}

OutputSchema<NonlinearSummary> nonlinear_outputs() {
  using N = NonlinearSummary;
  return OutputSchema<N>()
      .key("start", &N::start, "", "what hysteretic soil bears at rest: `initial.start`; `static` where there is none")
      .key("stages", &N::stages, "", "solves of a stage of a step")
      .key("iterations", &N::iterations, "", "updates of all stresses in them")
      .key("factorisations", &N::factorisations, "", "of the elastic matrix")
      .key("cut_steps", &N::cut_steps, "", "steps that were halved, as a stage did not converge")
      .key(
          "share_skipped", &N::share_skipped, "",
          "of the updates of cells' stresses: left out, as since the last step the strain had changed by less than any "
          "soil of the cell needs to yield")
      .key("share_yielded", &N::share_yielded, "", "of the area of soil that may yield: where it lost energy")
      .key("share_beyond_at_rest", &N::share_beyond_at_rest, "",
           "of that area: where it starts from the stress of the elastic ground and that exceeds its strength; nothing "
           "in the model bears the excess, and the soil starts at its strength")
      .object(
          "rest", &N::rest, rest_outputs(),
          "how Mohr-Coulomb soil came to rest; null without any, and where no rest within its strength was found: then "
          "it starts from the elastic stress, as hysteretic soil does, and `void` says so")
      .reason("why_no_rest", &N::why_no_rest,
              "why Mohr-Coulomb soil has no state at rest, and where it gives way; null where it has, and without any")
      .keys_of(&N::peak_strain, peak_strain_outputs())
      .list("regions[]", &N::regions, mobilised_region_outputs(), "strength that each region mobilised")
      .list("bounds[]", &N::bounds, bound_outputs(), "from the other starts; empty unless `initial.bounds`");
}

OutputSchema<CompactedSoil> densification_outputs() {
  using C = CompactedSoil;
  return OutputSchema<C>()
      .key("region", &C::region, "", "its name")
      .key("mean", &C::mean, "", "volumetric strain by cycles of shear, over the area")
      .key("largest", &C::largest, "", "the largest")
      .key("at[]", &C::at, "m", "where that is")
      .key("largest_amplitude", &C::largest_amplitude, "", "of shear strain in a half cycle")
      .key("reversals", &C::reversals, "", "most of a point")
      .key("largest_pressure_ratio", &C::largest_pressure_ratio, "",
           "largest r_u at any time, 1 where no stress is left: mean effective stress lost over that at rest, which is "
           "pore pressure over it where the total stress stays")
      .key("pressure_ratio_at[]", &C::pressure_ratio_at, "m", "where that is")
      .key("pressure_ratio_at_end", &C::pressure_ratio_at_end, "", "largest r_u at the end of the run")
      .key("share_liquefied", &C::share_liquefied, "", "share of the area where r_u came to 0.95")
      .key("left_out", &C::left_out, "", "share of the area that is left out of r_u: free surfaces")
      .key("pressure_at_end", &C::pressure_at_end, "Pa",
           "largest excess pore pressure at the end of the run; null where the region is drained")
      .key("energy", &C::energy, "J/m", "taken by compaction, a part of `energy.plastic`");
}

OutputSchema<MobilisedStrength> strength_outputs() {
  using S = MobilisedStrength;
  return OutputSchema<S>()
      .key("region", &S::region, "", "its name")
      .key("initial", &S::initial, "", "largest mobilisation at rest; 1: yield, 10: more")
      .key("initial_share", &S::initial_share, "", "share of the area where it exceeds 1 at rest")
      .key("largest", &S::largest, "", "largest mobilisation at any time")
      .key("at[]", &S::at, "m", "where that is")
      .key("time", &S::time, "s", "and when")
      .key("share", &S::share, "", "share of the area where it exceeds 1 at some time")
      .key("left_out", &S::left_out, "", "share of the area that is left out: free surfaces");
}

OutputSchema<Timing> timing_outputs() {
  using T = Timing;
  return OutputSchema<T>()
      .key("mesh", &T::mesh, "s", "meshing")
      .key("compile", &T::compile, "s", "making M, C, K and loads")
      .key("factorise", &T::factorise, "s", "factorising")
      .key("march", &T::march, "s", "marching, or reducing and answering")
      .key("output", &T::output, "s", "writing")
      .key("total", &T::total, "s", "since the start of the program");
}

OutputSchema<LadderStep> ladder_outputs() {
  return OutputSchema<LadderStep>()
      .key("way", &LadderStep::way, "", "its name")
      .reason("refused", &LadderStep::refused, "why it was refused; null of the last one, which was taken");
}

std::optional<std::string> no_periods(const Summary& summary) {
  const std::string why = why_no_periods(summary);
  return why.empty() ? std::nullopt : std::make_optional(why);
}

/// What was checked, may be wrong, was tried and was left out.
OutputSchema<Summary> lists_outputs() {
  using S = Summary;
  return OutputSchema<S>()
      .list("checks[]", &S::checks, check_outputs(),
            "of the section by all routes: strength at rest, sliding, friction, pressure of heel and toe, overturning; "
            "but for the first empty without a "
            "caisson")
      .list("strength[]", &S::strength, strength_outputs(), "of each region with a [strength](warnings.md#strength)")
      .list("warnings[]", &S::warnings, warning_outputs(), "[what may be wrong](warnings.md) though nothing failed")
      .list("ladder[]", &S::ladder, ladder_outputs(),
            "the [ways](reduced.md#the-ladder) that were tried, in their order")
      .list("skipped[]", &S::skipped, skipped_outputs(), "each thing that was left out");
}

OutputSchema<Summary> whole_outputs() {
  using S = Summary;
  const auto of_caisson = [](const S& s) { return s.response ? &s : nullptr; };
  return OutputSchema<S>()
      .key("title", &S::title, "", "that of the case")
      .program()
      .object("verdict", &S::verdict, verdict_outputs(), "what all checks say together; null without any")
      .object("discretisation", &S::discretisation, discretisation_outputs(), "how the scene was solved")
      .object("response", of_caisson, response_outputs(), "null where the mesh has no surface `caisson`")
      .named("loads.NAME", &S::loads, &LoadOnCaisson::name, load_outputs(),
             "resultant on the caisson per unit of the history")
      .named("flows.NAME", &S::flows, &FlowSummary::name, flow_outputs(), "of a load [from a CFD program](cfd.md)")
      .named("gauges.NAME", &S::gauges, &GaugeSummary::name, gauge_outputs(),
             "of a load by [transducers](records.md), or `sliding.uplift`")
      .named("wave_loads.NAME", &S::waves, &WaveLoadSummary::name, wave_load_outputs(),
             "of a load by a [wave](waves.md#a-wave-as-a-load-of-a-run)")
      .named("measured.NAME", &S::measured, &MeasuredSummary::name, measured_outputs(),
             "of a [record](records.md#the-response) of `[measured]`")
      .object("energy", &S::energy, energy_outputs(), "at the end; null where a reduced model answered")
      .object("reduction", &S::reduction, reduction_outputs(),
              "[how far two nested models lie apart](reduced.md); null where the case was marched")
      .list("periods[]", &S::periods, period_outputs(),
            "natural periods of ground and bonded caisson that F_T takes part in, largest share first, from 1 %; "
            "modes damped by more than 0.7 of critical do not swing; empty where no reduced model was made")
      .key("no_periods", no_periods, "", "why `periods` is empty; null where it is not, and without a caisson")
      .object("sliding", &S::sliding, sliding_outputs(),
              "with `[sliding]` in the case, else null. Eq. numbers are those of Shimosako and Takahashi (1994); F_S = "
              "F_T + mu U. In `sliding_coupled` alone the slip acts back on the scene; for all other numbers F_T is "
              "that of a caisson bonded to its mound")
      .object("harbour", &S::harbour, harbour_outputs(),
              "still water at two levels ([harbour_level](warnings.md)); null where it has one")
      .object("base", &S::base, base_outputs(),
              "[what presses on the base](contact.md#base-pressure): effective, stress varying linearly over the width "
              "in contact, at the ends of the steps; null where neither `[sliding]` nor the water level gives W'")
      .object("contact", &S::contact, contact_outputs(),
              "[slip and uplift node by node](contact.md); null where the bottom is bonded")
      .object("soil", &S::soil, soil_outputs(), "of soil that follows the strain; else null")
      .object("nonlinear", &S::nonlinear, nonlinear_outputs(), "of [soil that yields](yielding.md); else null")
      .object("residual", &S::residual, residual_outputs(),
              "where the caisson came to rest at the end of the run; null where no soil yields")
      .list("densification[]", &S::densification, densification_outputs(), "[denser soils](yielding.md#densification)")
      .object("safety", &S::safety, safety_outputs(),
              "factor by which [strength may fall at rest](yielding.md#strength-reduction), if asked for by "
              "`initial.safety` or "
              "`limits.safety`, and where Mohr-Coulomb soil found no rest; else null")
      .reason("void", &S::why_void,
              "why nothing here that was marched is of a section that stands: its ground [has no state at "
              "rest](yielding.md#ground-that-does-not-stand); null where it has")
      .keys_of([](const S& s) -> const S& { return s; }, lists_outputs())
      .object("timing", &S::timing, timing_outputs(), "wall times")
      .versions();
}

}  // namespace

std::string why_no_periods(const Summary& summary) {
  if (!summary.periods.empty() || !summary.response) return "";
  if (summary.reduction) return "no mode that swings has 1 % of F_T";
  return "they are the poles of a reduced model, and this scene was marched; where one converges time.scheme = "
         "\"reduced\" tells them";
}

OutputSchema<LoadOnCaisson> load_outputs() {
  using L = LoadOnCaisson;
  return OutputSchema<L>()
      .key("force_x", &L::force_x, "N/m", "landward")
      .key("force_y", &L::force_y, "N/m", "upward")
      .key("moment", &L::moment, "N m/m", "about the bottom's middle")
      .key("arm", &L::arm, "m", "height above the bottom; null without horizontal force");
}

OutputSchema<GaugeSummary> gauge_outputs() {
  using G = GaugeSummary;
  return OutputSchema<G>()
      .key("gauges", &G::gauges, "", "how many")
      .key("samples", &G::samples, "", "how many")
      .key("interval", &G::interval, "s", "between samples, mean")
      .key("peak_gauge", &G::peak_gauge, "", "transducer with the largest pressure")
      .key("peak_pressure", &G::peak_pressure, "Pa", "largest pressure")
      .key("peak_pressure_time", &G::peak_pressure_time, "s", "when")
      .key("peak_pressure_at", &G::peak_at, "m", "where")
      .key("peak_force", &G::peak_force, "N/m", "largest force")
      .key("peak_force_time", &G::peak_force_time, "s", "when")
      .key("arm", &G::arm, "m",
           "height of the largest force above the bottom; for an uplift its distance landward of the bottom's middle")
      .key("force_error", &G::force_error, "", "relative error of the force by interpolation")
      .key("arm_error", &G::arm_error, "", "error of the arm by interpolation, over the row's length")
      .key("load_cell", &G::load_cell, "N/m", "largest force by the load cell; null without");
}

OutputSchema<FlowSummary> flow_outputs() {
  using F = FlowSummary;
  return OutputSchema<F>()
      .key("layout", &F::layout, "", "what was read")
      .key("files", &F::files, "", "how many")
      .key("samples", &F::samples, "", "how many")
      .key("begin", &F::begin, "s", "of the record, in the run's time")
      .key("end", &F::end, "s", "of the record, in the run's time")
      .key("thickness", &F::thickness, "m",
           "length of breakwater that its forces belong to; null where it holds pressures")
      .key("peak_force", &F::peak_force, "N/m",
           "largest force over still water, landward; of pressures their sum along the line of points")
      .key("peak_force_time", &F::peak_force_time, "s", "when")
      .key("arm", &F::arm, "m",
           "height of the largest force above the centre of moments, or above the lowest end of the points; null "
           "without either")
      .key("still_force", &F::still_force, "N/m", "force of still water, which was subtracted")
      .key("difference", &F::difference, "",
           "largest difference of the sum of the pressures and the forces of `against`, over the largest force; null "
           "without `against`")
      .key("told", &F::told, "", "how the files were understood, in sentences");
}

OutputSchema<WaveLoadSummary> wave_load_outputs() {
  using W = WaveLoadSummary;
  return OutputSchema<W>()
      .key("course", &W::course, "", "`church_roof`, `triangle`, `sine`, `combined` or `standing`")
      .key("height", &W::height, "m", "H")
      .key("significant_height", &W::significant_height, "m", "H_1/3")
      .key("period", &W::period, "s", "T")
      .key("angle", &W::angle, "degrees", "beta")
      .key("wavelength", &W::wavelength, "m", "L")
      .key("alpha_1", &W::alpha_1, "", "of Goda's formula")
      .key("alpha_2", &W::alpha_2, "", "of Goda's formula")
      .key("alpha_I", &W::alpha_I, "", "as its formula says, negative or not")
      .key("alpha_star", &W::alpha_star, "", "alpha*")
      .key("eta_star", &W::eta_star, "m", "eta*")
      .key("p1", &W::p1, "Pa", "p_1, with alpha*")
      .key("p3", &W::p3, "Pa", "p_3, with alpha*")
      .key("p4", &W::p4, "Pa", "p_4, with alpha*")
      .key("pu", &W::pu, "Pa", "p_u")
      .key("force", &W::force, "N/m", "P, with alpha*, as `waves` gives it")
      .key("force_moment", &W::force_moment, "N m/m", "of P about the bottom's level")
      .key("uplift", &W::uplift, "N/m", "U, as `waves` gives it")
      .key("peak", &W::peak, "N/m", "largest P of the load, with its factor")
      .key("trough_force", &W::trough_force, "N/m", "least P of a standing wave, seaward; null of other courses")
      .key("peak_uplift", &W::peak_uplift, "N/m",
           "largest U of `[sliding.uplift]` of kind wave, with the load's factor")
      .key("rise", &W::rise, "s", "of the impulsive part; of a sine that of the whole")
      .key("duration", &W::duration, "s", "of the impulsive part; of a sine that of the whole")
      .key("standing_force", &W::standing_force, "N/m", "peak of the slow part, gamma P_1; 0 where there is none")
      .key("impulse", &W::impulse, "N s/m", "integral of P over the course")
      .key("end", &W::end, "s", "when the course is over")
      .key("peak_over_goda", &W::peak_over_goda, "",
           "`peak` over P by Goda's formulas with alpha*; a load below 1 is milder than what `waves` has; null where "
           "that "
           "P is 0")
      .keys_of(&W::stability, stability_outputs())
      .key("sliding_exact", &W::sliding, "m",
           "S of Goda's P with alpha* by eqs. (4), (6), tau_0 = k(alpha*) tau_0F: by formulas, without the ground")
      .object("standing", inner(&W::standing, &StandingResult::answer), standing_outputs(),
              "the standing wave of finite height before the wall; null where there is none")
      .key("why_no_standing", inner(&W::standing, &StandingResult::why_not), "", "why; empty where there is one")
      .key("assumptions[]", &W::assumptions, "", "what the load rests on, in words");
}

OutputSchema<Skipped> skipped_outputs() {
  return OutputSchema<Skipped>()
      .key("what", &Skipped::what, "", "its name")
      .key("why", &Skipped::why, "", "why it was left out");
}

const OutputSchema<Summary>& summary_outputs() {
  static const OutputSchema<Summary> schema = whole_outputs();
  return schema;
}

std::string to_json(const Summary& summary) {
  Summary told = summary;
  if (!told.checks.empty()) told.verdict = verdict_of(told.checks, told.warnings);
  return summary_outputs().text(told);
}

}  // namespace upbead
