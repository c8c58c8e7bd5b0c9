#include "fem/sides.h"

#include <deal.II/base/quadrature_lib.h>

#include <Eigen/Eigenvalues>
#include <algorithm>

namespace upbead {

using namespace dealii;

namespace {

/// A load that prescribes the pressure on a face, and its unknown.
struct Prescribed {
  const Load* load;
  int unknown;
};

std::vector<Prescribed> prescribed_on(const std::string& curve, const Scene& scene, const Unknowns& unknowns) {
  std::vector<Prescribed> found;
  for (const auto& [name, load] : scene.loads)
    if (const int unknown = unknowns.prescribed(name); unknown >= 0 && load.boundary == curve && !is_motion(load.kind))
      found.push_back({&load, unknown});
  return found;
}

/// Values at one point of a face, for all rows: the cell's degrees of freedom, then the prescribed pressures.
struct Traces {
  std::vector<double> jump;  ///< [phi]
  std::vector<double> flux;  ///< grad phi . n; the vertical part of the gradient times k_y/k_x
  std::vector<double> W;     ///< W . n
};

Traces traces_at(const FEFaceValues<dim>& fe, unsigned q, bool has_W, double vertical_flow,
                 const std::vector<Prescribed>& prescribed) {
  const unsigned n = fe.dofs_per_cell;
  const std::vector<double> zeros(n + prescribed.size(), 0.);
  Traces traces{zeros, zeros, zeros};
  const auto normal = fe.normal_vector(q);
  for (unsigned i = 0; i < n; ++i) {
    traces.jump[i] = fe[phi_part].value(i, q);
    Tensor<1, dim> gradient = fe[phi_part].gradient(i, q);
    gradient[1] *= vertical_flow;
    traces.flux[i] = gradient * normal;
    if (has_W) traces.W[i] = fe[W_part].value(i, q) * normal;
  }
  for (std::size_t l = 0; l < prescribed.size(); ++l)
    traces.jump[n + l] = -intensity(*prescribed[l].load, fe.quadrature_point(q)[0], fe.quadrature_point(q)[1]);
  return traces;
}

/// The penalty g for degree k of phi. Darcy: g must exceed k^2, the constant of the trace inequality of grad phi on a
/// rectangle. Inertial: where drag dominates, W = -(1/b) (grad phi - r), with r the function of W's space whose
/// integral against W is that of W.n [phi] over the side; elimination of W then gives a term (k + 1)^2/h [phi]^2. The
/// penalty is reduced by that, so that both flows drain alike.
double penalty(int degree_of_u, bool inertial) {
  const double k = degree_of_u - 1, darcy = 2. * k * (k + 1.);
  return inertial ? darcy - (k + 1.) * (k + 1.) : darcy;
}

void integrate(const FEFaceValues<dim>& fe, bool inertial, const Material& material, double penalty_over_h,
               const std::vector<Prescribed>& prescribed, FullMatrix<double>& C) {
  const double mobility = material.mobility;
  const unsigned n = fe.dofs_per_cell + static_cast<unsigned>(prescribed.size());
  for (unsigned q = 0; q < fe.n_quadrature_points; ++q) {
    const Traces t = traces_at(fe, q, inertial, material.vertical_flow, prescribed);
    const double along_normal = material.flow_along(fe.normal_vector(q)[1]);
    for (unsigned i = 0; i < n; ++i)
      for (unsigned j = 0; j < n; ++j) {
        double value = -mobility * along_normal * penalty_over_h * t.jump[i] * t.jump[j];
        value += inertial ? -t.W[i] * t.jump[j] - t.jump[i] * t.W[j]
                          : mobility * (t.jump[i] * t.flux[j] + t.flux[i] * t.jump[j]);
        C(i, j) += value * fe.JxW(q);
      }
  }
}

/// An open face of a cell, and its penalty over h.
struct OpenFace {
  unsigned number;
  double penalty_over_h;
};

template <class Values>
double flux(const Values& fe, unsigned q, const Tensor<1, dim>& gradient, const Material& m) {
  const Tensor<1, dim> normal = fe.get_normal_vectors()[q];
  return gradient * normal / std::sqrt(m.flow_along(normal[1]));
}

/// Gradients of phi times the root of the point's weight: of a face their flux along its normals over the root of k
/// along these, or both components times the roots of k along x and y; k over k_x. One row for each degree of freedom
/// but the first, as a constant phi has no gradient; the squares of the rows are integrals.
template <class Values>
Eigen::MatrixXd gradients(const Values& fe, const std::vector<unsigned>& phi, bool normal_only, const Material& m) {
  const unsigned n = normal_only ? 1 : dim;
  const double of_vertical = normal_only ? m.vertical_flow : std::sqrt(m.vertical_flow);
  Eigen::MatrixXd table(phi.size() - 1, n * fe.n_quadrature_points);
  for (unsigned i = 1; i < phi.size(); ++i)
    for (unsigned q = 0; q < fe.n_quadrature_points; ++q) {
      Tensor<1, dim> gradient = std::sqrt(fe.JxW(q)) * fe[phi_part].gradient(phi[i], q);
      gradient[1] *= of_vertical;
      for (unsigned d = 0; d < n; ++d) table(i - 1, n * q + d) = normal_only ? flux(fe, q, gradient, m) : gradient[d];
    }
  return table;
}

/// Raises the penalties of a cell of Darcy flow, all by one factor, where the cell is so distorted that
///
///     sum over its open faces of (h/g) |grad phi.n|^2 <= share |grad phi|^2,  share < 1,
///
/// does not hold; C would not be definite then. The largest ratio of both sides is an eigenvalue of the cell (Embar,
/// Dolbow and Harari, Int. J. Numer. Methods Eng. 83 (2010) 877); on rectangles it is below `share`.
void make_definite(const Space& space, const Cell& cell, std::vector<OpenFace>& faces) {
  constexpr double share = 0.75;
  std::vector<unsigned> phi;
  const auto& element = cell->get_fe();
  for (unsigned i = 0; i < element.n_dofs_per_cell(); ++i)
    if (element.component_mask(phi_part)[element.system_to_component_index(i).first]) phi.push_back(i);
  FEValues<dim> inside(space.mapping(), element, QGauss<dim>(static_cast<unsigned>(space.degree()) + 1),
                       update_gradients | update_JxW_values);
  inside.reinit(typename Triangulation<dim>::cell_iterator(cell));
  const Eigen::MatrixXd all = gradients(inside, phi, false, space.material(cell));
  Eigen::MatrixXd fluxes = Eigen::MatrixXd::Zero(all.rows(), all.rows());
  for (const OpenFace& face : faces) {
    const Eigen::MatrixXd flux = gradients(FaceValues(space, cell, face.number), phi, true, space.material(cell));
    fluxes += flux * flux.transpose() / face.penalty_over_h;
  }
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> ratio(fluxes, all * all.transpose(),
                                                                        Eigen::EigenvaluesOnly | Eigen::Ax_lBx);
  const double factor = std::max(1., ratio.eigenvalues().maxCoeff() / share);
  for (OpenFace& face : faces) face.penalty_over_h *= factor;
}

std::vector<OpenFace> open_faces(const Scene& scene, const Space& space, const Cell& cell) {
  std::vector<OpenFace> faces;
  const bool inertial = space.kind(cell) == CellKind::inertial;
  for (const unsigned f : cell->face_indices())
    if (drains(scene, space, cell, f)) {
      const double h = area_of(cell) / cell->face(f)->measure();
      faces.push_back({f, penalty(space.degree(), inertial) / h});
    }
  if (!inertial && !faces.empty()) make_definite(space, cell, faces);
  return faces;
}

}  // namespace

bool drains(const Scene& scene, const Space& space, const Cell& cell, unsigned f) {
  if (cell->at_boundary(f))
    return scene.boundaries.at(space.mesh().curve_of(cell->face(f))).pressure == PressureCondition::open;
  if (!cell->neighbor(f)->is_active()) return false;  // smaller cells of the same surface
  const Region& other = space.region(cell->neighbor(f));
  return other.kind == RegionKind::porous && other.flow == Flow::drained;
}

void for_each_open_face(const Scene& scene, const Space& space, const Unknowns& unknowns, const VisitFace& visit) {
  FaceTerms terms;
  for (const auto& cell : space.dofs().active_cell_iterators()) {
    if (!space.has_pores(cell)) continue;
    for (const auto& [f, penalty_over_h] : open_faces(scene, space, cell)) {
      const auto prescribed = prescribed_on(space.mesh().curve_of(cell->face(f)), scene, unknowns);
      std::vector<int> unknowns_here;
      for (const Prescribed& load : prescribed) unknowns_here.push_back(load.unknown);
      terms.reinit({cell}, unknowns_here);
      const bool inertial = space.kind(cell) == CellKind::inertial;
      integrate(FaceValues(space, cell, f), inertial, space.material(cell), penalty_over_h, prescribed,
                terms.matrices.C);
      visit(terms);
    }
  }
}

}  // namespace upbead
