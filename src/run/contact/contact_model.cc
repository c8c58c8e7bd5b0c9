#include "run/contact/contact_model.h"

#include "base/stopwatch.h"
#include "fem/caisson/readings.h"
#include "response/reduction.h"
#include "run/contact/contact_run.h"
#include "run/contact/reduced_ground.h"
#include "run/derived.h"
#include "system/interface.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

/// What stands against such a model.
std::string why_no_model(const Simulation& simulation) {
  const Scene& scene = simulation.scene();
  if (follows_strain(scene) || follows_velocity(scene)) return "soil follows the strain of each wave";
  if (const auto& sliding = scene.sliding; sliding && sliding->uplift)
    if (sliding->uplift->kind == UpliftKind::prescribed && !sliding->uplift->peak)
      return "the uplift is a record of the case's own wave";
  const System& system = simulation.system();
  if (!system.frame_damping.loads.empty() || !system.frame_radiation.loads.empty()) return "loads move the ground";
  return why_ground_is_whole(simulation);
}

Eigen::MatrixXd rows_of(const System& system, const Eigen::MatrixXd& all) {
  Eigen::MatrixXd rows(GroundModel::readings.size(), all.cols());
  for (std::size_t i = 0; i < GroundModel::readings.size(); ++i)
    if (all.cols() > 0) rows.row(static_cast<Eigen::Index>(i)) = all.row(system.reading(GroundModel::readings[i]));
  return rows;
}

GroundLevel level_of(const System& whole, const ReducedGround::Level& from) {
  const InterfaceModel& model = from.model;
  const GroundMatrices& A = model.ground;
  GroundLevel level{A.M_ff, A.C_ff, A.K_ff, A.U, A.M_f, A.C_f, A.K_f, {}, {}, {}, {}, {}, {}, from.n_solves};
  for (int i = 0; i < A.n_free(); ++i)
    level.is_phi.push_back(model.system.field[static_cast<std::size_t>(i)] == Field::pressure_impulse);
  level.load.resize(model.system.size(), static_cast<Eigen::Index>(whole.loads.size()));
  for (std::size_t k = 0; k < whole.loads.size(); ++k)
    level.load.col(static_cast<Eigen::Index>(k)) = model.system.loads[k].vector;
  level.position = rows_of(whole, model.position);
  level.velocity = rows_of(whole, model.velocity);
  level.acceleration = rows_of(whole, model.acceleration);
  level.feedthrough = rows_of(whole, model.feedthrough).leftCols(level.load.cols());
  return level;
}

/// The last readings of a model of the bonded caisson: the forces at its nodes.
ModalModel forces_at_nodes(const ModalModel& model, int n_nodes) {
  std::vector<int> last;
  for (int i = model.n_readings() - 2 * n_nodes; i < model.n_readings(); ++i) last.push_back(i);
  return model.with_readings(last);
}

/// Adds up the columns of loads of one history, as join_pore_pressures() does.
void join_loads(GroundModel& model) {
  const std::vector<std::string> names = model.demand.load_name;
  join_pore_pressures(model.demand);
  const auto joined = [&](const Eigen::MatrixXd& all) {
    if (all.cols() == 0) return all;
    Eigen::MatrixXd out = Eigen::MatrixXd::Zero(all.rows(), model.demand.n_loads());
    Eigen::Index to = -1;
    for (std::size_t k = 0; k < names.size(); ++k) {
      if (to + 1 < out.cols() && names[k] == model.demand.load_name[static_cast<std::size_t>(to + 1)]) ++to;
      out.col(to) += all.col(static_cast<Eigen::Index>(k));
    }
    return out;
  };
  for (GroundLevel& level : model.levels) {
    level.load = joined(level.load);
    level.feedthrough = joined(level.feedthrough);
  }
}

/// Force and arm of each load of the model; a pore pressure that was joined does not press on the caisson.
Eigen::MatrixXd on_caisson(const CompiledScene& compiled, const std::vector<std::string>& names) {
  const Caisson& caisson = *compiled.caisson;
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(names.size()), 2);
  for (std::size_t i = 0; i < names.size(); ++i)
    for (std::size_t k = 0; k < compiled.loads_on_caisson.size(); ++k) {
      const LoadOnCaisson& load = compiled.loads_on_caisson[k];
      if (compiled.system.loads[k].name != names[i] || !load.arm()) continue;
      const double above = caisson.body.centre[1] - caisson.bottom_centre[1];
      out.row(static_cast<Eigen::Index>(i)) << load.force_x, *load.arm() - above;
    }
  return out;
}

/// Forces of the nodes for U = 1 under waves that push landward and seaward.
Eigen::MatrixXd uplift_of(const Simulation& simulation, const Interface& interface) {
  Eigen::MatrixXd out(interface.n_nodes(), 2);
  const auto& sliding = simulation.scene().sliding;
  if (!sliding || !sliding->uplift || sliding->uplift->kind != UpliftKind::prescribed) return out.setZero();
  for (int side = 0; side < 2; ++side)
    out.col(side) = uplift_of_peak(simulation, interface.position, interface.length, side == 1).node;
  return out;
}

/// With their error; where the bonded caisson was marched, of a model made for them.
void set_demand(const BondedContact& bonded, const std::function<void(double)>& progress, GroundModel& model) {
  const int n = model.interface.n_nodes();
  model.margin = bonded.margin;
  if (bonded.solution.model) {
    model.demand = forces_at_nodes(*bonded.solution.model, n);
    return;
  }
  ReductionTargets targets;
  targets.each_load = true;
  const Reduction reduction = reduce_scene(bonded.solution.simulation->scene(), *bonded.tied, targets, progress);
  require_converged(reduction);
  model.margin = reduction.error.others;
  model.demand = forces_at_nodes(reduction.model, n);
}

std::shared_ptr<const GroundModel> made(const Simulation& given, const std::function<void(double)>& progress) {
  const Simulation simulation =
      given.with([](auto& parts) { parts.scene.time.scheme = parts.given.time.scheme = TimeScheme::reduced; });
  Marching marching;
  marching.beside = progress;
  const BondedContact bonded = solve_bonded(simulation, marching);
  const System& system = bonded.sliding->system;
  const auto model = std::make_shared<GroundModel>();
  model->interface = *system.interface;
  set_demand(bonded, progress, *model);
  model->shift = shift_of_ground(simulation.scene());
  const Simulation moving = with_system(simulation, bonded.sliding);
  ReducedGround& ground = ground_of(moving, *bonded.room, bonded.solution.reduction.has_value());
  for (int i = 0; i < InterfaceSpace::n_levels; ++i) {
    const ReducedGround::Level& level = ground.level(i, system);
    const GroundMatrices& A = level.model.ground;
    model->of_interface = {A.M_ii, A.C_ii, A.K_ii};
    model->levels.push_back(level_of(system, level));
  }
  join_loads(*model);
  model->uplift = uplift_of(simulation, model->interface);
  model->on_caisson = on_caisson(*bonded.sliding, model->demand.load_name);
  model->tolerance = whole_tolerance(simulation);
  model->step = simulation.scene().time.step.value_or(0.);
  return model;
}

}  // namespace

ContactModelMade contact_model(const Simulation& simulation, const std::function<void(double)>& progress) {
  ContactModelMade out;
  if (!simulation.with_interface()) return out;
  const Stopwatch watch;
  out.why_not = why_no_model(simulation);
  if (out.why_not.empty()) try {
      out.model = made(simulation, progress);
    } catch (const NumericsError& error) {
      out.why_not = error.what();
    }
  out.seconds = watch.seconds();
  return out;
}

}  // namespace upbead
