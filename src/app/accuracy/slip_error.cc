#include "slip_error.h"

#include <algorithm>
#include <cmath>

#include "../contact/contact_run.h"
#include "../sliding/case_sliding.h"
#include "../solve.h"
#include "finer.h"
#include "shear_difference.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

/// What the truth lies away over what S moves by on cells half as large: docs/accuracy.md.
constexpr double margin = 2.5;
/// S of both meshes may agree by chance: part of its change by forces wrong by as much as their peak may be.
constexpr double by_chance = 0.1;

/// The case in the same steps, and by the same scheme, as a run of it.
Case in_steps_of(const Case& input, const Run& run, double part) {
  Case same = input;
  same.scene.fields_every.reset();
  if (run.summary.reduction) return same;
  same.scene.time.step = part * run.summary.discretisation.time_step * (1. + 1e-9);
  if (run.summary.discretisation.scheme == "generalised_alpha") same.scene.time.scheme = TimeScheme::generalised_alpha;
  if (run.summary.discretisation.scheme == "sdirk4") same.scene.time.scheme = TimeScheme::sdirk4;
  return same;
}

/// S by eq. (4) of a run whose forces at the bottom are all `factor` times as large: so many times less resists.
double slip_with_forces(const CompiledCase& scene, const Run& run, double factor) {
  Scene other = scene.scene;
  other.sliding->weight = run.summary.sliding->weight / factor;
  other.sliding->buoyant_weight /= factor;
  other.sliding->drag /= factor;
  return sliding_of(other, scene.compiled, run.response)->history.by_history.residual;
}

/// Largest change of S by eq. (4) for forces that are wrong by so much.
double change_by_forces(const CompiledCase& scene, const Run& run, double error) {
  const double slip = run.summary.sliding->history.by_history.residual;
  return std::max(std::abs(slip_with_forces(scene, run, 1. + error) - slip),
                  std::abs(slip_with_forces(scene, run, 1. - std::min(error, 0.5)) - slip));
}

/// Of S on one mesh and on cells half as large; `by_forces`: its change by forces wrong by as much as their peak may
/// be.
double slip_error(double slip, double finer, double by_forces) {
  const bool at_threshold = slip == 0. || finer == 0.;
  return std::max(margin * std::abs(slip - finer), (at_threshold ? 1. : by_chance) * by_forces);
}

void compare(SlidingSummary& sliding, const SlidingSummary& finer, double by_forces) {
  sliding.error_estimate =
      slip_error(sliding.history.by_history.residual, finer.history.by_history.residual, by_forces);
  if (!sliding.coupled || !finer.coupled) return;
  sliding.coupled->error_estimate = slip_error(sliding.coupled->slip.residual, finer.coupled->slip.residual, by_forces);
}

}  // namespace

ContactError error_of_contact(const Case& input, const CompiledCase& scene, Run& run) {
  const ShearHistory own = shear_history(scene.compiled, run.response, true);
  const auto march_on = [&](CompiledCase on, double part, double& slip) {
    const Run other = run_contact(in_steps_of(input, run, part), on, {}, {});
    const auto& solved = other.summary.contact->solved;
    slip = std::abs(run.summary.contact->solved->slip - (solved ? solved->slip : 0.));
    if (part == 1. && run.summary.sliding) compare(*run.summary.sliding, *other.summary.sliding, 0.);
    return difference(own, shear_history(on.compiled, other.response, true));
  };
  double by_cells = 0., by_steps = 0.;
  ContactError error;
  error.mesh = with_margin(march_on(compile_finer(input, scene), 1., by_cells));
  // order 1 at least: steps half as long take away half
  const ShearError in_half = march_on(compile_again(input, scene), 0.5, by_steps);
  error.time = {2. * in_half.peak, 2. * in_half.history};
  error.slip = margin * by_cells + 2. * by_steps;
  return error;
}

void estimate_slip_error(const Case& input, const CompiledCase& scene, Run& run) {
  if (!run.summary.sliding || run.summary.sliding->error_estimate) return;
  SlidingSummary& sliding = *run.summary.sliding;
  const ErrorEstimate& error = *run.summary.error;
  const double by_forces = change_by_forces(scene, run, error.mesh + error.time + error.reduced_model);
  const bool rests = sliding.history.by_history.slips.empty() && by_forces == 0.;
  if (rests) {
    sliding.error_estimate = 0.;
    if (sliding.coupled) sliding.coupled->error_estimate = 0.;
    return;
  }
  const CompiledCase finer = compile_finer(input, scene);
  const Run other = run_glued(in_steps_of(input, run, 1.), finer, {}, {});
  compare(sliding, *other.summary.sliding, by_forces);
}

void tell_why_no_slip_error(const Case& input, Run& run) {
  if (!run.summary.sliding) return;
  run.summary.sliding->why_no_estimate =
      input.scene.time.inertia
          ? "the refinements are given: accuracy.estimate = true, or mesh.refine = \"auto\", tells it"
          : "consolidation has no dynamics";
}

}  // namespace upbead
