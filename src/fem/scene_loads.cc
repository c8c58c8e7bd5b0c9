#include "fem/scene_loads.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>

#include "fem/faces.h"
#include "fem/moving_frame.h"
#include "fem/sides.h"
#include "fem/volume_loads.h"

namespace upbead {

using namespace dealii;

namespace {

/// Gauss points on a face that is split at the corners of the load's table of intensities, so that the integrand is a
/// polynomial on each part.
Quadrature<1> split_quadrature(const Load& load, const Point<dim>& from, const Point<dim>& to, unsigned n_points) {
  std::vector<double> ends{0., 1.};
  const double begin = shape_coordinate(load, from[0], from[1]), end = shape_coordinate(load, to[0], to[1]);
  for (const auto& [corner, value] : load.shape) {
    const double at = (corner - begin) / (end - begin);
    if (at > 0. && at < 1.) ends.push_back(at);
  }
  std::sort(ends.begin(), ends.end());
  const QGauss<1> gauss(n_points);
  std::vector<Point<1>> points;
  std::vector<double> weights;
  for (std::size_t s = 0; s + 1 < ends.size(); ++s)
    for (unsigned q = 0; q < gauss.size(); ++q) {
      points.emplace_back(ends[s] + (ends[s + 1] - ends[s]) * gauss.point(q)[0]);
      weights.push_back((ends[s + 1] - ends[s]) * gauss.weight(q));
    }
  return Quadrature<1>(points, weights);
}

/// Whether a load acts on a face of its curve: on an outer face, or on a face of a solid under free water.
bool acts_on(const Space& space, const Cell& cell, unsigned f) {
  if (cell->at_boundary(f)) return true;
  if (!cell->neighbor(f)->is_active()) return false;  // smaller cells of the same surface
  return space.kind(cell) != CellKind::water && space.kind(cell->neighbor(f)) == CellKind::water;
}

/// Calls visit(cell, values on the face) for every face on the load's curve that the load acts on.
template <typename Visit>
void for_each_face(const Space& space, const Load& load, UpdateFlags flags, const Visit& visit) {
  const unsigned n_points = static_cast<unsigned>(space.degree()) + 2;
  for (const auto& cell : space.dofs().active_cell_iterators())
    for (const unsigned f : cell->face_indices()) {
      if (space.mesh().curve_of(cell->face(f)) != load.boundary || !acts_on(space, cell, f)) continue;
      const auto quadrature = split_quadrature(load, cell->face(f)->vertex(0), cell->face(f)->vertex(1), n_points);
      FEFaceValues<dim> values(space.mapping(), cell->get_fe(), quadrature,
                               flags | update_quadrature_points | update_JxW_values);
      values.reinit(cell, f);
      visit(cell, values);
    }
}

/// Traction (total stress times normal) at a point of the curve, at f(t) = 1 (Pa).
Tensor<1, dim> traction(const Load& load, const Point<dim>& at, const Tensor<1, dim>& normal, double scale) {
  if (load.kind == LoadKind::pressure || load.kind == LoadKind::normal) return -intensity(load, at[0], at[1]) * normal;
  Tensor<1, dim> direction;
  for (unsigned d = 0; d < dim; ++d) direction[d] = load.direction[d];
  return scale * intensity(load, at[0], at[1]) * direction;
}

/// Integral of the relative intensity along the curve (m).
double total_intensity(const Space& space, const Load& load) {
  double total = 0.;
  for_each_face(space, load, update_default, [&](const Cell&, const FEFaceValues<dim>& values) {
    for (unsigned q = 0; q < values.n_quadrature_points; ++q)
      total += intensity(load, values.quadrature_point(q)[0], values.quadrature_point(q)[1]) * values.JxW(q);
  });
  return total;
}

/// Nodal forces of a load on a curve at f(t) = 1, by the region of the faces. The relative intensity is integrated
/// exactly: faces are split at the corners of its table. For a load of kind force the resultant is value times
/// direction.
std::map<std::string, NodalForces> curve_forces(const Space& space, const Load& load) {
  std::map<std::string, NodalForces> forces;
  const double scale = load.kind == LoadKind::force ? 1. / total_intensity(space, load) : 1.;
  const auto flags = update_values | update_normal_vectors;
  for_each_face(space, load, flags, [&](const Cell& cell, const FEFaceValues<dim>& values) {
    NodalForces& nodal = forces[space.mesh().surface_of(cell)];
    const Dofs dofs = dofs_of(cell);
    for (unsigned q = 0; q < values.n_quadrature_points; ++q) {
      const Tensor<1, dim> t = traction(load, values.quadrature_point(q), values.normal_vector(q), scale);
      for (unsigned i = 0; i < dofs.size(); ++i)
        if (const double part = values[u_part].value(i, q) * t * values.JxW(q); part != 0.) nodal[dofs[i]] += part;
    }
  });
  return forces;
}

/// The motion of an outcrop at the degrees of freedom of a cell.
dealii::Vector<double> outcrop(const Space& space, const Cell& cell, const FaceTerms& terms, const Load& load) {
  dealii::Vector<double> velocity(terms.matrices.C.n());
  for (unsigned i = 0; i < terms.dofs.size(); ++i)
    if (const auto [component, at] = node_of(space, cell, i); component < dim)
      velocity[i] = load.direction[component] * intensity(load, at[0], at[1]);
  return velocity;
}

/// The wave that a unit velocity of the outcrop below an absorbing side sends upward: the side's terms times that
/// velocity. Ground that moved with the outcrop would feel no force.
void add_arriving(const Scene& scene, const Space& space, const Unknowns& unknowns, const Load& load, Vector& vector) {
  for_each_absorbing_face(scene, space, [&](const Cell& cell, const std::string& curve, const FaceTerms& terms) {
    if (curve != load.boundary) return;
    dealii::Vector<double> force(terms.matrices.C.m());
    terms.matrices.C.vmult(force, outcrop(space, cell, terms, load));
    for (unsigned i = 0; i < terms.dofs.size(); ++i)
      for (const auto& [unknown, weight] : unknowns.expansion(terms.dofs[i])) vector[unknown] += weight * force[i];
  });
}

/// What the side's dashpots take together of two motions of its outcrop, per unit velocity of both.
double arriving_power(const Scene& scene, const Space& space, const Load& one, const Load& other) {
  double power = 0.;
  if (one.boundary == other.boundary)
    for_each_absorbing_face(scene, space, [&](const Cell& cell, const std::string& curve, const FaceTerms& terms) {
      if (curve != one.boundary) return;
      dealii::Vector<double> force(terms.matrices.C.m());
      terms.matrices.C.vmult(force, outcrop(space, cell, terms, other));
      power += outcrop(space, cell, terms, one) * force;
    });
  return power;
}

/// A force at a point of a rigid region, as loads on the body's coordinates.
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

/// Makes the system's loads, and their forces on the caisson and on the ground's nodes under it.
class LoadCompiler {
 public:
  LoadCompiler(const Scene& scene, const Space& space, const Unknowns& unknowns, const std::vector<Body>& bodies,
               const std::optional<Caisson>& caisson, const NodalReaction* ground)
      : scene_(scene), space_(space), unknowns_(unknowns), bodies_(bodies), caisson_(caisson), ground_(ground) {}

