#include "fem/sides.h"

#include <set>

namespace upbead {

using namespace dealii;

namespace {

void integrate(const FEFaceValues<dim>& fe, const Impedance& z, FullMatrix<double>& C) {
  for (unsigned q = 0; q < fe.n_quadrature_points; ++q) {
    const auto n = fe.normal_vector(q);
    for (unsigned i = 0; i < fe.dofs_per_cell; ++i)
      for (unsigned j = 0; j < fe.dofs_per_cell; ++j) {
        const auto du = fe[u_part].value(i, q), u = fe[u_part].value(j, q);
        const double dphi = fe[phi_part].value(i, q), phi = fe[phi_part].value(j, q);
        const double du_n = du * n, u_n = u * n;
        C(i, j) += (z.normal * du_n * u_n + z.tangential * (du * u - du_n * u_n) +
                    z.coupling * (du_n * phi + dphi * u_n) - z.mobility * dphi * phi) *
                   fe.JxW(q);
      }
  }
}

/// The part of the impedance that applies to a side with these conditions.
Impedance of_side(const Space& space, const Cell& cell, const Boundary& side) {
  const bool moves = side.displacement == DisplacementCondition::absorbing;
  const bool flows = side.pressure == PressureCondition::absorbing;
  const bool water = space.kind(cell) == CellKind::water;
  Impedance z;
  if (flows || (moves && !water)) z = space.impedance(cell, flows);
  if (water) return z;
  if (!moves) z.normal = z.tangential = z.coupling = 0.;
  if (side.dashpot) {
    z.normal += (*side.dashpot)[0];
    z.tangential += (*side.dashpot)[1];
  }
  return z;
}

}  // namespace

void for_each_absorbing_face(
    const Scene& scene, const Space& space,
    const std::function<void(const Cell&, const std::string& curve, const FaceTerms&)>& visit) {
  FaceTerms terms;
  for_each_outer_face(space, [&](const Cell& cell, unsigned f, const std::string& curve) {
    const Boundary& side = scene.boundaries.at(curve);
    if (side.displacement != DisplacementCondition::absorbing && side.pressure != PressureCondition::absorbing &&
        !side.dashpot)
      return;
    if (space.region(cell).kind == RegionKind::rigid) return;
    terms.reinit({cell});
    integrate(FaceValues(space, cell, f), of_side(space, cell, side), terms.matrices.C);
    visit(cell, curve, terms);
  });
}

void for_each_sprung_face(const Scene& scene, const Space& space, const VisitFace& visit) {
  FaceTerms terms;
  for_each_outer_face(space, [&](const Cell& cell, unsigned f, const std::string& curve) {
    const Boundary& side = scene.boundaries.at(curve);
    if (!side.spring || !space.has_matrices(cell) || space.kind(cell) == CellKind::water) return;
    terms.reinit({cell});
    integrate(FaceValues(space, cell, f), {(*side.spring)[0], (*side.spring)[1]}, terms.matrices.K);
    visit(terms);
  });
}

void for_each_surface_face(const Scene& scene, const Space& space, const VisitFace& visit) {
  FaceTerms terms;
  for_each_outer_face(space, [&](const Cell& cell, unsigned f, const std::string& curve) {
    if (scene.boundaries.at(curve).pressure != PressureCondition::surface_waves) return;
    if (space.kind(cell) != CellKind::water) return;
    terms.reinit({cell});
    const FaceValues fe(space, cell, f);
    for (unsigned q = 0; q < fe.n_quadrature_points; ++q)
      for (unsigned i = 0; i < fe.dofs_per_cell; ++i)
        for (unsigned j = 0; j < fe.dofs_per_cell; ++j)
          terms.matrices.M(i, j) -=
              fe[phi_part].value(i, q) * fe[phi_part].value(j, q) * fe.JxW(q) / (scene.fluid.density * scene.gravity);
    visit(terms);
  });
}

namespace {

/// Curves of loads that were measured while the wall moved.
std::set<std::string> measured_walls(const Scene& scene) {
  std::set<std::string> walls;
  for (const auto& [name, load] : scene.loads)
    if (load.measured_on_wall && load.factor != 0.) walls.insert(load.boundary);
  return walls;
}

/// up_C and pu_C of one face; rows are those of the solid's cell, then those of the water's.
void integrate(const FEFaceValues<dim>& solid, const FEFaceValues<dim>& water, FullMatrix<double>& C) {
  for (unsigned q = 0; q < solid.n_quadrature_points; ++q)
    for (unsigned i = 0; i < solid.dofs_per_cell; ++i) {
      const double u_n = solid[u_part].value(i, q) * solid.normal_vector(q);
      if (u_n == 0.) continue;
      for (unsigned j = 0; j < water.dofs_per_cell; ++j) {
        const double part = u_n * water[phi_part].value(j, q) * solid.JxW(q);
        C(i, solid.dofs_per_cell + j) += part;
        C(solid.dofs_per_cell + j, i) += part;
      }
    }
}

}  // namespace

void for_each_wet_face_term(const Scene& scene, const Space& space,
                            const std::function<void(const WetFace&, const FaceTerms&)>& visit) {
  const std::set<std::string> measured = measured_walls(scene);
  FaceTerms terms;
  for_each_wet_face(space, [&](const WetFace& face) {
    if (measured.count(space.mesh().curve_of(face.solid->face(face.face)))) return;
    terms.reinit({face.solid, face.water});
    terms.of_caisson = space.mesh().surface_of(face.solid) == caisson_name;
    integrate(FaceValues(space, face.solid, face.face), FaceValues(space, face.water, face.water_face),
              terms.matrices.C);
    visit(face, terms);
  });
}

}  // namespace upbead
