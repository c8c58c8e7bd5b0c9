#include "run/accuracy/accuracy.h"

#include <algorithm>
#include <cmath>

#include "base/progress.h"
#include "fem/compile.h"
#include "fem/outline.h"
#include "response/shear_response.h"
#include "response/spectrum.h"
#include "response/time_choice.h"
#include "run/contact/contact_run.h"
#include "run/derived.h"
#include "run/sliding/case_sliding.h"
#include "run/solve.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

/// The distance of S to the exact value, as a multiple of its change on cells half as large and in half the step:
/// docs/accuracy.md.
struct Margins {
  double cells = 4.5, steps = 3.;
};
constexpr Margins of_contact{5., 3.3};  // node by node
/// S of both meshes may agree by coincidence. So its error is at least these shares of its changes under forces that
/// are wrong by the error of the peak and of the history.
constexpr double by_chance = 0.03, by_chance_of_history = 0.01;
/// S grows at least with the square of the force: where forces cannot be scaled, the relative change of S over the
/// error of the peak.
constexpr double least_growth = 2.;

/// The simulation `other` in `part` times the steps of a run, by the same scheme.
Simulation in_steps_of(const Simulation& other, const Run& run, double part) {
  Scene same = other.given;
  same.fields_every.reset();
  same.output_times.clear();
  same.time.step = part * run.summary.discretisation.time_step * (1. + 1e-9);
  if (run.summary.discretisation.scheme == "generalised_alpha") same.time.scheme = TimeScheme::generalised_alpha;
  if (run.summary.discretisation.scheme == "sdirk4") same.time.scheme = TimeScheme::sdirk4;
  return with_given(other, same);
}

/// S by eq. (4) of a run if all forces at the bottom were `factor` times as large; computed with a resistance and a
/// mass smaller by that factor.
double slip_with_forces(const Simulation& simulation, const Run& run, double factor) {
  Scene other = simulation.scene;
  other.sliding->weight = run.summary.sliding->weight / factor;
  other.sliding->submerged_weight /= factor;
  other.sliding->drag /= factor;
  return sliding_of(other, *simulation.compiled, run.response)->history.by_history.residual;
}

/// Largest change of S by eq. (4) if forces are wrong by this share.
double change_by_forces(const Simulation& simulation, const Run& run, double error) {
  const double slip = run.summary.sliding->history.by_history.residual;
  return std::max(std::abs(slip_with_forces(simulation, run, 1. + error) - slip),
                  std::abs(slip_with_forces(simulation, run, 1. - std::min(error, 0.5)) - slip));
}

/// Changes of S if all forces at the bottom are wrong by the error of the peak, or by that of the history (m).
struct ByForces {
  double peak = 0., history = 0.;
};

/// S on both meshes, solved alike, and S on the scene's own mesh solved more accurately in time (m).
struct OtherSlips {
  double coarse = 0., finer = 0., shorter = 0.;
};

double slip_error(double slip, const OtherSlips& other, const ByForces& by_forces, const Margins& margin = {}) {
  const bool at_threshold = slip == 0. || other.finer == 0. || other.shorter == 0.;
  const double least =
      at_threshold ? by_forces.peak : std::max(by_chance * by_forces.peak, by_chance_of_history * by_forces.history);
  return std::max(margin.cells * std::abs(other.coarse - other.finer) + margin.steps * std::abs(slip - other.shorter),
                  least);
}

double slip_by_history(const SlidingSummary& sliding) {
  return sliding.history.by_history.residual;
}

/// Estimates the errors by runs on cells half as large and in half the step.
void compare(SlidingSummary& sliding, const SlidingSummary& finer, const SlidingSummary& shorter,
             const ByForces& by_forces) {
  const double by_history = slip_by_history(sliding);
  sliding.error_estimate =
      slip_error(by_history, {by_history, slip_by_history(finer), slip_by_history(shorter)}, by_forces);
  if (!sliding.coupled || !finer.coupled || !shorter.coupled) return;
  const auto as_whole = [](const SlidingSummary& s) { return s.coupled->slip.residual; };
  sliding.coupled->error_estimate =
      slip_error(as_whole(sliding), {as_whole(sliding), as_whole(finer), as_whole(shorter)}, by_forces);
}

