#include "run/contact/reduced_ground.h"

#include <algorithm>
#include <cmath>
#include <list>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "base/stopwatch.h"
#include "dynamics/ground_steps.h"
#include "fem/caisson/readings.h"
#include "fem/compile.h"
#include "response/reduction.h"
#include "run/contact/contact_recorder.h"
#include "run/contact/contact_room.h"
#include "run/contact/ground_errors.h"
#include "run/derived.h"
#include "run/monitors.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

/// Of the largest reading of its unit: a reading below is zero.
constexpr double round_off = 1e-6;
/// Vectors of the bonded caisson's model, per independent load, of which the ground begins.
constexpr int bonded_vectors = 36;

/// Shows an observer what the coordinates of a model say of the whole state, where it wants states.
class OfWhole : public MarchObserver {
 public:
  OfWhole(const InterfaceModel& model, MarchObserver& observer) : model_(model), observer_(observer) {}
  void see(const State& state, int step, int n_steps) override {
    observer_.see(observer_.wants(state.time) ? model_.whole(state) : state, step, n_steps);
  }
  bool wants(double time) const override { return observer_.wants(time); }

 private:
  const InterfaceModel& model_;
  MarchObserver& observer_;
};

/// What one model answers.
struct ContactAnswer {
  Solution solution;
  double slip = 0.;
};

ContactAnswer answer_of(const Simulation& simulation, const ReducedGround::Level& level, const Marching& marching,
                        KnownPeriods& periods) {
  const InterfaceModel& model = level.model;
  const std::unique_ptr<Scheme> scheme = make_contact_scheme(model.system, model.ground, level.stages);
  ContactRecorder recorder(model.system, *scheme);
  const auto monitors = std::make_shared<Monitors>(simulation);
  std::list<OfWhole> others;
  for (MarchObserver* observer : marching.observers) others.emplace_back(model, *observer);
  Motions motions;
  Marching options = marching;
  options.monitored = false;
  options.observers = {&recorder, &motions};
  for (OfWhole& observer : others) options.observers.push_back(&observer);
  ContactAnswer answer{march_by(*scheme, simulation,
                                "bonded, the caisson would slip or lift at some node; the ground is "
                                "linear, and a reduced model stands for it",
                                options, 1., &model.system, &periods),
                       0.};
  Solution& solution = answer.solution;
  solution.response = model.read(std::move(solution.response), motions);
  if (monitors->pressure) monitors->pressure->see(model.phi, model.pressures(motions), solution.response.ends.time);
  if (const std::optional<Mismatch> off = imbalance(simulation, solution)) throw NumericsError(Imbalance(*off).what());
  solution.contact = followed_by(recorder);
  solution.contact->found.solved->dissipated = solution.response.energy.back().friction;
  solution.response.energy.clear();  // W has no coordinates of its own: its drag would count as damping
  solution.monitors = monitors;
  answer.slip = solution.contact->found.solved->slip;
  return answer;
}

/// Of all readings but F_T, over their own peaks; one that is round-off beside others of its unit has
/// none.
void find_inexact(const System& system, const Eigen::VectorXd& apart, const Eigen::VectorXd& peak,
                  ContactGround& ground) {
  std::map<std::string, double> largest;
  for (std::size_t i = 0; i < system.readings.size(); ++i)
    largest[system.readings[i].unit] = std::max(largest[system.readings[i].unit], peak[static_cast<Eigen::Index>(i)]);
  for (std::size_t i = 0; i < system.readings.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    if (peak[row] <= round_off * largest[system.readings[i].unit]) continue;
    const double error = margin_of_ground * apart[row] / peak[row];
    const std::string name = system.readings[i].name.text();
    if (name == reading::shear_force) continue;
    ground.others = std::max(ground.others, error);
    if (error > ground.tolerance_of_others) ground.inexact.push_back({name, error});
  }
}

/// The same of the least pressure of the water, over what the waves bring of it.
void find_inexact_pressure(const Monitors& fine, const Monitors& coarse, ContactGround& ground) {
  if (!fine.pressure || !fine.pressure->has_seen()) return;
  const double excess = std::abs(fine.pressure->excess());
  if (excess == 0.) return;
  const double error = margin_of_ground * std::abs(fine.pressure->value() - coarse.pressure->value()) / excess;
  ground.others = std::max(ground.others, error);
  if (error > ground.tolerance_of_others) ground.inexact.push_back({"the least pressure of the water", error});
}

/// The differences of two answers, with their margin.
ContactGround difference(const System& system, const ContactAnswer& fine, const ContactAnswer& coarse,
                         double tolerance) {
  const Series &ends = fine.solution.response.ends, &before = coarse.solution.response.ends;
  const Eigen::VectorXd apart = differences(ends, before), peaks = ends.reading.cwiseAbs().rowwise().maxCoeff();
  const Eigen::Index row = system.reading(reading::shear_force);
  ContactGround ground = ground_errors({ends.reading.row(row), *fine.solution.contact->found.solved},
                                       {before.reading.row(row), *coarse.solution.contact->found.solved}, apart[row]);
  ground.tolerance_of_others = of_history * tolerance;
  find_inexact(system, apart, peaks, ground);
  find_inexact_pressure(*fine.solution.monitors, *coarse.solution.monitors, ground);
  std::sort(ground.inexact.begin(), ground.inexact.end(),
            [](const InexactReading& a, const InexactReading& b) { return a.error > b.error; });
  return ground;
}

