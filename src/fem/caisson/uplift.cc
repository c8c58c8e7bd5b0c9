#include "fem/caisson/uplift.h"

namespace upbead {

using namespace dealii;

namespace {

using Entries = std::array<std::map<int, double>, n_motions>;

void add_face(const Space& space, const Unknowns& unknowns, const Point<dim>& about, const Cell& ground, unsigned f,
              Entries& entries) {
  const FaceValues fe(space, ground, f);
  std::vector<types::global_dof_index> dofs(fe.dofs_per_cell);
  ground->get_dof_indices(dofs);
  for (unsigned i = 0; i < dofs.size(); ++i)
    for (int m = 0; m < n_motions; ++m) {
      double work = 0.;  // the ground's outward normal points into the caisson
      for (unsigned q = 0; q < fe.n_quadrature_points; ++q)
        work += fe[phi_part].value(i, q) * (fe.normal_vector(q) * unit_motion(m, fe.quadrature_point(q), about)) *
                fe.JxW(q);
      if (work != 0.) unknowns.add_to(entries[m], static_cast<unsigned>(dofs[i]), work);
    }
}

}  // namespace

std::array<Row, n_motions> uplift_rows(const Space& space, const Unknowns& unknowns, const Caisson& caisson) {
  Entries entries;
  for (const auto& cell : space.dofs().active_cell_iterators()) {
    if (!space.has_pores(cell)) continue;
    for (const unsigned f : cell->face_indices())
      if (!cell->at_boundary(f) && space.mesh().surface_of(cell->neighbor(f)) == caisson.body.region)
        add_face(space, unknowns, caisson.bottom_centre, cell, f, entries);
  }
  std::array<Row, n_motions> rows;
  for (int m = 0; m < n_motions; ++m) rows[m] = to_row(entries[m]);
  return rows;
}

}  // namespace upbead
