#include "findings/errors.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/progress.h"
#include "fem/compile.h"
#include "fem/outline.h"
#include "findings/topics.h"
#include "response/shear_response.h"
#include "response/spectrum.h"
#include "run/accuracy/accuracy.h"
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

/// The simulation `other` in `part` times the steps of a solution, by the same scheme.
Simulation in_steps_of(const Simulation& other, const Discretisation& solved, double part) {
  Scene same = other.given();
  same.fields_every.reset();
  same.output_times.clear();
  same.time.step = part * solved.time_step * (1. + 1e-9);
  if (solved.scheme == "generalised_alpha") same.time.scheme = TimeScheme::generalised_alpha;
  if (solved.scheme == "sdirk4") same.time.scheme = TimeScheme::sdirk4;
  return with_given(other, same);
}

double slip_by_history(const std::optional<SlidingSummary>& sliding) {
  return sliding->history.by_history.residual;
}

/// S by eq. (4) if all forces at the bottom were `factor` times as large; computed with a resistance and a mass smaller
/// by that factor.
double slip_with_forces(const Evidence& e, double factor) {
  Scene other = e.simulation.scene();
  other.sliding->weight = e.of(find_slid)->weight / factor;
  other.sliding->submerged_weight /= factor;
  other.sliding->drag /= factor;
  return slip_by_history(sliding_of(other, *e.simulation.compiled(), e.solution.response));
}

/// Largest change of S by eq. (4) if forces are wrong by this share.
double change_by_forces(const Evidence& e, double error) {
  const double slip = slip_by_history(e.of(find_slid));
  return std::max(std::abs(slip_with_forces(e, 1. + error) - slip),
                  std::abs(slip_with_forces(e, 1. - std::min(error, 0.5)) - slip));
}

/// Changes of S if all forces at the bottom are wrong by the error of the peak, or by that of the history (m).
struct ByForces {
  double peak = 0., history = 0.;
};

/// S on both meshes, solved alike, and S on the scene's own mesh solved more accurately in time (m).
struct OtherSlips {
  double coarse = 0., finer = 0., shorter = 0.;
  double share = 1.;  ///< of the change between both, which the scene's own mesh has left
};

double slip_error(double slip, const OtherSlips& other, const ByForces& by_forces, const Margins& margin = {}) {
  const bool at_threshold = slip == 0. || other.finer == 0. || other.shorter == 0.;
  const double least =
      at_threshold ? by_forces.peak : std::max(by_chance * by_forces.peak, by_chance_of_history * by_forces.history);
  return std::max(
      margin.cells * other.share * std::abs(other.coarse - other.finer) + margin.steps * std::abs(slip - other.shorter),
      least);
}

/// Errors of S (m).
struct SlipErrors {
  std::optional<double> by_history, as_whole;
};

/// By solutions on cells half as large and in half the step.
SlipErrors compare(const Evidence& own, const Evidence& finer, const Evidence& shorter, const ByForces& by_forces) {
  const auto by_history = [](const Evidence& e) { return slip_by_history(e.of(find_slid)); };
  const double slip = by_history(own);
  SlipErrors errors{slip_error(slip, {slip, by_history(finer), by_history(shorter)}, by_forces), {}};
  const auto as_whole = [](const Evidence& e) -> const auto& {
    return e.of(find_slip_as_whole).coupled;
  };
  if (!as_whole(own) || !as_whole(finer) || !as_whole(shorter)) return errors;
  const auto distance = [&](const Evidence& e) { return as_whole(e)->slip.residual; };
  errors.as_whole = slip_error(distance(own), {distance(own), distance(finer), distance(shorter)}, by_forces);
  return errors;
}

/// By reduced models of both meshes; none where these do not give them.
std::optional<SlipErrors> compare_reduced(const Evidence& e, const CellsCompared* cells, const ByForces& by_forces) {
  const Simulation& simulation = e.simulation;
  if (cells == nullptr || !cells->reduced) return std::nullopt;
  const CellsCompared::Reduced& bonded = *cells->reduced;
  SlipErrors errors;
  if (const auto& coupled = e.of(find_slip_as_whole).coupled) {
    const std::optional<SlipCompared> whole = compare_slip(simulation, *cells);
    if (!whole) return std::nullopt;
    errors.as_whole =
        slip_error(coupled->slip.residual, {whole->coarse, whole->finer, whole->own, cells->share_of_slip}, by_forces);
  }
  const auto slip = [&](const Response& response) {
    return slip_by_history(sliding_of(simulation.scene(), *simulation.compiled(), response));
  };
  errors.by_history =
      slip_error(slip_by_history(e.of(find_slid)),
                 {slip(bonded.coarse), slip(bonded.finer), slip(bonded.own), cells->share_of_slip}, by_forces);
  return errors;
}

/// Errors of a solution with contact node by node.
struct ContactError {
  ShearError mesh, time;
  double of_nodes = 0.;  ///< error of S (m)
  SlipErrors bonded;     ///< of [sliding]
};

