#include "output/cell_fields.h"

#include <deal.II/lac/vector.h>

#include <list>
#include <sstream>

#include "output/field_patches.h"

namespace upbead {

std::string cell_fields_vtu(const Mesh& mesh, const std::vector<CellField>& fields) {
  FieldPatches out;
  out.attach_triangulation(mesh.triangulation);
  std::list<dealii::Vector<double>> values;
  for (const CellField& field : fields) {
    values.emplace_back(field.values.begin(), field.values.end());
    out.add_data_vector(values.back(), field.name, dealii::DataOut<dim>::type_cell_data);
  }
  out.add_regions(mesh);
  out.build_patches();
  std::ostringstream file;
  write_vtu(file, out.grid(), out.arrays());
  return file.str();
}

}  // namespace upbead
