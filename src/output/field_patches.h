// Fields that deal.II has evaluated cell by cell, as arrays of a VTU file.
#pragma once

#include <deal.II/numerics/data_out.h>

#include <vector>

#include "output/vtu_file.h"
#include "upbead/mesh/mesh.h"

namespace upbead {

/// Fields of a state in patches: a lattice of points for each cell, drawn as small quadrilaterals. All files of one
/// mesh and one degree have the same grid.
class FieldPatches : public dealii::DataOut<dim> {
 public:
  VtuGrid grid() const;
  /// The arrays; vectors get a third component, as VTK needs it.
  std::vector<VtuArray> arrays() const;

 private:
  VtuArray array(const std::string& name, unsigned first, unsigned last, int components) const;
};

}  // namespace upbead
