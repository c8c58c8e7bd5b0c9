#include "cli/report.h"

#include <algorithm>
#include <cmath>

#include "base/format.h"
#include "base/text.h"
#include "case/case_run.h"
#include "case/cfd/flow_scene.h"
#include "case/wave_load.h"
#include "fem/compile.h"
#include "model/words.h"
#include "output/summary_outputs.h"
#include "response/time_choice.h"
#include "run/yielding_extent.h"

namespace upbead {

namespace {

std::string describe_regions(const Case& input, const Simulation& simulation) {
  std::string text;
  for (const Decision& decision : simulation.decisions) {
    const std::string& name = decision.region;
    if (name.empty()) continue;
    const std::string kind = word_of(input.scene.regions.at(name).kind, region_kind_words);
    std::string line = kind + (decision.value == kind ? "" : ", " + decision.value) +
                       (decision.key == "flow" ? " flow: " : ": ") + decision.why;
    for (const Body& body : simulation.compiled->bodies)
      if (body.region == name)
        line += format(", %.5g kg/m, centre of gravity (%.4g, %.4g) m, inertia %.4g kg m2/m", body.mass, body.centre[0],
                       body.centre[1], body.moment_of_inertia);
    text += format("  %-12s ", name.c_str()) + line + "\n";
  }
  return text;
}

/// Largest velocity of a motion, and whether the boundary itself moves so or waves arrive from below through it.
std::string describe_motion(const Load& load, const Scene& scene) {
  const bool arrives = scene.boundaries.at(load.boundary).displacement == DisplacementCondition::absorbing;
  const double up = extremum(load.history, 0., scene.time.end, 1).value;
  const double down = extremum(load.history, 0., scene.time.end, -1).value;
  const std::string what = arrives ? "waves from below '" + load.boundary + "', by the motion of its outcrop"
                                   : "moves '" + load.boundary + "'";
  return format("%s: at most %.4g m/s", what.c_str(),
                std::max(up, -down) * std::hypot(load.direction[0], load.direction[1]));
}

std::string describe_loads(const Simulation& simulation) {
  std::string text;
  for (const LoadOnCaisson& load : simulation.compiled->loads_on_caisson) {
    std::string line = format("  %-12s ", load.name.c_str());
    const auto written = simulation.given.loads.find(load.name);
    if (written != simulation.given.loads.end() && is_motion(written->second.kind)) {
      text += line + describe_motion(written->second, simulation.given) + "\n";
      continue;
    }
    const double largest = std::max(std::abs(load.force_x), std::abs(load.force_y));
    if (const auto arm = load.arm())
      line += format("arm %.4g m above the caisson's bottom, F_x = %.4g per unit, F_y = %.4g", *arm,
                     without_round_off(load.force_x, largest), without_round_off(load.force_y, largest));
    else
      line += simulation.compiled->caisson ? "no horizontal force on the caisson" : "no caisson to act on";
    text += line + "\n";
  }
  return text;
}

std::string describe_march(const Run& run) {
  const Discretisation& d = run.summary.discretisation;
  return format("marched     %d steps of at most %.4g s by %s (%s); %d solves, %d factorisations\n", d.steps,
                d.time_step, d.scheme.c_str(), run.step_reason.c_str(), d.solves, d.factorisations) +
         "            because " + run.scheme_reason + "\n";
}

/// The way taken and the ways refused; nothing where the first way was taken.
std::string describe(const Ladder& ladder) {
  std::string text;
  for (const LadderStep& step : ladder)
    if (!step.refused.empty())
      text += (text.empty() ? "ladder      " : "            ") + step.way + " refused: " + step.refused + "\n";
  return text;
}

std::string describe(const ReductionSummary& r) {
  std::string text = format(
      "reduced     to %d modes from %d solves; between nested models the history of F_T differs by %.1e of its peak,\n"
      "            its peak by %.1e, other readings by up to %.1e of their own largest value; checked up to %.3g Hz\n",
      r.modes, r.vectors, r.error, r.error_peak, r.error_of_others, r.highest_frequency);
  if (r.error_of_states)
    text +=
        format("            fields and strengths: states move by %.1e of the largest, in energy\n", *r.error_of_states);
  return text;
}

std::string describe(const SoilSummary& s) {
  return format(
      "soil        %s after %d iterations (peak %s by %.1g); peak |F_T| %.4g of that at vanishing strain;\n"
      "            effective shear strain up to %.2g, G/G_max down to %.2f, damping up to %.3g\n",
      s.converged ? "settled" : "NOT SETTLED", s.iterations, "changed", s.change, s.settled / s.linear,
      s.largest_strain, s.least_modulus_ratio, s.largest_damping);
}

std::string describe(const ResidualSummary& r, double largest) {
  return with_unit(r.displacement_x, "m", largest) + " landward, " + with_unit(r.displacement_y, "m", largest) +
         " upward, turned " + significant(r.rotation) + " rad";
}

std::string describe(const NonlinearSummary& n, const Summary& summary) {
  std::string text =
      format("yielding    %s of the soil that may yield lost energy, %s in all; %.3g updates of stress a stage\n",
             percent(n.share_yielded).c_str(), with_unit(summary.energy->plastic, "J/m").c_str(),
             static_cast<double>(n.iterations) / std::max(n.stages, 1));
  text += "  strain      up to " + significant(100. * n.peak_strain.value) + " % in shear, at (" +
          significant(n.peak_strain.at[0]) + ", " + significant(n.peak_strain.at[1]) + ") m\n";
  for (const MobilisedRegion& of : n.regions)
    text += format("  %-12s%s of the strength at most (%s at rest), all of it in %s of the area\n", of.region.c_str(),
                   percent(of.largest).c_str(), percent(of.initial).c_str(), percent(of.share).c_str());
  if (n.share_beyond_at_rest > 0.)
    text += "  warning     at rest the stress exceeds the strength in " + percent(n.share_beyond_at_rest) +
            " of it: nothing in the model bears the excess\n";
  if (n.rest)
    text += format("  at rest     %s of Mohr-Coulomb soil at its strength; weights in %d steps, %d iterations\n",
                   percent(n.rest->share_at_strength).c_str(), n.rest->steps, n.rest->iterations);
  if (!summary.residual) return text;
  const double largest = summary.response->peak_displacement;
  text += "  residual    " + describe(*summary.residual, largest) + " (start: " + n.start + ")\n";
  if (const auto& left = summary.residual->pore_pressure)
    text += "              excess pore pressure left: " + with_unit(left->value, "Pa") + " at (" +
            significant(left->at[0]) + ", " + significant(left->at[1]) + ") m\n";
  for (const StartBound& bound : n.bounds)
    text += format("  %-12s", bound.start.c_str()) +
            (bound.shear_to_force_ratio ? "F_T / P " + significant(*bound.shear_to_force_ratio, 4) + ", " : "") +
            describe(bound.residual, largest) + "\n";
  return text;
}

std::string describe(const std::vector<CompactedSoil>& soils) {
  std::string text;
  for (const CompactedSoil& soil : soils)
    text += (text.empty() ? "densification\n" : "") + format("  %-12s", soil.region.c_str()) + "volumetric strain " +
            significant(soil.mean) + " in the mean, at most " + significant(soil.largest) + "; r_u at most " +
            significant(soil.largest_pressure_ratio) + ", " + significant(soil.pressure_ratio_at_end) + " at the end\n";
  return text;
}

std::string describe(const SafetySummary& s) {
  std::string text = "safety      at rest it stands ";
  if (s.lower)
    text += "with its strength over " + significant(*s.lower, 4);
  else
    text += s.upper ? "not even with 16 times its strength" : "with no strength that was tried";
  if (s.lower && s.upper) text += ", not over " + significant(*s.upper, 4);
  if (s.lower && !s.upper) text += ", and no factor was found with which it does not";
  if (s.upper) text += "; it gives way in " + s.fails_at;
  return text + (s.why_open.empty() ? "" : "; not closer: " + s.why_open) + "\n";
}

/// What may yield, and why all else is linear.
std::string describe(const YieldingExtent& extent) {
  if (extent.cells == 0) return "yielding    none: no region has law = \"hysteretic\" or \"mohr_coulomb\"\n";
  std::string text = format("yielding    %d of %d cells that deform may yield\n", extent.cells, extent.of);
  for (const Skipped& part : extent.linear) text += "  linear      " + part.what + ": " + part.why + "\n";
  return text;
}

std::string describe(const MeshAccuracy& accuracy) {
  std::string text = "adapted     unknowns (error of the history of F_T, of its peak):";
  for (const auto& [unknowns, error] : accuracy.levels)
    text += format(" %d (%.2g, %.2g)", unknowns, error.history, error.peak);
  return text + "\n";
}

std::string describe(const ErrorEstimate& peak, const ErrorEstimate& history) {
  return format("  error       up to %.2g of peak F_T: mesh %.1e, time %.1e, reduced model %.1e, far sides %.1e\n",
                peak.total(), peak.mesh, peak.time, peak.reduced_model, peak.far_boundary) +
         format("              up to %.2g of it at any time: mesh %.1e, time %.1e, reduced model %.1e\n",
                history.total(), history.mesh, history.time, history.reduced_model);
}

std::string since(const std::optional<double>& time) {
  return time ? "from " + significant(*time, 4) + " s" : "never";
}

/// What contact did; nothing where the caisson was bonded.
std::string describe(const ContactSummary& contact) {
  if (!contact.solved) return "";
  const NodeContact& c = *contact.solved;
  std::string text = "contact     friction " + significant(contact.friction) + " at " + std::to_string(contact.nodes) +
                     " nodes, N at rest " + with_unit(contact.weight, "N/m") + "\n";
  text += "  slip        " + with_unit(c.slip, "m", c.largest_slip) +
          (c.error_estimate ? " (wrong by up to " + with_unit(*c.error_estimate, "m") + ")" : "") +
          " in the end, at most " + with_unit(c.largest_slip, "m") +
          " on the way, mean over the bottom; the bottom as a whole " + with_unit(c.least_slip, "m", c.largest_slip) +
          "; nodes slip " + since(c.first_slip) + "\n";
  text += "  opening     seaward end " + with_unit(c.opening_seaward, "m") + ", landward end " +
          with_unit(c.opening_landward, "m") + "; nodes open " + since(c.first_open) + "; at least " +
          percent(c.least_contact) + " of the bottom touch\n";
  text += "  friction    took " + with_unit(c.dissipated, "J/m") + "; N falls to " +
          with_unit(c.least_normal_force, "N/m") + "\n";
  return text;
}

/// The pressure under one edge: at rest, and at its largest.
std::string edge(double at_rest, const std::optional<double>& worst, double time) {
  return with_unit(at_rest, "Pa") + " at rest, " +
         (worst ? "up to " + with_unit(*worst, "Pa") + " at "
                : std::string("no value: the resultant leaves the base here from ")) +
         significant(time, 4) + " s";
}

std::string describe(const BaseSummary& b) {
  std::string text = "base        effective pressure, varying linearly over the width in contact\n";
  text += "  heel        " + edge(b.heel_pressure_at_rest, b.peak_heel_pressure, b.peak_heel_pressure_time) + "\n";
  text += "  toe         " + edge(b.toe_pressure_at_rest, b.peak_toe_pressure, b.peak_toe_pressure_time) + "\n";
  text += "  resultant   up to " + with_unit(b.largest_eccentricity, "m") + " beside the middle at " +
          significant(b.largest_eccentricity_time, 4) + " s; N' down to " + with_unit(b.least_normal_force, "N/m") +
          "\n";
  if (b.least_overturning_margin)
    text += "  overturning margin " + significant(*b.least_overturning_margin) + " at " +
            significant(b.least_overturning_margin_time, 4) + " s\n";
  if (b.peak_computed_pressure)
    text += "  as solved   up to " + with_unit(*b.peak_computed_pressure, "Pa") +
            " under the node at x = " + significant(b.peak_computed_pressure_at, 4) + " m\n";
  return text;
}

/// The natural periods, or why there are none.
std::string describe_periods(const Summary& summary) {
  constexpr std::size_t most = 4;
  const std::vector<NaturalPeriod>& periods = summary.periods;
  const std::string none = why_no_periods(summary);
  std::string text = none.empty() ? "" : "periods     none: " + none;
  for (std::size_t i = 0; i < std::min(most, periods.size()); ++i)
    text += (i == 0 ? "periods     " : ", ") + significant(periods[i].period) + " s (share in F_T " +
            percent(periods[i].share) + ", damping " + percent(periods[i].damping_ratio) + ")";
  return text.empty() ? "" : text + "\n";
}

std::string describe(const std::vector<Check>& checks) {
  std::string text;
  for (const Check& c : checks) {
    const auto number = [&c](double value) {
      return c.unit.empty() ? significant(value, 4) : with_unit(value, c.unit);
    };
    text += (text.empty() ? "checks\n" : "") + format("  %-27s ", c.name.c_str()) +
            (c.demand  ? number(*c.demand)
             : c.holds ? "without bound"
                       : "not found");
    if (!c.capacity)
      text += ", no limit given";
    else
      text += " against " + number(*c.capacity) + ": " +
              (!c.holds   ? "not judged"
               : *c.holds ? "holds"
                          : "DOES NOT HOLD") +
              (c.margin ? ", margin " + significant(*c.margin, 3) : std::string());
    text += "\n";
  }
  return text;
}

std::string seconds(const std::optional<double>& value) {
  return value ? significant(*value, 4) + " s" : "none";
}

std::string wrong_by(const std::optional<double>& error) {
  return error ? " (wrong by up to " + with_unit(*error, "m") + ")" : "";
}

std::string distances(const SlidingSummary& s) {
  const Sliding& slid = s.history.by_history;
  std::string text = "  S           " + with_unit(slid.residual, "m") + wrong_by(s.error_estimate) +
                     " by eq. (4) on F_T(t), in " + std::to_string(slid.slips.size()) +
                     (slid.slips.size() == 1 ? " slip" : " slips") + "; with the vertical motion in N' " +
                     with_unit(s.history.with_normal_force.residual, "m") + "\n";
  if (s.coupled)
    text += "  S, coupled  " + with_unit(s.coupled->slip.residual, "m") + wrong_by(s.coupled->error_estimate) +
            " slipping as a whole on its ground; F_T up to " + with_unit(s.coupled->peak_shear, "N/m") +
            ", N' down to " + with_unit(s.coupled->least_normal, "N/m") + "\n";
  else if (!s.why_not_coupled.empty())
    text += "  S, coupled  no value: " + s.why_not_coupled + "\n";
  if (s.pulse)
    text += "  S_CAL       " + with_unit(s.pulse->paper, "m") +
            " by eq. (7) with tau_0 = " + seconds(s.pulse->duration) + " (k = " + significant(s.pulse->factor) +
            "), S_1 " + with_unit(s.pulse->paper_parts.accelerating, "m") + " and S_2 " +
            with_unit(s.pulse->paper_parts.braking, "m") + "; the same pulse integrated " +
            with_unit(s.pulse->exact, "m") + "\n";
  return text;
}

/// F_Smax, S by every measure, and tau_0.
std::string describe(const SlidingSummary& s) {
  const HistorySliding& h = s.history;
  std::string text = "sliding     friction " + significant(s.friction) + ", W' " +
                     with_unit(s.submerged_weight, "N/m") + ", uplift " + s.uplift + "\n";
  text += "  F_Smax      " + with_unit(h.peak_force, "N/m") + " at " + significant(h.peak_force_time, 4) +
          " s, of it mu U " + with_unit(s.friction * h.uplift_at_peak, "N/m", h.peak_force) + "; mu W' " +
          with_unit(h.resistance, "N/m") + ", r = " + significant(h.ratio, 4) + "\n";
  text += "  seaward     " + with_unit(std::max(h.peak_seaward, 0.), "N/m", h.peak_force) + " at " +
          significant(h.peak_seaward_time, 4) + " s: " + significant(std::max(h.peak_seaward, 0.) / h.resistance, 4) +
          " of mu W'\n";
  if (h.least_normal_force < 0.)
    text += "  warning     N' falls to " + with_unit(h.least_normal_force, "N/m") + ": the caisson would lift\n";
  if (h.by_history.slips.empty() && h.ratio <= 1.)
    text += "  S           0 m" + wrong_by(s.error_estimate) + ": F_S stays below mu W'\n";
  else
    text += distances(s);
  text += "  for design  S = " + with_unit(s.design.value, "m") + wrong_by(s.design.error_estimate) + " (" +
          s.design.measure + "): " + s.design.why + "\n";
  if (s.courses && s.courses->held > 0.)
    text += "  uplift      decides S by eq. (4): " + with_unit(s.courses->held, "m") + " held at its peak, " +
            with_unit(s.courses->in_phase, "m") + " in phase with P\n";
  if (h.own && h.own->by_exact)
    text += "  tau_0       of this history at this r: " + seconds(h.own->by_paper) + " by eq. (7), " +
            seconds(h.own->by_exact) + " integrated, " + seconds(h.own->by_excess) + " by the time above mu W', " +
            seconds(h.own->by_impulse) + " by impulse\n";
  return text;
}

}  // namespace

std::string describe(const Case& input, const Simulation& simulation) {
  std::string text = input.scene.title + "\n";
  text += format("mesh        %d cells of degree %d, %d unknowns (%d of them relative fluid displacements)\n",
                 static_cast<int>(simulation.mesh->triangulation.n_active_cells()), simulation.space->degree(),
                 simulation.unknowns->n_free(), [&] {
                   int n = 0;
                   for (const IndexRange& block : simulation.unknowns->blocks()) n += block.size();
                   return n;
                 }());
  if (simulation.processes) text += format("            divided among %d processes\n", simulation.processes->count());
  if (simulation.accuracy) text += describe(*simulation.accuracy);
  text += "regions\n" + describe_regions(input, simulation);
  text += "loads\n" + describe_loads(simulation);
  text +=
      describe(flow_summaries(input)) + describe(gauge_summaries(input, simulation)) + describe(wave_summaries(input));
  const SchemeChoice choice = choose_scheme(simulation.scene, *simulation.compiled);
  text += "in time     " + word_of(choice.scheme, time_scheme_words) + ": " + choice.reason +
          (choice.solves.empty() ? "" : "; " + choice.solves) + "\n";
  text += describe(yielding_extent(simulation));
  if (simulation.compiled->system.interface)
    text += "contact     friction " + significant(contact_friction(simulation.scene)) + " at " +
            std::to_string(simulation.compiled->system.interface->n_nodes()) +
            " nodes; followed where the bonded caisson would slip or lift at one of them\n";
  text += "skipped\n";
  for (const Skipped& item : skipped(input, simulation, choice.scheme == TimeScheme::reduced))
    text += "  " + item.what + ": " + item.why + "\n";
  return text;
}

std::string describe(const Run& run) {
  const Timing& t = run.summary.timing;
  std::string text = describe(run.summary.ladder);
  text += run.summary.reduction ? describe(*run.summary.reduction) : describe_march(run);
  if (run.response.stopped_early) text += "            stopped early: little energy was left, as the case allows\n";
  if (!run.summary.why_void.empty()) text += "VOID        " + run.summary.why_void + "\n";
  if (run.summary.response) {
    const ShearResponse& r = *run.summary.response;
    text += "response\n";
    text += format("  peak P      %-14s at %.4g s\n", with_unit(r.peak_force, "N/m").c_str(), r.peak_force_time);
    text += format("  peak F_T    %-14s at %.4g s (seaward %s at %.4g s)\n",
                   with_unit(r.peak_shear, "N/m", r.peak_force).c_str(), r.peak_shear_time,
                   with_unit(r.peak_shear_seaward, "N/m", r.peak_force).c_str(), r.peak_shear_seaward_time);
    text += r.shear_to_force_ratio ? format("  F_T / P     %.4f\n", *r.shear_to_force_ratio)
                                   : std::string("  F_T / P     none: no horizontal force acts on the caisson\n");
    text += format("  peak x_G    %s\n", with_unit(r.peak_displacement, "m").c_str());
    if (r.arm) text += format("  arm of P    %.4g m\n", *r.arm);
    text += format("  checks      both routes to F_T differ by %.1e", r.reaction_mismatch) +
            (run.summary.energy ? format(", energy by %.1e\n", run.summary.energy->mismatch()) : "\n");
  }
  if (run.summary.error) text += describe(*run.summary.error, *run.summary.history_error);
  if (run.summary.soil) text += describe(*run.summary.soil);
  if (run.summary.nonlinear) text += describe(*run.summary.nonlinear, run.summary);
  text += describe(run.summary.densification);
  if (run.summary.safety) text += describe(*run.summary.safety);
  text += describe_periods(run.summary);
  if (run.summary.contact) text += describe(*run.summary.contact);
  if (run.summary.sliding) text += describe(*run.summary.sliding);
  if (run.summary.base) text += describe(*run.summary.base);
  text += describe(run.summary.checks);
  text +=
      format("time        mesh %.2f s, compile %.2f s, factorise %.2f s, march %.2f s, output %.2f s, total %.2f s\n",
             t.mesh, t.compile, t.factorise, t.march, t.output, t.total);
  return text;
}

}  // namespace upbead
