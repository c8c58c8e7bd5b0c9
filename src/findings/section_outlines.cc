#include "findings/section_outlines.h"

namespace upbead {

std::vector<Dataset> section_outlines(const Mesh& mesh) {
  std::vector<Dataset> tables;
  for (const std::string& name : mesh.surfaces)
    tables.push_back({"section/" + name, "m", "outer sides of the region: x, y of one end, x, y of the other", {}, 4});
  for (const auto& cell : mesh.triangulation.active_cell_iterators())
    for (const unsigned f : cell->face_indices()) {
      if (!cell->at_boundary(f) && cell->neighbor(f)->material_id() == cell->material_id()) continue;
      std::vector<double>& sides = tables[cell->material_id()].values;
      for (const unsigned end : {0u, 1u})
        for (unsigned d = 0; d < dim; ++d) sides.push_back(cell->face(f)->vertex(end)[d]);
    }
  return tables;
}

}  // namespace upbead
