// Soils whose stiffness and damping follow the strain of the response: iterated linear solutions.
#include "run/derived.h"

#include <algorithm>
#include <cmath>

#include "base/progress.h"
#include "dynamics/joined.h"
#include "fem/compile.h"
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
      const bool follows = region.strain_law && simulation.space()->kind(cell) != CellKind::absent;
      follows_.push_back(follows);
      laws_.push_back(follows ? *region.strain_law : StrainLaw());
      largest_.push_back(follows ? simulation.space()->material(cell).G : 0.);
    }
  }

  const std::vector<bool>& follows() const { return follows_; }

  /// Stiffness and damping for largest shear strains, by active cell index; cells that do not follow the strain keep
  /// theirs.
  SoilState at(const std::vector<double>& strain) const {
    SoilState state = scene_.soil_state();
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

  void report(const std::vector<double>& strain, SoilSummary& summary) const {
    summary.least_modulus_ratio = 1.;
    for (std::size_t i = 0; i < strain.size(); ++i) {
      if (!follows_[i]) continue;
      const double effective = laws_[i].effective * strain[i];
      summary.largest_strain = std::max(summary.largest_strain, effective);
      summary.least_modulus_ratio = std::min(summary.least_modulus_ratio, modulus_ratio(laws_[i], effective));
      summary.largest_damping = std::max(summary.largest_damping, damping_ratio(laws_[i], effective));
    }
  }

 private:
  const Simulation& scene_;
  std::vector<bool> follows_;
  std::vector<StrainLaw> laws_;
  std::vector<double> largest_;  ///< G_max (Pa)
};

/// Results of one linear solution.
struct LinearAnswer {
  std::vector<double> strain;  ///< largest shear strain of each cell
  double measure = 0.;         ///< whose convergence is required: the largest |F_T| (N/m), or strain
  double step = 0.;            ///< of the march (s); 0 of a reduced model
};

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
  if (choice.scheme != TimeScheme::reduced || !compiled.caisson) return std::nullopt;
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
    return LinearAnswer{strains.shear(), largest_shear(response), 0.};
  } catch (const NumericsError&) {
    return std::nullopt;
  }
}

LinearAnswer marched_answer(const Simulation& simulation, const std::vector<bool>& follows,
                            const std::function<void(double)>& progress) {
  LargestStrains strains(*simulation.space(), *simulation.unknowns(), follows);
  ObserverFunction reported = progress_observer(progress);
  WholeStates whole(simulation.system(), strains);
  Marching options;
  options.observers = {&whole, &reported};
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
          : *std::max_element(strains.shear().begin(), strains.shear().end());
  return {strains.shear(), measure, solution.discretisation.time_step};
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
  if (simulation.soil() || !follows_strain(simulation.scene())) return simulation;
  const Soil soil(simulation);
  const SoilState first = soil.at(std::vector<double>(soil.follows().size(), 0.));
  SoilSummary summary;
  Simulation latest = with_soil(simulation, first);
  // how many solutions it takes is not known: each is a fifth of what is left
  const auto part = [&](int n) { return part_of(progress, 1. - std::pow(0.8, n), 1. - std::pow(0.8, n + 1)); };
  const LinearAnswer linear = next_answer({}, latest, soil.follows(), part(0));
  LinearAnswer last = linear;
  summary.linear = linear.measure;
  while (!summary.converged && summary.iterations < most_iterations) {
    latest = with_room(with_soil(simulation, soil.at(last.strain)));  // for the solution, which comes after the last
    const LinearAnswer next = next_answer(linear, latest, soil.follows(), part(summary.iterations + 1));
    ++summary.iterations;
    summary.change = std::abs(next.measure - last.measure) / std::max(next.measure, 1e-300);
    summary.converged = summary.change < converged;
    last = next;
  }
  summary.settled = last.measure;
  soil.report(last.strain, summary);
  return latest.with([&](auto& parts) { parts.soil = summary; });
}

}  // namespace upbead