/// Directions of the bonded caisson's model at that look, in the order in which they came.
Eigen::MatrixXd directions_of(const GrowingBasis& basis, const Look& look) {
  const FieldBasis u = basis.displacements(look), phi = basis.phi(look);
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(u.unknown.size() + phi.unknown.size()),
                                                  look.n_displacements + look.n_phi);
  for (const FieldBasis* of : {&u, &phi})
    for (Eigen::Index j = 0; j < of->n(); ++j)
      columns(of->unknown, of->coordinate[static_cast<std::size_t>(j)]) = of->unit.cwiseProduct(of->vectors.col(j));
  return columns;
}

}  // namespace

std::string why_ground_is_whole(const Simulation& simulation) {
  const Scene& scene = simulation.scene();
  const System& system = simulation.system();
  if (yields(scene)) return "soil yields";
  if (!scene.time.inertia) return "consolidation is marched";
  if (simulation.processes()) return "several processes share the work";
  if (!simulation.compiled()->caisson) return "there is no caisson";
  if (!system.interface || system.n_prescribed != 2 * system.interface->n_nodes()) return "a motion is prescribed";
  const auto& law = scene.regions.at(caisson_name).interface;
  if (law && law->gap == GapSource::sea) return "the sea enters gaps, and nested models may agree by chance";
  if (scene.time.stop_at_energy) return "it shall stop early";
  if (scene.fields_every || has_strength(scene) || builds_pressure(scene) || scene.limits.liquefaction)
    return "the case asks for what is found in all cells";
  if (simulation.accuracy() || scene.accuracy.estimate) return "the case asks for the error by cells and steps";
  if (scene.tolerance < of_patch) return "a tolerance below 0.2 % is finer than what the patch around the base costs";
  return "";
}

bool reduces_ground(const Simulation& simulation) {
  return simulation.scene().time.scheme == TimeScheme::reduced && why_ground_is_whole(simulation).empty();
}

ReducedGround::ReducedGround(std::shared_ptr<const CompiledScene> compiled, double shift, Eigen::MatrixXd bonded)
    : compiled_(std::move(compiled)),
      shift_(shift),
      n_bonded_(bonded.cols()),
      space_(compiled_->system, shift, compiled_->body_coordinates, compiled_->caisson_motions, std::move(bonded)) {}

bool ReducedGround::serves(const CompiledScene& compiled, double shift, Eigen::Index n_bonded) const {
  const std::vector<SystemLoad>&mine = compiled_->system.loads, &others = compiled.system.loads;
  return shift == shift_ && n_bonded == n_bonded_ &&
         std::equal(mine.begin(), mine.end(), others.begin(), others.end(),
                    [](const SystemLoad& a, const SystemLoad& b) { return a.name == b.name && a.vector == b.vector; });
}

ReducedGround::Level& ReducedGround::level(int number, const System& system) {
  while (levels_.size() <= static_cast<std::size_t>(number)) {
    if (!levels_.empty()) space_.extend();
    levels_.push_back({space_.model(), std::make_shared<detail::GroundStages>(), space_.n_solves()});
  }
  Level& level = *std::next(levels_.begin(), number);
  level.model.system.interface = system.interface;
  for (std::size_t k = 0; k < system.loads.size(); ++k) level.model.system.loads[k].history = system.loads[k].history;
  return level;
}

ReducedGround& ground_of(const Simulation& simulation, ContactRoom& room, bool bonded_reduced) {
  const CompiledScene& compiled = *simulation.compiled();
  const double shift = shift_of_ground(simulation.scene());
  const std::shared_ptr<GrowingBasis> basis =
      bonded_reduced ? room.bonded->basis_about(shift, compiled.body_coordinates) : nullptr;
  const Look* look = basis ? &basis->reach(bonded_vectors * basis->n_independent_loads()) : nullptr;
  const Eigen::Index n = look != nullptr ? look->n_displacements + look->n_phi : 0;
  if (room.ground && room.ground->serves(compiled, shift, n)) return *room.ground;
  room.ground.reset();  // before the new one takes its memory
  room.ground = std::make_unique<ReducedGround>(simulation.compiled(), shift,
                                                look != nullptr ? directions_of(*basis, *look) : Eigen::MatrixXd());
  return *room.ground;
}

double shift_of_ground(const Scene& scene) {
  return std::exp2(std::round(std::log2(krylov_shift(scene))));
}

Solution contact_on_reduced_ground(const Simulation& simulation, const Marching& marching, ContactRoom& room,
                                   bool bonded_reduced) {
  const Stopwatch watch;
  const CompiledScene& compiled = *simulation.compiled();
  const double tolerance = whole_tolerance(simulation);
  ReducedGround& ground = ground_of(simulation, room, bonded_reduced);
  std::optional<ContactAnswer> before;
  ContactGround error;
  for (int number = 0; number < InterfaceSpace::n_levels; ++number) {
    const ReducedGround::Level& level = ground.level(number, compiled.system);
    ContactAnswer answer = answer_of(simulation, level, marching, room.periods);
    if (before) {
      error = difference(compiled.system, answer, *before, tolerance);
      error.coordinates = level.model.system.n_free();
      error.solves = level.n_solves;
      if (meets(error, *answer.solution.contact->found.solved, tolerance)) {
        answer.solution.contact->found.solved->ground = error;
        answer.solution.response.final_state = level.model.whole(answer.solution.response.final_state);
        answer.solution.timing.march = watch.seconds();
        return std::move(answer.solution);
      }
    }
    before = std::move(answer);
  }
  throw NumericsError(why_ground_misses(error));
}

}  // namespace upbead
