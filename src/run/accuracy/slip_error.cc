#include "slip_error.h"

#include <algorithm>
#include <cmath>

#include "../contact/contact_run.h"
#include "../derived.h"
#include "../sliding/case_sliding.h"
#include "../solve.h"
#include "fem/compile.h"
#include "finer.h"
#include "shear_difference.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

/// What the truth lies away over what S moves by on cells half as large, and in half the step: docs/accuracy.md.
struct Margins {
  double cells = 4.5, steps = 3.;
};
constexpr Margins of_contact{5., 3.3};  // node by node
/// S of both meshes may agree by chance: parts of its change by forces wrong by as much as their peak and history may
/// be.
constexpr double by_chance = 0.03, by_chance_of_history = 0.01;
/// S grows at least with the square of the force: a part of it, over the error of the peak, where forces cannot be
/// scaled.
constexpr double least_growth = 2.;

/// Another simulation in `part` times the steps, and by the same scheme, as a run.
Simulation in_steps_of(const Simulation& other, const Run& run, double part) {
  Scene same = other.given;
  same.fields_every.reset();
  same.time.step = part * run.summary.discretisation.time_step * (1. + 1e-9);
  if (run.summary.discretisation.scheme == "generalised_alpha") same.time.scheme = TimeScheme::generalised_alpha;
  if (run.summary.discretisation.scheme == "sdirk4") same.time.scheme = TimeScheme::sdirk4;
  return with_given(other, same);
}

/// S by eq. (4) of a run whose forces at the bottom are all `factor` times as large: so many times less resists.
double slip_with_forces(const Simulation& simulation, const Run& run, double factor) {
  Scene other = simulation.scene;
  other.sliding->weight = run.summary.sliding->weight / factor;
  other.sliding->buoyant_weight /= factor;
  other.sliding->drag /= factor;
  return sliding_of(other, *simulation.compiled, run.response)->history.by_history.residual;
}

/// Largest change of S by eq. (4) for forces that are wrong by so much.
double change_by_forces(const Simulation& simulation, const Run& run, double error) {
  const double slip = run.summary.sliding->history.by_history.residual;
  return std::max(std::abs(slip_with_forces(simulation, run, 1. + error) - slip),
                  std::abs(slip_with_forces(simulation, run, 1. - std::min(error, 0.5)) - slip));
}

/// Changes of S by forces at the bottom that are all wrong by as much as their peak or their history may be (m).
struct ByForces {
  double peak = 0., history = 0.;
};

/// S as it is, on cells half as large, and in half the step (m).
double slip_error(double slip, double finer, double shorter, const ByForces& by_forces, const Margins& margin = {}) {
  const bool at_threshold = slip == 0. || finer == 0. || shorter == 0.;
  const double least =
      at_threshold ? by_forces.peak : std::max(by_chance * by_forces.peak, by_chance_of_history * by_forces.history);
  return std::max(margin.cells * std::abs(slip - finer) + margin.steps * std::abs(slip - shorter), least);
}

void compare(SlidingSummary& sliding, const SlidingSummary& finer, const SlidingSummary& shorter,
             const ByForces& by_forces) {
  const auto by_history = [](const SlidingSummary& s) { return s.history.by_history.residual; };
  sliding.error_estimate = slip_error(by_history(sliding), by_history(finer), by_history(shorter), by_forces);
  if (!sliding.coupled || !finer.coupled || !shorter.coupled) return;
  const auto as_whole = [](const SlidingSummary& s) { return s.coupled->slip.residual; };
  sliding.coupled->error_estimate = slip_error(as_whole(sliding), as_whole(finer), as_whole(shorter), by_forces);
}

}  // namespace

ContactError error_of_contact(Run& run) {
  const Simulation& simulation = *run.simulation;
  const ShearHistory own = shear_history(*simulation.compiled, run.response, true);
  ShearError by_cells, by_steps;
  const auto march_on = [&](const Simulation& on, double part, ShearError& moved) {
    Run other = run_contact(in_steps_of(on, run, part), {}, {});
    moved = difference(own, shear_history(*other.simulation->compiled, other.response, true));
    return other;
  };
  const Run finer = march_on(with_halved_cells(simulation), 1., by_cells),
            shorter = march_on(assembled_again(simulation), 0.5, by_steps);
  const auto slip = [](const Run& r) { return r.summary.contact->solved ? r.summary.contact->solved->slip : 0.; };
  constexpr double whole = 2.;  // order 1 at least: steps half as long take away half
  ContactError error;
  error.mesh = with_margin(by_cells);
  error.time = {whole * by_steps.peak, whole * by_steps.history};
  error.slip = slip_error(slip(run), slip(finer), slip(shorter), {}, of_contact);
  if (run.summary.sliding) {
    const double slid = std::abs(run.summary.sliding->history.by_history.residual);
    compare(*run.summary.sliding, *finer.summary.sliding, *shorter.summary.sliding,
            {least_growth * error.mesh.peak * slid, 0.});
  }
  return error;
}

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
  const auto solve_on = [&](const Simulation& on, double part) {
    return run_glued(in_steps_of(on, run, part), {}, {});
  };
  compare(sliding, *solve_on(with_halved_cells(simulation), 1.).summary.sliding,
          *solve_on(assembled_again(simulation), 0.5).summary.sliding, by_forces);
}

void tell_why_no_slip_error(Run& run) {
  if (!run.summary.sliding) return;
  run.summary.sliding->why_no_estimate =
      run.simulation->given.time.inertia
          ? "the refinements are given: accuracy.estimate = true, or mesh.refine = \"auto\", tells it"
          : "consolidation has no dynamics";
}

}  // namespace upbead
