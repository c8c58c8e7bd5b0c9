// Soil that yields: what it cost, how far it yielded, where the caisson came to rest, denser soils.
#include <cmath>
#include <functional>

#include "base/text.h"
#include "fem/compile.h"
#include "findings/topics.h"
#include "output/limits.h"
#include "response/compaction.h"

namespace upbead {

namespace {

/// Largest difference from where a motion ends.
double moved(double end, const std::array<double, 2>& range) {
  return std::max(range[1] - end, end - range[0]);
}

double moved_x(const ResidualSummary& r) {
  return moved(r.displacement_x, r.range_x);
}

double moved_y(const ResidualSummary& r) {
  return moved(r.displacement_y, r.range_y);
}

double moved_rotation(const ResidualSummary& r) {
  return moved(r.rotation, r.range_rotation);
}

double largest_of(const std::array<double, 2>& range) {
  return std::max(std::abs(range[0]), std::abs(range[1]));
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
      .key("pore_pressure_at[]", left_at, "m", "where that is; null with it")
      .key("moved_x", moved_x, "m",
           "largest difference of `displacement_x` in the last fifth of the run from its value at the end: about 0 "
           "where "
           "the motion has ended")
      .key("moved_y", moved_y, "m", "the same of `displacement_y`")
      .key("moved_rotation", moved_rotation, "rad", "the same of `rotation`");
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
           "of that area: where the ground cannot carry the weights as elastic ground would: it starts at its "
           "strength, and "
           "the stress beyond that is left out")
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

std::optional<NonlinearSummary> find_nonlinear(const Evidence& e) {
  return e.solution.yielding ? std::optional(e.solution.yielding->found) : std::nullopt;
}

std::vector<CompactedSoil> find_densification(const Evidence& e) {
  return e.solution.yielding ? e.solution.yielding->densification : std::vector<CompactedSoil>();
}

/// Beyond this strain the geometry of the small-strain equations errs by as much as results may, some percent.
constexpr double large_strain = 0.05;
/// Beyond this one they err by more than a tenth, as `submerged_weight` may: ground that shears so much has failed, or
/// is far from where its equations are.
constexpr double too_large_strain = 0.1;
/// slip_line: strain of a cell over that of the cells beside it, a choice; a smooth strain reaches 2 or 3 on coarse
/// cells. least_strain: below a tenth of a percent no result depends on one cell.
constexpr double slip_line = 3., least_strain = 1e-3;

std::string where(const PeakStrain& peak) {
  return "at " + place_text(peak.at);
}

NumberedWarnings densification_warnings(const Evidence&, const Summary& summary) {
  return compaction_warnings(summary.densification);
}

SkippedList skipped_estimate(const Simulation& simulation, bool) {
  if (!yields(simulation.scene()) || !simulation.scene().accuracy.estimate) return {};
  return {{"estimate of errors", "the soil yields, and errors are estimated of linear soil alone"}};
}

/// A check that holds where the motion ends, but did not at `worst` in the last fifth of the run, has judged a moment
/// of a swing; one that would not hold if it `moved` as far again, a moment of a creep.
Check at_rest(const Check& check, double worst, double moved) {
  if (!check.capacity || !check.demand) return check;
  if (worst > *check.capacity)
    return in_doubt(check, "the caisson has not come to rest: in the last fifth of the run it was at " +
                               with_unit(worst, check.unit) + ", beyond the limit");
  if (*check.demand + moved > *check.capacity)
    return in_doubt(check, "the caisson has not come to rest: it moved by " + with_unit(moved, check.unit) +
                               " in the last fifth of the run, and as much again passes the limit");
  return check;
}

/// The worst of a residual of all starts of the soil; `bounds` are empty where there is one start.
double worst_residual(const Summary& summary, const std::function<double(const ResidualSummary&)>& of) {
  double worst = of(*summary.residual);
  for (const StartBound& bound : summary.nonlinear->bounds) worst = std::max(worst, of(bound.residual));
  return worst;
}

/// Sand that packs denser settles on while its water drains. Of the stress that it has lost shear may have taken a
/// part, which does not come back.
Check drained(const Check& check, const std::vector<CompactedSoil>& soils) {
  constexpr double gone = 0.05;    // of the stress at rest
  constexpr double little = 100.;  // Pa, 1 cm of water: a millimetre on 20 m of loose sand
  double left = 0.;
  for (const CompactedSoil& soil : soils)
    if (soil.pressure_ratio_at_end > gone) left = std::max(left, soil.pressure_at_end.value_or(0.));
  if (!(left > little)) return check;
  return in_doubt(check, "excess pore pressure of up to " + with_unit(left, "Pa") +
                             " is left at the end, and the ground settles while it drains: let the run end later");
}

/// How far the caisson has moved in the end, where soil yields. Where friction was followed node by node, the
/// displacement contains the slip over the mound; else the sliding distance is added to the displacement with the
/// ground, bonded. For hysteretic soil it is that from the start with the largest.
Check displacement_check(const Summary& summary, const Limits& limits) {
  const bool slipped = summary.contact && summary.contact->solved;
  using R = ResidualSummary;
  const auto worst = [&](const auto& of) { return worst_residual(summary, of); };
  const double carried = worst([](const R& r) { return std::abs(r.displacement_x); });
  const double slip = summary.sliding && !slipped ? std::abs(summary.sliding->design.value) : 0.;
  std::string how = slipped ? "slip node by node counts in it"
                            : "carried by the ground, bonded, and the sliding distance over the mound";
  for (const StartBound& bound : summary.nonlinear->bounds)
    if (std::abs(bound.residual.displacement_x) == carried && carried > std::abs(summary.residual->displacement_x))
      how += "; from the start " + bound.start + " carried " + with_unit(bound.residual.displacement_x, "m");
  const DesignSliding* design = summary.sliding ? &summary.sliding->design : nullptr;
  const Check check =
      held_to(check_of(FailureMode::sliding_distance, "displacement with the ground", "m",
                       design && !design->rests ? std::nullopt : std::optional(carried + slip),
                       slip > 0. ? "residual.displacement_x + sliding.design.value" : "residual.displacement_x", how),
              limits, &Limits::sliding);
  const bool ends = !design || design->why_not_all.empty() || (check.holds && !*check.holds);
  return ends ? at_rest(check, worst([](const R& r) { return largest_of(r.range_x); }) + slip, worst(moved_x))
              : not_checked(check, design->why_not_all);
}

Checks displacement_checks(const Scene& scene, const Summary& summary) {
  if (!summary.nonlinear || !summary.residual) return {};
  using R = ResidualSummary;
  const auto worst = [&](const auto& of) { return worst_residual(summary, of); };
  const double settlement = worst([](const R& r) { return std::max(-r.displacement_y, 0.); });
  const double tilt = worst([](const R& r) { return std::abs(r.rotation); });
  const std::string how = "where the caisson is when the run ends, after this load alone";
  const Check settled =
      check_of(FailureMode::settlement, "settlement", "m", settlement, "residual.displacement_y", how);
  const Check tilted = check_of(FailureMode::tilt, "tilt", "rad", tilt, "residual.rotation", how);
  return {displacement_check(summary, scene.limits),
          drained(at_rest(held_to(settled, scene.limits, &Limits::settlement),
                          worst([](const R& r) { return std::max(-r.range_y[0], 0.); }), worst(moved_y)),
                  summary.densification),
          at_rest(held_to(tilted, scene.limits, &Limits::tilt),
                  worst([](const R& r) { return largest_of(r.range_rotation); }), worst(moved_rotation))};
}

/// Warning still_moves: the caisson is not yet where it will stay.
NumberedWarnings moving_warnings(const Evidence& e, const Summary& summary) {
  constexpr double share = 0.1, least_turn = 1e-5;  // of a residual; what nobody sees: rad, and of B
  if (!summary.residual) return {};
  const ResidualSummary& r = *summary.residual;
  const double least = least_turn * e.simulation.compiled()->caisson->bottom_width;
  NumberedWarnings list;
  const auto see = [&](const std::string& what, const std::string& unit, double value, double still, double limit) {
    if (!list.empty() || still <= limit) return;
    list.push_back({"still_moves", still, limit, unit,
                    "in the last fifth of the run the caisson still moved by " + with_unit(still, unit) + " " + what +
                        ", where it ends with " + with_unit(value, unit) +
                        ": what is told as residual is a moment of that",
                    "let the run end later (time.end)"});
  };
  const auto limit = [&](double value, double not_seen) { return std::max(share * std::abs(value), not_seen); };
  see("horizontally", "m", r.displacement_x, moved_x(r), limit(r.displacement_x, least));
  see("vertically", "m", r.displacement_y, moved_y(r), limit(r.displacement_y, least));
  see("in tilt", "rad", r.rotation, moved_rotation(r), limit(r.rotation, least_turn));
  return list;
}

}  // namespace

std::optional<ResidualSummary> find_residual(const Evidence& e) {
  return e.solution.yielding ? e.solution.yielding->residual : std::nullopt;
}

NumberedWarnings yielding_warnings(const Summary& summary) {
  NumberedWarnings list;
  if (!summary.nonlinear) return list;
  const PeakStrain& peak = summary.nonlinear->peak_strain;
  if (peak.value > large_strain)
    list.push_back(
        {"large_strain", peak.value, large_strain, "1",
         "the soil shears by " + significant(100. * peak.value) + " % " + where(peak) +
             ": the equations assume small strains and undeformed ground, so that residual displacements may err by "
             "about that percentage, and a slope or base that fails may seem to hold or move too far",
         "take residual displacements as rough, and look whether a slope or base fails " + where(peak),
         peak.value > too_large_strain});
  if (peak.value > least_strain && peak.over_neighbours && *peak.over_neighbours > slip_line)
    list.push_back(
        {"slip_line", *peak.over_neighbours, slip_line, "1",
         "the cell " + where(peak) + " shears by " + significant(100. * peak.value) + " %, " +
             significant(*peak.over_neighbours) +
             " times as much as those beside it: the soil slides along a line as narrow as the cells, and this strain "
             "depends on their size",
         "run with mesh.refine = 1 and see whether the numbers that you need change"});
  return list;
}

Finding yielding_finding() {
  Finding f;
  f.keys.object("nonlinear", &Summary::nonlinear, nonlinear_outputs(), "of [soil that yields](yielding.md); else null")
      .object("residual", &Summary::residual, residual_outputs(),
              "where the caisson came to rest at the end of the run; null where no soil yields");
  f.warnings = [](const Evidence& e, const Summary& summary) {
    NumberedWarnings list = yielding_warnings(summary);
    append(list, moving_warnings(e, summary));
    return list;
  };
  f.skipped_of_scene = skipped_estimate;
  f.checks = displacement_checks;
  return f.part(&Summary::nonlinear, find_nonlinear).part(&Summary::residual, find_residual);
}

Finding densification_finding() {
  Finding f;
  f.keys.list("densification[]", &Summary::densification, densification_outputs(),
              "[denser soils](yielding.md#densification)");
  f.warnings = densification_warnings;
  return f.part(&Summary::densification, find_densification);
}

}  // namespace upbead
