// Soils whose stiffness and damping follow the strain of the response, and stones whose drag follows the velocity of
// their water: iterated linear solutions.
#include "run/derived.h"

#include <algorithm>
#include <cmath>

#include "base/progress.h"
#include "dynamics/joined.h"
#include "fem/compile.h"
#include "response/drag_velocity.h"
#include "response/monitors.h"
#include "response/reduction.h"
#include "response/time_choice.h"
#include "run/solve.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

constexpr int most_iterations = 15;
constexpr double converged = 0.01;

/// The soil of every cell, and its properties by strain.
class Soil {
 public:
  explicit Soil(const Simulation& simulation) : scene_(simulation) {
    for (const auto& cell : simulation.space()->dofs().active_cell_iterators()) {
      const Region& region = simulation.space()->region(cell);
      const bool follows =
          region.strain_law && region.law == SoilLaw::elastic && simulation.space()->kind(cell) != CellKind::absent;
      follows_.push_back(follows);
      laws_.push_back(follows ? *region.strain_law : StrainLaw());
      largest_.push_back(follows ? simulation.space()->material(cell).G : 0.);
      const bool drags = region.forchheimer && simulation.space()->has_pores(cell);
      drag_.push_back(drags ? *region.forchheimer : 0.);
      conductivity_.push_back(drags ? *region.hydraulic_conductivity : 0.);
    }
  }

  const std::vector<bool>& follows() const { return follows_; }

  /// Stiffness and damping for largest shear strains, drag for velocities, by active cell index; other cells keep
  /// theirs.
  SoilState at(const std::vector<double>& strain, const std::vector<double>& velocity) const {
    SoilState state = scene_.soil_state();
    if (follows_velocity(scene_.scene())) state.conductivity.assign(strain.size(), 0.);
    for (std::size_t i = 0; i < state.conductivity.size(); ++i)
      state.conductivity[i] = conductivity_[i] * conductivity_ratio(i, velocity);
    if (!follows_strain(scene_.scene())) return state;
    state.shear_modulus.resize(strain.size(), 0.);
    state.damping_ratio.assign(strain.size(), -1.);
    for (std::size_t i = 0; i < strain.size(); ++i) {
      if (!follows_[i]) continue;
      const double effective = laws_[i].effective * strain[i];
      state.shear_modulus[i] = largest_[i] * modulus_ratio(laws_[i], effective);
      state.damping_ratio[i] = damping_ratio(laws_[i], effective);
    }
    return state;
  }

  void report(const std::vector<double>& strain, const std::vector<double>& velocity, SoilSummary& summary) const {
    summary.least_modulus_ratio = 1.;
    for (std::size_t i = 0; i < strain.size(); ++i) {
      summary.largest_velocity = std::max(summary.largest_velocity, velocity[i]);
      summary.least_conductivity_ratio = std::min(summary.least_conductivity_ratio, conductivity_ratio(i, velocity));
      if (!follows_[i]) continue;
      const double effective = laws_[i].effective * strain[i];
      summary.largest_strain = std::max(summary.largest_strain, effective);
      summary.least_modulus_ratio = std::min(summary.least_modulus_ratio, modulus_ratio(laws_[i], effective));
      summary.largest_damping = std::max(summary.largest_damping, damping_ratio(laws_[i], effective));
    }
  }

 private:
  /// k_eq/k of i = w/k + b w_c w.
  double conductivity_ratio(std::size_t cell, const std::vector<double>& velocity) const {
    return 1. / (1. + drag_[cell] * conductivity_[cell] * velocity[cell]);
  }

  const Simulation& scene_;
  std::vector<bool> follows_;
  std::vector<StrainLaw> laws_;
  std::vector<double> largest_;              ///< G_max (Pa)
  std::vector<double> drag_, conductivity_;  ///< b (s2/m2) and k (m/s) where drag grows with velocity
};

/// Results of one linear solution.
struct LinearAnswer {
  std::vector<double> strain;    ///< largest shear strain of each cell
  std::vector<double> velocity;  ///< at which its drag is made linear (m/s)
  double measure = 0.;           ///< whose convergence is required: the largest |F_T| (N/m), or strain or velocity
  double step = 0.;              ///< of the march (s); 0 of a reduced model
};

double largest(const std::vector<double>& values) {
  return *std::max_element(values.begin(), values.end());
}

/// The velocity at which drag is made linear next. Where b |w| w alone resists, what is found is i/(b w) of what was
/// taken: their geometric mean is the answer, and either alone would lead back to the other.
std::vector<double> between(const std::vector<double>& taken, const std::vector<double>& found) {
  std::vector<double> next = found;
  for (std::size_t i = 0; i < next.size(); ++i)
    if (taken[i] > 0.) next[i] = std::sqrt(taken[i] * found[i]);
  return next;
}

double change_of(double last, double next) {
  return std::abs(next - last) / std::max(next, 1e-300);
}

/// Largest change of a cell, over the largest value of all.
double change_of(const std::vector<double>& last, const std::vector<double>& next) {
  double most = 0.;
  for (std::size_t i = 0; i < next.size(); ++i) most = std::max(most, std::abs(next[i] - last[i]));
  return most / std::max(largest(next), 1e-300);
}

