#include "footing_mesh.h"

#include <cmath>

#include "tensor_mesh.h"

namespace upbead::test {

namespace {

std::vector<double> columns(const Footing& f) {
  return joined(graded_lines(half_width, 0., f.cell, f.growth, f.largest),
                graded_lines(half_width, f.width, f.cell, f.growth, f.largest));
}

std::vector<double> mirrored(std::vector<double> x) {
  std::vector<double> other;
  for (const double value : x) other.push_back(-value);
  return joined(x, other);
}

}  // namespace

std::unique_ptr<Mesh> ground_mesh(const Footing& f) {
  const bool whole = f.sideways != 0.;
  const double left = whole ? -f.width : 0.;
  const auto curve = [&](const dealii::Point<dim>& p) -> std::string {
    constexpr double tiny = 1e-6;
    if (p[0] < left + tiny) return whole ? "far" : "middle";
    if (p[0] > f.width - tiny) return "far";
    if (p[1] < tiny - f.depth) return "base";
    if (p[1] > -tiny) return std::abs(p[0]) < half_width ? "foot" : "bed";
    return "";
  };
  return tensor_mesh(
      whole ? mirrored(columns(f)) : columns(f), graded_lines(0., -f.depth, f.cell, f.growth, f.largest),
      [](const dealii::Point<dim>&) { return "soil"; }, curve);
}

}  // namespace upbead::test
