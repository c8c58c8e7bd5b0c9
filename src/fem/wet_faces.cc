#include "fem/wet_faces.h"

#include <set>

namespace upbead {

using namespace dealii;

namespace {

/// Curves on which a load was measured while the wall moved.
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
