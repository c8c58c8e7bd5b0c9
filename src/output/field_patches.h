// Fields that deal.II has evaluated cell by cell, as arrays of a VTU file.
#pragma once

#include <deal.II/lac/vector.h>
#include <deal.II/numerics/data_out.h>

#include <string>
#include <vector>

#include "output/vtu_file.h"
#include "upbead/mesh/mesh.h"

namespace upbead {

/// Fields of a state in patches: a lattice of points for each cell, drawn as small quadrilaterals. All files of one
/// mesh and one degree have the same grid.
class FieldPatches : public dealii::DataOut<dim> {
 public:
  /// Cells know the region that they belong to; to be called before the patches are built.
  void add_regions(const Mesh& mesh);
  VtuGrid grid() const;
  /// The arrays at points; vectors get a third component, as VTK needs it.
  std::vector<VtuArray> arrays() const;

 private:
  /// Row of the regions in the data of a patch; as many as there are rows where they are not known.
  std::size_t region_row() const;
  VtuArray array(const std::string& name, unsigned first, unsigned last, int components) const;

  dealii::Vector<double> regions_;  ///< by cell; DataOut keeps its address
  std::vector<std::string> names_;
};

}  // namespace upbead
