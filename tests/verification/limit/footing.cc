#include "footing.h"

#include <deal.II/base/quadrature_lib.h>

#include <cmath>

#include "base/stopwatch.h"
#include "scenes.h"
#include "tensor_mesh.h"
#include "unknowns_on.h"

namespace upbead::test {

namespace {

constexpr double half = 0.5;  // of the footing's width (m)

/// From an edge at `from`: cells grow up to the largest, and `near` away from it on.
std::vector<double> graded(const Footing& f, double from, double to, double near) {
  const double sign = to > from ? 1. : -1., middle = from + sign * near;
  if (sign * (to - middle) <= 0.) return graded_lines(from, to, f.edge, f.growth, f.largest);
  return joined(graded_lines(from, middle, f.edge, f.growth, f.largest),
                graded_lines(middle, to, f.largest, f.growth, 1e9));
}

std::vector<double> columns(const Footing& f) {
  return joined(graded(f, half, 0., half), graded(f, half, f.width, f.near));
}

std::vector<double> mirrored(std::vector<double> x) {
  std::vector<double> other;
  for (const double value : x) other.push_back(-value);
  return joined(x, other);
}

std::unique_ptr<Mesh> ground_mesh(const Footing& f) {
  const bool whole = f.sideways != 0.;
  const double left = whole ? -f.width : 0.;
  const auto curve = [&](const dealii::Point<dim>& p) -> std::string {
    constexpr double tiny = 1e-6;
    if (p[0] < left + tiny) return whole ? "far" : "middle";
    if (p[0] > f.width - tiny) return "far";
    if (p[1] < tiny - f.depth) return "base";
    if (p[1] > -tiny) return std::abs(p[0]) < half ? "foot" : "bed";
    return "";
  };
  return tensor_mesh(
      whole ? mirrored(columns(f)) : columns(f), graded(f, 0., -f.depth, f.below),
      [](const dealii::Point<dim>&) { return "soil"; }, curve);
}

Scene ground_scene(const Footing& f) {
  Scene scene;
  scene.mesh.degree = f.degree;
  Region& soil = scene.regions["soil"];
  soil.kind = RegionKind::solid;
  soil.deformation = Deformation::elastic;
  soil.density = 1e-3;
  soil.shear_modulus = f.shear_modulus;
  soil.poissons_ratio = f.poissons_ratio;
  scene.boundaries["base"].displacement = DisplacementCondition::fixed;
  scene.boundaries["far"].displacement = DisplacementCondition::roller;
  scene.boundaries["middle"].displacement = DisplacementCondition::roller;
  scene.boundaries["foot"] = scene.boundaries["bed"] = {};
  return scene;
}

PointStresses before(const Footing& f, const Space& space) {
  PointStresses found;
  const dealii::QGauss<dim> points(static_cast<unsigned>(f.degree) + 1);
  for (const auto& cell : space.dofs().active_cell_iterators()) {
    found.emplace_back();
    for (const auto& point : points.get_points()) {
      const double y = space.mapping().transform_unit_to_real_cell(cell, point)[1];
      const double vertical = -f.surcharge + f.unit_weight * y, side = f.K0 * vertical;
      found.back().push_back({side, vertical, 0., side});
    }
  }
  return found;
}

}  // namespace

FootingAnswer push(const Footing& f) {
  const Stopwatch watch;
  const auto mesh = ground_mesh(f);
  const Compiled compiled(ground_scene(f), *mesh);
  const Space& space = compiled.space;
  StaticSoil soil(space, compiled.unknowns);
  const auto law = std::make_shared<const MohrCoulombLaw>(elastic_law(f.shear_modulus, f.poissons_ratio), f.soil);
  soil.follow(StaticLaws(mesh->triangulation.n_active_cells(), law));
  soil.start_from(before(f, space));
  Vector x = Vector::Zero(compiled.unknowns.size()), weights;
  soil.exert(x, weights);

  StaticPath path;
  const std::vector<int> down = unknowns_on(compiled, "foot", 1), along = unknowns_on(compiled, "foot", 0);
  path.held = down;
  path.held.insert(path.held.end(), along.begin(), along.end());
  path.load = [&](double) { return weights; };
  path.place = [&](double t) {
    std::vector<double> place(path.held.size(), 0.);
    std::fill_n(place.begin(), down.size(), -f.settlement * t);
    std::fill(place.begin() + static_cast<std::ptrdiff_t>(down.size()), place.end(), f.sideways * f.settlement * t);
    return place;
  };
  StaticSteps steps;
  steps.first = 0.02;
  steps.largest = 0.1;
  // what lies on the neighbour's side of the node at the edge is no load of the footing
  const double beside = f.surcharge * f.edge / (f.degree == 2 ? 6. : 8.);
  FootingAnswer answer;
  answer.unknowns = compiled.unknowns.size();
  answer.report = march_static(soil, path, steps, x, [&](double t, const Vector&, const Vector& force) {
    const double sides = f.sideways != 0. ? 2. : 1.;
    double V = -sides * beside, H = 0.;
    for (const int i : down) V -= force[i];
    for (const int i : along) H += force[i];
    answer.settlement.push_back(f.settlement * t);
    answer.load.push_back(V / (sides * half));
    answer.shear.push_back(H / (sides * half));
    return true;
  });
  answer.seconds = watch.seconds();
  return answer;
}

}  // namespace upbead::test