/// The simulation with the steps of the first march: softer soil would allow longer steps, but finding them takes
/// factorisations.
Simulation in_first_steps(const LinearAnswer& first, const Simulation& simulation) {
  if (first.step == 0. || !simulation.scene().time.inertia) return simulation;  // in quasi-statics its steps grow
  Scene scene = simulation.given();
  scene.time.step = first.step * (1. + 1e-9);
  return with_given(simulation, scene);
}

double largest_shear(const ShearResponse& response) {
  return std::max(response.peak_shear, -response.peak_shear_seaward);
}

/// By a reduced model, where one would answer the scene itself and has converged.
std::optional<LinearAnswer> reduced_answer(const Simulation& simulation, const std::vector<bool>& follows,
                                           const std::function<void(double)>& progress) {
  const Scene& scene = simulation.scene();
  const CompiledScene& compiled = *simulation.compiled();
  const SchemeChoice choice = choose_scheme(scene, compiled);
  const bool needs_flow = follows_velocity(scene);  // of which a reduced model keeps nothing
  if (choice.scheme != TimeScheme::reduced || !compiled.caisson || needs_flow) return std::nullopt;
  ReductionTargets targets;
  targets.most_vectors = choice.most_vectors;
  targets.only_shear = true;
  targets.states = true;
  try {
    Reduction reduction = reduce_scene(scene, compiled, targets, progress, simulation.room().get());
    if (!reduction.converged) return std::nullopt;
    LargestStrains strains(*simulation.space(), *simulation.unknowns(), follows);
    StateModel& states = *reduction.states;
    for (FieldBasis* basis : {&states.displacements, &states.phi}) *basis = joined(compiled.system, std::move(*basis));
    strains.see(states, sampled_loads(scene, compiled.system));
    const ShearResponse response =
        read_shear_response(compiled, respond(reduction, scene, compiled.system), scene.time.inertia);
    return LinearAnswer{strains.shear(), std::vector<double>(follows.size(), 0.), largest_shear(response), 0.};
  } catch (const NumericsError&) {
    return std::nullopt;
  }
}

LinearAnswer marched_answer(const Simulation& simulation, const std::vector<bool>& follows,
                            const std::function<void(double)>& progress) {
  LargestStrains strains(*simulation.space(), *simulation.unknowns(), follows);
  ObserverFunction reported = progress_observer(progress);
  DragVelocity velocities(*simulation.space(), *simulation.unknowns());
  WholeStates whole(simulation.system(), strains), flow(simulation.system(), velocities);
  Marching options;
  options.observers = {&whole, &flow, &reported};
  const TimeScheme asked = simulation.scene().time.scheme;
  SchemeOptions scheme_options;
  scheme_options.account_energy = false;  // nobody sees these results
  if (asked == TimeScheme::generalised_alpha) scheme_options.kind = SchemeKind::generalised_alpha;
  const auto scheme = make_scheme(simulation.system(), scheme_options);
  const Solution solution = march_by(*scheme, simulation, "equivalent-linear soil is marched", options, 1.);
  const CompiledScene& compiled = *simulation.compiled();
  const double measure =
      compiled.caisson
          ? largest_shear(read_shear_response(compiled, solution.response, simulation.scene().time.inertia))
          : largest(follows_strain(simulation.scene()) ? strains.shear() : velocities.found());
  return {strains.shear(), velocities.found(), measure, solution.discretisation.time_step};
}

/// As the first answer was found.
LinearAnswer next_answer(const LinearAnswer& first, const Simulation& simulation, const std::vector<bool>& follows,
                         const std::function<void(double)>& progress) {
  if (first.step == 0.)
    if (const auto reduced = reduced_answer(simulation, follows, progress)) return *reduced;
  return marched_answer(in_first_steps(first, simulation), follows, progress);
}

}  // namespace

Simulation with_converged_soil(const Simulation& simulation, const std::function<void(double)>& progress) {
  const bool follows = follows_strain(simulation.scene()) || follows_velocity(simulation.scene());
  if (simulation.soil() || !follows) return simulation;
  const Soil soil(simulation);
  const std::vector<double> none(soil.follows().size(), 0.);
  const SoilState first = soil.at(none, none);
  SoilSummary summary;
  Simulation latest = with_soil(simulation, first);
  // how many solutions it takes is not known: each is a fifth of what is left
  const auto part = [&](int n) { return part_of(progress, 1. - std::pow(0.8, n), 1. - std::pow(0.8, n + 1)); };
  const LinearAnswer linear = next_answer({}, latest, soil.follows(), part(0));
  LinearAnswer last = linear;
  std::vector<double> velocity = linear.velocity;
  summary.linear = linear.measure;
  while (!summary.converged && summary.iterations < most_iterations) {
    latest = with_room(
        with_soil(simulation, soil.at(last.strain, velocity)));  // for the solution, which comes after the last
    const LinearAnswer next = next_answer(linear, latest, soil.follows(), part(summary.iterations + 1));
    ++summary.iterations;
    summary.change = std::max(change_of(last.measure, next.measure), change_of(velocity, next.velocity));
    velocity = between(velocity, next.velocity);
    summary.converged = summary.change < converged;
    last = next;
  }
  summary.settled = last.measure;
  soil.report(last.strain, last.velocity, summary);
  return latest.with([&](auto& parts) { parts.soil = summary; });
}

}  // namespace upbead
