#include "loaded_layer.h"

#include <algorithm>
#include <cmath>

#include "column_case.h"
#include "tensor_mesh.h"

namespace upbead::test {

std::unique_ptr<Mesh> layer_mesh(const LoadedLayer& layer, const std::vector<double>& x, const std::vector<double>& y) {
  const double tiny = 1e-9 * layer.depth, far = x.back(), b = layer.half_width, depth = layer.depth;
  return tensor_mesh(
      x, y, [](const dealii::Point<dim>&) { return "soil"; },
      [=](const dealii::Point<dim>& at) -> std::string {
        if (at[1] > -tiny) return at[0] < b ? "strip" : "outside";
        if (at[1] < tiny - depth) return "base";
        return at[0] < tiny ? "axis" : at[0] > far - tiny ? "far" : "";
      });
}

std::unique_ptr<Mesh> graded_layer_mesh(const LoadedLayer& layer, double edge, double growth, double largest) {
  const double b = layer.half_width, far = b + layer.far * layer.depth;
  const auto x = joined(graded_lines(b, 0., edge, growth, largest), graded_lines(b, far, edge, growth, 4. * largest));
  return layer_mesh(layer, x, graded_lines(0., -layer.depth, edge, growth, largest));
}

std::unique_ptr<Mesh> even_layer_mesh(const LoadedLayer& layer, int n) {
  const double b = layer.half_width, h = b / n, far = b + layer.far * layer.depth;
  const double growth = std::pow(2., 1. / n);  // the same on all levels, as the size is a function of x
  const auto x = joined(even_lines(0., 3. * b, 3 * n), graded_lines(3. * b, far, h, growth, 0.5 * layer.depth));
  return layer_mesh(layer, x, even_lines(-layer.depth, 0., static_cast<int>(std::lround(layer.depth / h))));
}

Scene loaded_layer(const Region& soil, double q, const std::optional<PressureCondition>& surface) {
  const auto sealed = surface ? std::make_optional(PressureCondition::sealed) : std::nullopt;
  Scene scene;
  scene.time.inertia = false;
  scene.regions["soil"] = soil;
  scene.boundaries["base"] = {DisplacementCondition::fixed, sealed};
  scene.boundaries["axis"] = scene.boundaries["far"] = {DisplacementCondition::roller, sealed};
  scene.boundaries["strip"] = scene.boundaries["outside"] = {DisplacementCondition::free, surface};
  Load& load = scene.loads["strip"];
  load.boundary = "strip";
  load.kind = LoadKind::traction;
  load.direction = {0., -1.};
  load.history = step_load(q);
  return scene;
}

void add_probes_at_depths(Scene& scene, const std::string& prefix, const std::vector<double>& depths) {
  for (std::size_t i = 0; i < depths.size(); ++i) scene.probes[prefix + std::to_string(i)].at = {0., -depths[i]};
}

void add_probes_on_surface(Scene& scene, const std::string& prefix, const std::vector<double>& x) {
  for (std::size_t i = 0; i < x.size(); ++i) scene.probes[prefix + std::to_string(i)].at = {x[i], 0.};
}

Json stress_test(const std::string& id) {
  const Json all = reference("ref9_stress");
  for (const Json& test : all.at("tests"))
    if (test.at("id") == id) return test;
  throw std::runtime_error("no such test");
}

std::vector<double> column_of(const Json& rows, std::size_t i) {
  std::vector<double> column;
  for (const Json& row : rows) column.push_back(row.at(i));
  return column;
}

}  // namespace upbead::test