/// By the same march on cells half as large, and with steps half as long. Throws NumericsError as a march does.
ContactError error_of_contact(const Evidence& e) {
  const Simulation& simulation = e.simulation;
  const auto march_on = [&](const Simulation& on, double part) {
    return run_contact(in_steps_of(on, e.solution.discretisation, part), {});
  };
  const auto shear = [](const Solution& s) { return shear_history(*s.simulation->compiled(), s.response); };
  const auto slip = [](const Solution& s) { return s.contact->found.solved ? s.contact->found.solved->slip : 0.; };
  const Solution finer = march_on(with_halved_cells(simulation), 1.),
                 shorter = march_on(assembled_again(simulation), 0.5);
  const ShearError by_steps = difference(shear(e.solution), shear(shorter));
  constexpr double whole = 2.;  // order 1 at least: halving the steps removes half the error
  ContactError error{with_margin(difference(shear(e.solution), shear(finer))),
                     {whole * by_steps.peak, whole * by_steps.history},
                     slip_error(slip(e.solution), {slip(e.solution), slip(finer), slip(shorter)}, {}, of_contact),
                     {}};
  if (const auto& slid = e.of(find_slid))
    error.bonded = compare(e, Evidence(finer), Evidence(shorter),
                           {least_growth * error.mesh.peak * std::abs(slip_by_history(slid)), 0.});
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
  const Scene& scene = simulation.given();  // which is resolved anew
  const Sides sides = far_sides(*simulation.given_mesh());
  if (sides.empty()) return 0.;
  const double duration = step_of_loads(scene, 4).duration;
  const auto spectrum_of = [&](const Scene& other) {
    const Simulation coarse = on_mesh(other, simulation.given_mesh());
    return solve_spectrum(coarse.scene(), *coarse.compiled(), response.peak_shear_time);
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
ShearError error_of_steps(const Solution& solution) {
  constexpr double whole = 2.;
  const Simulation coarse = on_mesh(solution.simulation->given(), solution.simulation->given_mesh());
  const auto answer = [&](const TimeGrid& grid) {
    const bool alpha = solution.response.order == 2;
    return marched_shear(*coarse.compiled(), alpha ? SchemeKind::generalised_alpha : SchemeKind::sdirk4, grid);
  };
  const TimeGrid grid =
      make_time_grid(kinks(coarse.system()), coarse.scene().time.end, solution.discretisation.time_step * (1. + 1e-9));
  const ShearError moved = difference(answer(grid), answer(halved(grid)));
  return {whole * moved.peak, whole * moved.history};
}

/// The comparison of cells; it exists where the mesh was made for the tolerance, unless the soil has changed since.
std::shared_ptr<const CellsCompared> compared_cells(const Simulation& simulation) {
  if (simulation.accuracy() && !simulation.soil()) return simulation.accuracy()->compared;
  return std::make_shared<const CellsCompared>(compare_cells(simulation));
}

SlipErrors slip_errors(const Evidence& e, const Errors& of_shear, const CellsCompared* cells) {
  if (!e.of(find_slid)) return {};
  const ErrorEstimate& error = *of_shear.peak;
  const ByForces by_forces{change_by_forces(e, error.mesh + error.time + error.reduced_model),
                           change_by_forces(e, of_shear.history->total())};
  const auto& coupled = e.of(find_slip_as_whole).coupled;
  const bool rests = e.of(find_slid)->history.by_history.slips.empty() && by_forces.peak == 0. &&
                     (!coupled || coupled->slip.slips.empty());
  if (rests) return {0., coupled ? std::optional(0.) : std::nullopt};
  if (const auto errors = compare_reduced(e, cells, by_forces)) return *errors;
  const auto solve_on = [&](const Simulation& on, double part) {
    return run_bonded(in_steps_of(on, e.solution.discretisation, part), {});
  };
  const Solution finer = solve_on(with_halved_cells(e.simulation), 1.),
                 shorter = solve_on(assembled_again(e.simulation), 0.5);
  return compare(e, Evidence(finer), Evidence(shorter), by_forces);
}

bool asks_for_errors(const Evidence& e) {
  return e.of(find_shear) && e.scene.time.inertia && !yields(e.scene) &&
         (e.simulation.accuracy() || e.scene.accuracy.estimate);
}

std::string why_no_slip_error(const Scene& given) {
  if (yields(given)) return "the soil yields: errors are estimated of linear soil alone";
  return given.time.inertia ? "the refinements are given: accuracy.estimate = true, or mesh.refine = \"auto\", tells it"
                            : "consolidation has no dynamics";
}

}  // namespace

Errors find_errors(const Evidence& e) {
  Errors out;
  if (!asks_for_errors(e)) {
    out.why_no_slip = why_no_slip_error(e.scene);
    return out;
  }
  const auto progress = shown_progress("estimating errors");
  progress(0.);
  ShearError mesh, time;
  SlipErrors slip;
  std::shared_ptr<const CellsCompared> cells;
  const bool with_friction = e.solution.contact && e.solution.contact->found.solved;
  if (with_friction) {
    const ContactError contact = error_of_contact(e);
    mesh = contact.mesh;
    time = contact.time;
    slip = contact.bonded;
    out.slip_of_nodes = contact.of_nodes;
  } else {
    cells = compared_cells(e.simulation);
    mesh = cells->error;
    progress(0.4);
    if (!e.solution.reduction) time = error_of_steps(e.solution);
  }
  progress(0.6);
  out.peak = ErrorEstimate{mesh.peak, time.peak, 0., 0.};
  out.history = ErrorEstimate{mesh.history, time.history, 0., 0.};
  if (const auto& reduction = e.solution.reduction) {
    out.peak->reduced_model = reduction->error_peak;
    out.history->reduced_model = reduction->error;
  }
  out.peak->far_boundary = error_of_far_sides(e.simulation, *e.of(find_shear));
  progress(0.7);
  if (!slip.by_history) slip = slip_errors(e, out, cells.get());
  out.slip = slip.by_history;
  out.slip_as_whole = slip.as_whole;
  return out;
}

}  // namespace upbead
