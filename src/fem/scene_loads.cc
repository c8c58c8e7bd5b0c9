#include "fem/scene_loads.h"

#include <cmath>

#include "fem/face_loads.h"

namespace upbead {

using namespace dealii;

namespace {

/// A force at a point of a rigid region, on that body's coordinates.
SystemLoad body_load(const std::string& name, const Load& load, const Unknowns& unknowns,
                     const std::vector<Body>& bodies) {
  SystemLoad out{name, Vector::Zero(unknowns.size()), load.history, -1};
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if (bodies[b].region != load.region) continue;
    for (int m = 0; m < n_motions; ++m) {
      const auto motion = unit_motion(m, Point<dim>(load.at[0], load.at[1]), bodies[b].centre);
      out.vector[unknowns.coordinate(b, m)] = motion[0] * load.direction[0] + motion[1] * load.direction[1];
    }
  }
  return out;
}

/// Loads of the system and what they do to the caisson and to the ground's nodes under it.
class LoadCompiler {
 public:
  LoadCompiler(const Space& space, const Unknowns& unknowns, const std::vector<Body>& bodies,
               const std::optional<Caisson>& caisson, const NodalReaction* ground)
      : space_(space), unknowns_(unknowns), bodies_(bodies), caisson_(caisson), ground_(ground) {}

  void add(const std::string& name, const Load& load) {
    if (!load.region.empty()) {
      append(body_load(name, load, unknowns_, bodies_));
      if (caisson_ && load.region == caisson_name) add_point_resultant(load);
      return;
    }
    append({name, Vector::Zero(unknowns_.size()), load.history, -1});
    for (const auto& [region, nodal] : curve_forces(space_, load)) add_nodal(region, nodal);
    if (const int p = unknowns_.prescribed(name); p >= 0)
      append({name + ".pore_pressure", Vector::Zero(unknowns_.size()), load.history, p});
  }

  SceneLoads out;

 private:
  void append(SystemLoad load) {
    out.on_caisson.push_back({load.name});
    out.on_ground.push_back({});
    out.loads.push_back(std::move(load));
  }

  void add_point_resultant(const Load& load) {
    LoadOnCaisson& resultant = out.on_caisson.back();
    const auto rotation = unit_motion(motion_rotation, Point<dim>(load.at[0], load.at[1]), caisson_->bottom_centre);
    resultant.force_x = load.direction[0];
    resultant.force_y = load.direction[1];
    resultant.moment = rotation[0] * load.direction[0] + rotation[1] * load.direction[1];
  }

  void add_nodal(const std::string& region, const NodalForces& nodal) {
    for (const auto& [dof, force] : nodal) {
      const Row& row = region == caisson_name ? unknowns_.caisson_expansion(dof) : unknowns_.expansion(dof);
      for (const auto& [unknown, weight] : row) out.loads.back().vector[unknown] += weight * force;
    }
    if (!ground_) return;
    if (region != caisson_name) {
      for (const auto& [dof, force] : nodal) out.on_ground.back()[dof] += force;
      return;
    }
    out.on_caisson.back().force_x += ground_->sum(motion_x, nodal);
    out.on_caisson.back().force_y += ground_->sum(motion_y, nodal);
    out.on_caisson.back().moment += ground_->sum(motion_rotation, nodal);
  }

  const Space& space_;
  const Unknowns& unknowns_;
  const std::vector<Body>& bodies_;
  const std::optional<Caisson>& caisson_;
  const NodalReaction* ground_;
};

}  // namespace

SceneLoads compile_loads(const Scene& scene, const Space& space, const Unknowns& unknowns,
                         const std::vector<Body>& bodies, const std::optional<Caisson>& caisson,
                         const NodalReaction* ground) {
  LoadCompiler compiler(space, unknowns, bodies, caisson, ground);
  for (const auto& [name, load] : scene.loads)
    if (load.factor != 0.) compiler.add(name, load);
  return std::move(compiler.out);
}

}  // namespace upbead