/// Estimates the errors by reduced models of both meshes; false where these do not give them.
bool compare_reduced(Run& run, const ByForces& by_forces) {
  const Simulation& simulation = *run.simulation;
  SlidingSummary& sliding = *run.summary.sliding;
  if (!run.cells || !run.cells->reduced) return false;
  const CellsCompared::Reduced& bonded = *run.cells->reduced;
  std::optional<SlipCompared> whole;
  if (sliding.coupled) {
    whole = compare_slip(simulation, bonded.own);
    if (!whole) return false;
    sliding.coupled->error_estimate =
        slip_error(sliding.coupled->slip.residual, {whole->coarse, whole->finer, whole->own}, by_forces);
  }
  const auto slip = [&](const Response& response) {
    return slip_by_history(*sliding_of(simulation.given, *simulation.compiled, response));
  };
  sliding.error_estimate =
      slip_error(slip_by_history(sliding), {slip(bonded.coarse), slip(bonded.finer), slip(bonded.own)}, by_forces);
  return true;
}

/// Errors of a run with contact node by node.
struct ContactError {
  ShearError mesh, time;
  double slip = 0.;  ///< error of S (m)
};

/// By the same march on cells half as large, and with steps half as long; fills in the error of [sliding], too.
/// Throws NumericsError as a march does.
ContactError error_of_contact(Run& run) {
  const Simulation& simulation = *run.simulation;
  const auto march_on = [&](const Simulation& on, double part) {
    return run_contact(in_steps_of(on, run, part), {}, {});
  };
  const auto shear = [](const Run& r) { return shear_history(*r.simulation->compiled, r.response); };
  const auto slip = [](const Run& r) { return r.summary.contact->solved ? r.summary.contact->solved->slip : 0.; };
  const Run finer = march_on(with_halved_cells(simulation), 1.), shorter = march_on(assembled_again(simulation), 0.5);
  const ShearError by_steps = difference(shear(run), shear(shorter));
  constexpr double whole = 2.;  // order 1 at least: halving the steps removes half the error
  ContactError error{with_margin(difference(shear(run), shear(finer))),
                     {whole * by_steps.peak, whole * by_steps.history},
                     slip_error(slip(run), {slip(run), slip(finer), slip(shorter)}, {}, of_contact)};
  if (run.summary.sliding) {
    const double slid = std::abs(run.summary.sliding->history.by_history.residual);
    compare(*run.summary.sliding, *finer.summary.sliding, *shorter.summary.sliding,
            {least_growth * error.mesh.peak * slid, 0.});
  }
  return error;
}

/// The surfaces behind each far side, by the side's name.
using Sides = std::map<std::string, std::set<std::string>>;

/// The scene with all its far sides of one kind.
Scene with_far_sides(const Scene& given, const Sides& sides, const Boundary& kind) {
  Scene other = given;
  const auto is_water = [&](const std::string& name) { return given.regions.at(name).kind == RegionKind::water; };
  for (const auto& [side, surfaces] : sides) {
    Boundary& boundary = other.boundaries.at(side);
    if (!std::all_of(surfaces.begin(), surfaces.end(), is_water)) boundary.displacement = kind.displacement;
    if (boundary.pressure) boundary.pressure = kind.pressure;
  }
  return other;
}

bool same_boundaries(const Scene& a, const Scene& b) {
  return std::equal(a.boundaries.begin(), a.boundaries.end(), b.boundaries.begin(), [](const auto& x, const auto& y) {
    return x.second.displacement == y.second.displacement && x.second.pressure == y.second.pressure;
  });
}

/// Largest |F_T| of a transform near a time (N/m).
double largest_shear(const Spectrum& spectrum, const std::vector<std::complex<double>>& shear, double time,
                     double duration) {
  double largest = 0.;
  for (int i = -2; i <= 2; ++i)
    largest = std::max(largest, std::abs(shear_at(spectrum.s, shear, time + 0.05 * i * duration)));
  return largest;
}

double error_of_far_sides(const Simulation& simulation, const ShearResponse& response) {
  const Scene& scene = simulation.given;
  const Sides sides = far_sides(*simulation.given_mesh);
  if (sides.empty()) return 0.;
  const double duration = step_of_loads(scene, 4).duration;
  const auto spectrum_of = [&](const Scene& other) {
    const Simulation coarse = on_mesh(other, simulation.given_mesh);
    return solve_spectrum(coarse.scene, *coarse.compiled, response.peak_shear_time);
  };
  const Spectrum given = spectrum_of(scene);
  const auto spectrum_with = [&](const Boundary& kind) {
    const Scene other = with_far_sides(scene, sides, kind);
    return same_boundaries(other, scene) ? given : spectrum_of(other);
  };
  const Spectrum held = spectrum_with({DisplacementCondition::roller, PressureCondition::sealed});
  const Spectrum free = spectrum_with({DisplacementCondition::free, PressureCondition::open});
  std::vector<std::complex<double>> difference;
  for (std::size_t j = 0; j < given.s.size(); ++j)
    difference.push_back(given.shear[j] - 0.5 * (held.shear[j] + free.shear[j]));
  return largest_shear(given, difference, response.peak_shear_time, duration) / std::abs(response.peak_shear);
}

