// A mesh of quadrilaterals whose surfaces and curves have names.
#pragma once

#include <deal.II/grid/tria.h>

#include <memory>
#include <string>
#include <vector>

#include "upbead/mesh/request.h"

namespace upbead {

/// Two space dimensions: plane strain, x landward, y up.
constexpr int dim = 2;

/// Names live here because deal.II keeps only numbers: a cell's material_id indexes `surfaces`, a face's manifold_id
/// indexes `curves` (flat manifolds; faces on no named curve have numbers::flat_manifold_id). Ids survive refinement.
struct Mesh {
  dealii::Triangulation<dim> triangulation;
  std::vector<std::string> surfaces;
  std::vector<std::string> curves;
  int n_divided_triangles = 0;  ///< triangles of the file, each divided into three cells
  int n_high_order = 0;         ///< cells of second or higher order in the file, read by their corners
  double most_bent = 0.;        ///< largest distance of one of their nodes from the chord of its side, over the chord

  const std::string& surface_of(const dealii::Triangulation<dim>::cell_iterator& cell) const;
  /// Name of the curve that a face lies on, or "" where it lies on none.
  const std::string& curve_of(const dealii::Triangulation<dim>::face_iterator& face) const;
};

/// Area of a cell (m2), by its diagonals: deal.II's own multiplies coordinates, whose round-off is 1e-3 m2 in those of
/// a survey.
double area_of(const dealii::Triangulation<dim>::cell_iterator& cell);

/// Reads or generates the mesh and checks it. Throws InputError with every mistake and the name of its group: unnamed
/// surfaces, an edge on two named curves, an outer edge on no named curve, duplicate names, no cells. Cells of second
/// and higher order are read by their corners; clockwise cells are turned. Where there are triangles, each is divided
/// into three quadrilaterals and each quadrilateral into four.
std::unique_ptr<Mesh> read_mesh(const MeshRequest& request);

}  // namespace upbead
