// Walks over the faces of a mesh, and what a face adds to the system.
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

/// A face between free water and a cell that moves, seen from the latter.
struct WetFace {
  Cell solid;
  unsigned face = 0;
  Cell water;
  unsigned water_face = 0;
};
void for_each_wet_face(const Space& space, const std::function<void(const WetFace&)>& visit);

/// What one face adds to M and C, over the degrees of freedom of its cells and, after them, prescribed unknowns.
struct FaceTerms {
  unsigned cell = 0;  ///< active index of the cell that it counts to: of a wet face, the water's
  CellMatrices matrices;
  Dofs dofs;
  std::vector<int> prescribed;
  bool of_caisson = false;  ///< its displacements are those of the caisson, not of the ground under it

  /// Zero matrices over the degrees of freedom of these cells and over these unknowns.
  void reinit(const std::vector<Cell>& cells, const std::vector<int>& prescribed_unknowns = {});
};
using VisitFace = std::function<void(const FaceTerms&)>;

/// Values on one face, with gradients, normals and weights; integrates products of shape functions exactly.
struct FaceValues : dealii::FEFaceValues<dim> {
  FaceValues(const Space& space, const Cell& cell, unsigned face);
};

}  // namespace upbead