/// The grid with every step halved.
TimeGrid halved(TimeGrid grid) {
  for (TimeSegment& segment : grid.segments) {
    segment.step *= 0.5;
    segment.n_steps *= 2;
  }
  return grid;
}

/// Error of a march of order 2 or 4, by steps half as long on the coarse mesh. Halving the steps removes at least
/// half the error, even where steps do not resolve corners of the loads, or stiff waves lower the order.
ShearError error_of_steps(const Run& run) {
  constexpr double whole = 2.;
  const Simulation coarse = on_mesh(run.simulation->given, run.simulation->given_mesh);
  const auto answer = [&](const TimeGrid& grid) {
    const bool alpha = run.response.order == 2;
    return marched_shear(*coarse.compiled, alpha ? SchemeKind::generalised_alpha : SchemeKind::sdirk4, grid);
  };
  const TimeGrid grid = make_time_grid(kinks(coarse.compiled->system), coarse.given.time.end,
                                       run.summary.discretisation.time_step * (1. + 1e-9));
  const ShearError moved = difference(answer(grid), answer(halved(grid)));
  return {whole * moved.peak, whole * moved.history};
}

/// The comparison of cells; it exists where the mesh was made for the tolerance, unless the soil has changed since.
std::shared_ptr<const CellsCompared> compared_cells(const Simulation& simulation) {
  if (simulation.accuracy && !simulation.soil) return simulation.accuracy->compared;
  return std::make_shared<const CellsCompared>(compare_cells(simulation));
}

}  // namespace

void estimate_slip_error(Run& run) {
  const Simulation& simulation = *run.simulation;
  if (!run.summary.sliding || run.summary.sliding->error_estimate) return;
  SlidingSummary& sliding = *run.summary.sliding;
  const ErrorEstimate& error = *run.summary.error;
  const ByForces by_forces{change_by_forces(simulation, run, error.mesh + error.time + error.reduced_model),
                           change_by_forces(simulation, run, run.summary.history_error->total())};
  const bool rests = sliding.history.by_history.slips.empty() && by_forces.peak == 0. &&
                     (!sliding.coupled || sliding.coupled->slip.slips.empty());
  if (rests) {
    sliding.error_estimate = 0.;
    if (sliding.coupled) sliding.coupled->error_estimate = 0.;
    return;
  }
  if (compare_reduced(run, by_forces)) return;
  const auto solve_on = [&](const Simulation& on, double part) {
    return run_bonded(in_steps_of(on, run, part), {}, {});
  };
  compare(sliding, *solve_on(with_halved_cells(simulation), 1.).summary.sliding,
          *solve_on(assembled_again(simulation), 0.5).summary.sliding, by_forces);
}

void tell_why_no_slip_error(Run& run) {
  if (!run.summary.sliding) return;
  run.summary.sliding->why_no_estimate =
      yields(run.simulation->given) ? "the soil yields: errors are estimated of linear soil alone"
      : run.simulation->given.time.inertia
          ? "the refinements are given: accuracy.estimate = true, or mesh.refine = \"auto\", tells it"
          : "consolidation has no dynamics";
}

void estimate_errors(Run& run) {
  const Simulation& simulation = *run.simulation;
  if (!run.summary.response || !simulation.given.time.inertia || yields(simulation.given) ||
      (!simulation.accuracy && !simulation.given.accuracy.estimate)) {
    tell_why_no_slip_error(run);
    return;
  }
  const auto progress = watched("estimating errors");
  progress(0.);
  ErrorEstimate& peak = run.summary.error.emplace();
  ErrorEstimate& history = run.summary.history_error.emplace();
  ShearError mesh, time;
  if (run.summary.contact && run.summary.contact->solved) {
    const ContactError contact = error_of_contact(run);
    mesh = contact.mesh;
    time = contact.time;
    run.summary.contact->solved->error_estimate = contact.slip;
  } else {
    run.cells = compared_cells(simulation);
    mesh = run.cells->error;
    progress(0.4);
    if (!run.summary.reduction) time = error_of_steps(run);
  }
  progress(0.6);
  peak.mesh = mesh.peak;
  history.mesh = mesh.history;
  peak.time = time.peak;
  history.time = time.history;
  if (run.summary.reduction) {
    peak.reduced_model = run.summary.reduction->error_peak;
    history.reduced_model = run.summary.reduction->error;
  }
  peak.far_boundary = error_of_far_sides(simulation, *run.summary.response);
  progress(0.7);
  estimate_slip_error(run);
}

}  // namespace upbead