  void add(const std::string& name, const Load& load) {
    name_ = name;
    if (is_motion(load.kind)) {
      add_motion(name, load);
      return;
    }
    if (is_on_volume(load.kind)) {
      append({name, Vector::Zero(unknowns_.size()), load.history, -1});
      for (const auto& [region, nodal] : volume_forces(scene_, space_, load)) add_nodal(region, nodal);
      if (load.kind == LoadKind::gravity) add_weights(load);
      return;
    }
    if (!load.region.empty()) {
      append(body_load(name, load, unknowns_, bodies_));
      if (caisson_ && load.region == caisson_name) add_point_resultant(load.at, load.direction);
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
    out.of.push_back(name_);
    out.on_caisson.push_back({load.name});
    out.on_ground.push_back({});
    out.loads.push_back(std::move(load));
  }

  void add_motion(const std::string& name, const Load& load) {
    const int p = unknowns_.prescribed(name);
    append({name, Vector::Zero(unknowns_.size()), load.history, p});
    if (p < 0) {
      add_arriving(scene_, space_, unknowns_, load, out.loads.back().vector);
      hang(load, arriving_, out.frame_radiation);
    }
    if (!moves_frame(scene_, load)) return;
    const auto damping = damping_by_frame(space_, load);
    if (damping.empty()) return;
    append({name + ".damping", Vector::Zero(unknowns_.size()), load.history, -1});
    for (const auto& [region, nodal] : damping) add_nodal(region, nodal);
    hang(load, damped_, out.frame_damping);
  }

  /// Notes that the last load is that of dashpots on a frame which `load` moves.
  void hang(const Load& load, std::vector<const Load*>& frames, FrameDashpots& dashpots) {
    dashpots.loads.push_back(static_cast<int>(out.loads.size()) - 1);
    frames.push_back(&load);
    const auto n = static_cast<Eigen::Index>(frames.size());
    dashpots.own.conservativeResize(n, n);
    for (Eigen::Index k = 0; k < n; ++k)
      dashpots.own(k, n - 1) = dashpots.own(n - 1, k) =
          &frames == &arriving_ ? arriving_power(scene_, space_, *frames[static_cast<std::size_t>(k)], load)
                                : frame_damping(space_, *frames[static_cast<std::size_t>(k)], load);
  }

  /// Adds the resultant of a force on the rigid caisson.
  void add_point_resultant(const std::array<double, 2>& at, const std::array<double, 2>& force) {
    LoadOnCaisson& resultant = out.on_caisson.back();
    const auto rotation = unit_motion(motion_rotation, Point<dim>(at[0], at[1]), caisson_->bottom_centre);
    resultant.force_x += force[0];
    resultant.force_y += force[1];
    resultant.moment += rotation[0] * force[0] + rotation[1] * force[1];
  }

  /// Adds the weights of rigid bodies, by their masses.
  void add_weights(const Load& load) {
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      const Body& body = bodies_[b];
      if (!acts_on(load, body.region)) continue;
      out.loads.back().vector[unknowns_.coordinate(b, motion_y)] -= body.mass;
      if (caisson_ && body.region == caisson_name)
        add_point_resultant({body.centre[0], body.centre[1]}, {0., -body.mass});
    }
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

  const Scene& scene_;
  const Space& space_;
  const Unknowns& unknowns_;
  const std::vector<Body>& bodies_;
  const std::optional<Caisson>& caisson_;
  const NodalReaction* ground_;
  std::string name_;                            ///< of the load that is added
  std::vector<const Load*> arriving_, damped_;  ///< motions of frames that dashpots hang on
};

}  // namespace

namespace {

/// Where on the lowest face of a wall a load begins, as seen from the foot: 0 at the foot, 1 at the face's upper end,
/// and a hair above that place where it is not the foot, as a shape that is to begin there may begin a last digit above
/// the node. A load that begins a little above the foot, which the face spreads to it, counts from there; one that
/// begins higher has no pressure at the foot.
double begin_on_face(const Load& load, const Point<dim>& foot, const Point<dim>& upper) {
  constexpr double hair = 1e-9, little = 0.1;
  const double from = shape_coordinate(load, foot[0], foot[1]), to = shape_coordinate(load, upper[0], upper[1]);
  if (load.shape.empty() || from == to) return 0.;
  const double begin = ((to > from ? load.shape.front() : load.shape.back())[0] - from) / (to - from);
  return begin > 0. && begin < little ? begin + hair : 0.;
}

}  // namespace

double pressure_at_foot(const Space& space, const Load& load, const Point<dim>& foot) {
  for (const auto& cell : space.dofs().active_cell_iterators())
    for (const unsigned f : cell->face_indices()) {
      const auto face = cell->face(f);
      if (space.mesh().surface_of(cell) != caisson_name || space.mesh().curve_of(face) != load.boundary) continue;
      const double close = 1e-6 * face->measure();
      const bool first = face->vertex(0).distance(foot) <= close;
      if (!first && face->vertex(1).distance(foot) > close) continue;
      const Tensor<1, dim> along = (face->vertex(1) - face->vertex(0)) / face->measure();
      Tensor<1, dim> normal({along[1], -along[0]});
      if (normal * (face->center() - cell->center()) < 0.) normal *= -1.;
      const double scale = load.kind == LoadKind::force ? 1. / total_intensity(space, load) : 1.;
      const Point<dim> upper = face->vertex(first ? 1 : 0);
      const Point<dim> at = foot + begin_on_face(load, foot, upper) * (upper - foot);
      return -(traction(load, at, normal, scale) * normal);
    }
  return 0.;
}

SceneLoads compile_loads(const Scene& scene, const Space& space, const Unknowns& unknowns,
                         const std::vector<Body>& bodies, const std::optional<Caisson>& caisson,
                         const NodalReaction* ground) {
  LoadCompiler compiler(scene, space, unknowns, bodies, caisson, ground);
  for (const auto& [name, load] : scene.loads)
    if (load.factor != 0.) compiler.add(name, load);
  return std::move(compiler.out);
}

}  // namespace upbead
