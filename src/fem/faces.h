// Loops over the faces of a mesh, and the terms that a face adds to the system.
#pragma once

#include <deal.II/fe/fe_values.h>

#include <functional>
#include <string>
#include <vector>

#include "fem/kernels.h"
#include "fem/space.h"

namespace upbead {

/// Calls visit(cell, face number, curve) for every outer face.
void for_each_outer_face(const Space& space,
                         const std::function<void(const Cell&, unsigned, const std::string&)>& visit);

/// Outward normal of a straight face.
dealii::Tensor<1, dim> outward_normal(const Cell& cell, unsigned face);

/// A face between free water and a cell that moves; `face` and normal are those of the latter, `solid`.
struct WetFace {
  Cell solid;
  unsigned face = 0;
  Cell water;
  unsigned water_face = 0;
};
void for_each_wet_face(const Space& space, const std::function<void(const WetFace&)>& visit);

/// Terms of one face in M and C, over the degrees of freedom of its cells and, after these, prescribed unknowns.
struct FaceTerms {
  unsigned cell = 0;  ///< active index of the cell whose part it is: of a wet face, the water's
  CellMatrices matrices;
  Dofs dofs;
  std::vector<int> prescribed;
  bool of_caisson = false;  ///< its displacements are those of the caisson, not of the ground below

  /// Makes zero matrices over the degrees of freedom of these cells and over these unknowns.
  void reinit(const std::vector<Cell>& cells, const std::vector<int>& prescribed_unknowns = {});
};
using VisitFace = std::function<void(const FaceTerms&)>;

/// Shape functions on one face, with gradients, normals and weights; products of them are integrated exactly.
struct FaceValues : dealii::FEFaceValues<dim> {
  FaceValues(const Space& space, const Cell& cell, unsigned face);
};

}  // namespace upbead
