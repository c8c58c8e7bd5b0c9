#include "upbead/fem/open_sides.h"

namespace upbead {

using namespace dealii;

namespace {

/// A load that prescribes the pressure on a face, and the unknown that does it.
struct Prescribed {
  const Load* load;
  int unknown;
};

std::vector<Prescribed> prescribed_on(const std::string& curve, const Scene& scene, const Unknowns& unknowns) {
  std::vector<Prescribed> found;
  for (const auto& [name, load] : scene.loads)
    if (const int unknown = unknowns.prescribed(name); unknown >= 0 && load.boundary == curve)
      found.push_back({&load, unknown});
  return found;
}

/// Values at one point of a face of all rows: the cell's degrees of freedom, then the prescribed pressures.
struct Traces {
  std::vector<double> jump;  ///< [phi]
  std::vector<double> flux;  ///< grad phi . n
  std::vector<double> W;     ///< W . n
};

Traces traces_at(const FEFaceValues<dim>& fe, unsigned q, bool has_W, const std::vector<Prescribed>& prescribed) {
  const unsigned n = fe.dofs_per_cell;
  const std::vector<double> zeros(n + prescribed.size(), 0.);
  Traces traces{zeros, zeros, zeros};
  const auto normal = fe.normal_vector(q);
  for (unsigned i = 0; i < n; ++i) {
    traces.jump[i] = fe[phi_part].value(i, q);
    traces.flux[i] = fe[phi_part].gradient(i, q) * normal;
    if (has_W) traces.W[i] = fe[W_part].value(i, q) * normal;
  }
  for (std::size_t l = 0; l < prescribed.size(); ++l)
    traces.jump[n + l] = -intensity(*prescribed[l].load, fe.quadrature_point(q)[1]);
  return traces;
}

/// The penalty g of degree k of phi. Darcy: it must exceed k^2, the constant of the trace inequality of grad phi on a
/// rectangle. Inertial: where drag rules, W = -(1/b) (grad phi - r) with r the function of W's space whose integral
/// against W is that of W.n [phi] over the side; eliminating W brings (k + 1)^2/h [phi]^2 by itself. What is added
/// makes both flows drain alike.
double penalty(int degree_of_u, bool inertial) {
  const double k = degree_of_u - 1, darcy = 2. * k * (k + 1.);
  return inertial ? darcy - (k + 1.) * (k + 1.) : darcy;
}

void integrate(const FEFaceValues<dim>& fe, bool inertial, double mobility, double penalty_over_h,
               const std::vector<Prescribed>& prescribed, FullMatrix<double>& C) {
  const unsigned n = fe.dofs_per_cell + static_cast<unsigned>(prescribed.size());
  for (unsigned q = 0; q < fe.n_quadrature_points; ++q) {
    const Traces t = traces_at(fe, q, inertial, prescribed);
    for (unsigned i = 0; i < n; ++i)
      for (unsigned j = 0; j < n; ++j) {
        double value = -mobility * penalty_over_h * t.jump[i] * t.jump[j];
        value += inertial ? -t.W[i] * t.jump[j] - t.jump[i] * t.W[j]
                          : mobility * (t.jump[i] * t.flux[j] + t.flux[i] * t.jump[j]);
        C(i, j) += value * fe.JxW(q);
      }
  }
}

/// Whether pore water drains freely through a face, to the outside or into a drained region.
bool is_open(const Scene& scene, const Space& space, const Cell& cell, unsigned f) {
  if (cell->at_boundary(f))
    return scene.boundaries.at(space.mesh().curve_of(cell->face(f))).pressure == PressureCondition::open;
  if (!cell->neighbor(f)->is_active()) return false;  // smaller cells of its own surface
  const Region& other = space.region(cell->neighbor(f));
  return other.kind == RegionKind::porous && other.flow == Flow::drained;
}

}  // namespace

void for_each_open_face(const Scene& scene, const Space& space, const Unknowns& unknowns, const VisitFace& visit) {
  FaceTerms terms;
  for (const auto& cell : space.dofs().active_cell_iterators()) {
    if (!space.has_pores(cell)) continue;
    for (const unsigned f : cell->face_indices()) {
      if (!is_open(scene, space, cell, f)) continue;
      const auto prescribed = prescribed_on(space.mesh().curve_of(cell->face(f)), scene, unknowns);
      std::vector<int> unknowns_here;
      for (const Prescribed& load : prescribed) unknowns_here.push_back(load.unknown);
      terms.reinit({cell}, unknowns_here);
      const double h = cell->measure() / cell->face(f)->measure();
      const bool inertial = space.kind(cell) == CellKind::inertial;
      const Material constants = material(space.region(cell), scene.fluid, scene.gravity);
      integrate(FaceValues(space, cell, f), inertial, 1. / constants.b, penalty(space.degree(), inertial) / h,
                prescribed, terms.matrices.C);
      visit(terms);
    }
  }
}

}  // namespace upbead
