#include "tensor_mesh.h"

#include <deal.II/base/table.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/manifold_lib.h>

#include <algorithm>
#include <cmath>

namespace upbead::test {

namespace {

/// Index of a name in a list; appended where it is new.
unsigned index_of(const std::string& name, std::vector<std::string>& names) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) names.push_back(name);
  return static_cast<unsigned>(std::find(names.begin(), names.end(), name) - names.begin());
}

std::vector<double> spacings(const std::vector<double>& lines) {
  std::vector<double> out;
  for (std::size_t i = 1; i < lines.size(); ++i) out.push_back(lines[i] - lines[i - 1]);
  return out;
}

}  // namespace

std::unique_ptr<Mesh> tensor_mesh(const std::vector<double>& x, const std::vector<double>& y, const Naming& surface,
                                  const Naming& curve) {
  auto mesh = std::make_unique<Mesh>();
  const auto dx = spacings(x), dy = spacings(y);
  dealii::Table<dim, dealii::types::material_id> material(static_cast<unsigned>(dx.size()),
                                                          static_cast<unsigned>(dy.size()));
  for (unsigned i = 0; i < dx.size(); ++i)
    for (unsigned j = 0; j < dy.size(); ++j) {
      const std::string name = surface({x[i] + 0.5 * dx[i], y[j] + 0.5 * dy[j]});
      material[i][j] = name.empty() ? dealii::numbers::invalid_material_id : index_of(name, mesh->surfaces);
    }
  auto& triangulation = mesh->triangulation;
  dealii::GridGenerator::subdivided_hyper_rectangle(triangulation, {dx, dy}, dealii::Point<dim>(x.front(), y.front()),
                                                    material);
  for (const auto& face : triangulation.active_face_iterators())
    if (const std::string name = curve(face->center()); !name.empty())
      face->set_manifold_id(index_of(name, mesh->curves));
  for (unsigned c = 0; c < mesh->curves.size(); ++c) triangulation.set_manifold(c, dealii::FlatManifold<dim>());
  return mesh;
}

std::vector<double> graded_lines(double from, double to, double first, double growth, double largest) {
  const double length = std::abs(to - from), sign = to > from ? 1. : -1.;
  std::vector<double> distance{0.};
  double size = first;
  while (distance.back() < length * (1. - 1e-9)) {
    distance.push_back(distance.back() + size);
    size = std::min(size * growth, largest);
  }
  std::vector<double> lines;
  for (const double d : distance) lines.push_back(from + sign * d * length / distance.back());
  lines.back() = to;
  std::sort(lines.begin(), lines.end());
  return lines;
}

std::vector<double> even_lines(double from, double to, int n) {
  std::vector<double> lines;
  for (int i = 0; i <= n; ++i) lines.push_back(from + (to - from) * i / n);
  return lines;
}

std::vector<double> joined(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> lines(a);
  lines.insert(lines.end(), b.begin(), b.end());
  std::sort(lines.begin(), lines.end());
  const double least = 1e-9 * (lines.back() - lines.front());
  std::vector<double> out{lines.front()};
  for (const double line : lines)
    if (line > out.back() + least) out.push_back(line);
  return out;
}

}  // namespace upbead::test
