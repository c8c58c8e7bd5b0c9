#include "meshes.h"

#include <deal.II/grid/grid_tools.h>

#include <cmath>
#include <random>

#include "tensor_mesh.h"

namespace upbead::test {

namespace {

/// Displacement of vertex (i, j) of the squares, over their side.
dealii::Tensor<1, dim> shift(Quads quads, long i, long j) {
  dealii::Tensor<1, dim> shift;
  if (quads == Quads::trapezoid && j % 2 == 1) shift[1] = i % 2 == 0 ? 0.25 : -0.25;
  if (quads == Quads::perturbed) {
    std::mt19937 generator(5);
    const auto draw = [&generator] { return 0.25 * (2. * generator() / std::mt19937::max() - 1.); };
    const double edge_x = draw(), edge_y = draw(), middle_x = draw(), middle_y = draw();
    if (i % 2 == 1) shift[0] = j % 2 == 0 ? edge_x : middle_x;
    if (j % 2 == 1) shift[1] = i % 2 == 0 ? edge_y : middle_y;
  }
  return shift;
}

}  // namespace

const char* name_of(Quads quads) {
  return quads == Quads::uniform ? "uniform" : quads == Quads::perturbed ? "perturbed" : "trapezoid";
}

std::unique_ptr<Mesh> quadrilaterals(const Manufactured& mms, Quads quads, double h) {
  const auto lines = [h](double from, double to) {
    return even_lines(from, to, static_cast<int>(std::lround((to - from) / h)));
  };
  const auto inside = [&mms](const dealii::Point<dim>& at) {
    return at[0] > mms.lower[0] && at[0] < mms.upper[0] && at[1] > mms.lower[1] && at[1] < mms.upper[1];
  };
  auto mesh = tensor_mesh(
      lines(mms.lower[0], mms.upper[0]), lines(mms.lower[1], mms.upper[1]),
      [&](const auto& at) { return mms.surface_at(at); }, [&](const auto& at) { return inside(at) ? "" : "side"; });
  const auto moved = [&](const dealii::Point<dim>& at) {
    const dealii::Tensor<1, dim> from_corner = (at - mms.lower) / h;
    return dealii::Point<dim>(at + h * shift(quads, std::lround(from_corner[0]), std::lround(from_corner[1])));
  };
  dealii::GridTools::transform(moved, mesh->triangulation);
  return mesh;
}

}  // namespace upbead::test
