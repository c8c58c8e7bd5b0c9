#include "run/contact/reduced_ground.h"

#include <algorithm>
#include <cmath>
#include <list>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "base/progress.h"
#include "base/stopwatch.h"
#include "base/text.h"
#include "dynamics/interface_space.h"
#include "fem/caisson/readings.h"
#include "fem/compile.h"
#include "response/reduction.h"
#include "run/contact/contact_recorder.h"
#include "run/derived.h"
#include "run/monitors.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

/// Differences of nested models, which are about the error of the smaller one, count so many times: see
/// docs/reference/methods.md. Of S and of the peak, in which two models may agree by chance, at least this share of the
/// largest difference of F_T at any time is told.
constexpr double margin = 5., least_share = 0.25;
/// F_T(t) may be wrong by this multiple of what its peak may: where nodes come to rest a little later it differs more.
constexpr double of_history = 10.;
/// Of the largest reading of its unit: a reading below is zero.
constexpr double round_off = 1e-6;

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

ContactAnswer answer_of(const Simulation& simulation, const InterfaceModel& model, const Marching& marching) {
  const std::unique_ptr<Scheme> scheme = make_contact_scheme(model.system, model.ground);
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
                                options, 1., &model.system),
                       0.};
  Solution& solution = answer.solution;
  solution.response = model.read(std::move(solution.response), motions);
  solution.response.final_state = model.whole(solution.response.final_state);
  if (monitors->pressure) monitors->pressure->see(model.phi, model.pressures(motions), solution.response.ends.time);
  if (const std::optional<Mismatch> off = imbalance(simulation, solution)) throw NumericsError(Imbalance(*off).what());
  solution.contact = followed_by(recorder);
  solution.contact->found.solved->dissipated = solution.response.energy.back().friction;
  solution.response.energy.clear();  // W has no coordinates of its own: its drag would count as damping
  solution.monitors = monitors;
  answer.slip = solution.contact->found.solved->slip;
  return answer;
}

/// The largest difference of each reading at the times that both answers have: all but where one of them leapt.
Eigen::VectorXd differences(const Series& fine, const Series& coarse) {
  Eigen::VectorXd largest = Eigen::VectorXd::Zero(fine.reading.rows());
  std::size_t j = 0, shared = 0;
  for (std::size_t i = 0; i < fine.time.size(); ++i) {
    while (j + 1 < coarse.time.size() && coarse.time[j] < fine.time[i] - 1e-9) ++j;
    if (std::abs(coarse.time[j] - fine.time[i]) > 1e-9) continue;
    ++shared;
    largest = largest.cwiseMax(
        (fine.reading.col(static_cast<Eigen::Index>(i)) - coarse.reading.col(static_cast<Eigen::Index>(j))).cwiseAbs());
  }
  if (2 * shared < fine.time.size()) throw NumericsError("nested models of the ground were marched at other times");
  return largest;
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
    const double error = margin * apart[row] / peak[row];
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
  const double error = margin * std::abs(fine.pressure->value() - coarse.pressure->value()) / excess;
  ground.others = std::max(ground.others, error);
  if (error > ground.tolerance_of_others) ground.inexact.push_back({"the least pressure of the water", error});
}

/// The differences of two answers, with their margin.
ContactGround difference(const System& system, const ContactAnswer& fine, const ContactAnswer& coarse,
                         double tolerance) {
  const Series &ends = fine.solution.response.ends, &before = coarse.solution.response.ends;
  const Eigen::VectorXd apart = differences(ends, before), peaks = ends.reading.cwiseAbs().rowwise().maxCoeff();
  const Eigen::Index row = system.reading(reading::shear_force);
  const auto shear = ends.reading.row(row), other = before.reading.row(row);
  const double peak =
      std::max(std::abs(shear.maxCoeff() - other.maxCoeff()), std::abs(shear.minCoeff() - other.minCoeff()));
  const double history = peaks[row] > 0. ? apart[row] / peaks[row] : 0.;
  const double slip = std::abs(fine.solution.contact->found.solved->largest_slip);
  ContactGround ground;
  ground.slip = std::max(margin * std::abs(fine.slip - coarse.slip), least_share * history * slip);
  ground.peak_shear = peaks[row] > 0. ? std::max(margin * peak / peaks[row], least_share * history) : 0.;
  ground.history = margin * history;
  ground.tolerance_of_others = of_history * tolerance;
  find_inexact(system, apart, peaks, ground);
  find_inexact_pressure(*fine.solution.monitors, *coarse.solution.monitors, ground);
  std::sort(ground.inexact.begin(), ground.inexact.end(),
            [](const InexactReading& a, const InexactReading& b) { return a.error > b.error; });
  return ground;
}

/// Whether these errors are within what the scene allows of the answer.
bool meets(const ContactGround& error, const ContactAnswer& answer, double tolerance) {
  const double slip = std::abs(answer.solution.contact->found.solved->largest_slip);
  return error.peak_shear <= tolerance && error.slip <= tolerance * slip && error.history <= of_history * tolerance;
}

/// Directions of the bonded caisson's model, in the order in which they came; none where it has no basis.
Eigen::MatrixXd directions_of(const GrowingBasis* basis) {
  if (basis == nullptr) return {};
  const FieldBasis &u = basis->krylov().displacements(), &phi = basis->krylov().phi();
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(u.unknown.size() + phi.unknown.size()),
                                                  basis->krylov().n_coordinates());
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
  return "";
}

bool reduces_ground(const Simulation& simulation) {
  return simulation.scene().time.scheme == TimeScheme::reduced && why_ground_is_whole(simulation).empty();
}

Solution contact_on_reduced_ground(const Simulation& simulation, const Marching& marching, const BasisRoom* room) {
  const Stopwatch watch;
  const CompiledScene& compiled = *simulation.compiled();
  const double tolerance = whole_tolerance(simulation);
  const double shift = krylov_shift(simulation.scene());
  InterfaceSpace space(compiled.system, shift, compiled.body_coordinates, compiled.caisson_motions,
                       directions_of(room ? room->basis_about(shift, compiled.body_coordinates).get() : nullptr));
  std::optional<ContactAnswer> before;
  ContactGround error;
  for (int level = 0; level < InterfaceSpace::n_levels; ++level) {
    if (level > 0) space.extend();
    const InterfaceModel model = space.model();
    ContactAnswer answer = answer_of(simulation, model, marching);
    if (before) {
      error = difference(compiled.system, answer, *before, tolerance);
      error.coordinates = model.system.n_free();
      error.solves = space.n_solves();
      if (meets(error, answer, tolerance)) {
        answer.solution.contact->found.solved->ground = error;
        answer.solution.timing.march = watch.seconds();
        return std::move(answer.solution);
      }
    }
    before = std::move(answer);
  }
  throw NumericsError("nested models of the ground differ by " + significant(error.slip) + " m in S, " +
                      significant(error.peak_shear) + " of the peak of F_T, and " + significant(error.history) +
                      " of its largest magnitude at some time");
}

}  // namespace upbead
