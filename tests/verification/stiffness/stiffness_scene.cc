#include "stiffness_scene.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "fem/unknowns.h"
#include "frequency_response.h"
#include "tensor_mesh.h"

namespace upbead::test {

namespace {

const std::string ring_name = "ring";

/// Lines at growing distance from the strip: those of the undamped soil, then those of the rings.
struct OutwardLines {
  std::vector<double> calm, rings;
};

OutwardLines outward_lines(const StiffnessCells& cells) {
  OutwardLines lines;
  lines.calm = {0.};
  double size = std::min(cells.edge, cells.largest);
  while (lines.calm.back() < cells.calm) {
    lines.calm.push_back(lines.calm.back() + size);
    size = std::min(size * cells.growth, cells.largest);
  }
  lines.rings = {lines.calm.back()};
  while (lines.rings.back() < cells.calm + cells.rings) {
    lines.rings.push_back(lines.rings.back() + size);
    size *= cells.ring_growth;
  }
  return lines;
}

/// Number of the ring that a distance lies in, -1 in undamped soil.
int ring_at(const OutwardLines& lines, double distance) {
  const auto& rings = lines.rings;
  return static_cast<int>(std::upper_bound(rings.begin(), rings.end(), distance) - rings.begin()) - 1;
}

std::vector<double> x_lines(const StiffnessCells& cells, const OutwardLines& outward) {
  std::vector<double> right = graded_lines(1., 0., cells.edge, cells.growth, cells.largest_below()), all;
  for (const auto& part : {outward.calm, outward.rings})
    for (const double distance : part) right.push_back(1. + distance);
  for (const double x : right) all.insert(all.end(), {x, -x});
  std::sort(all.begin(), all.end());
  return joined(all, {});
}

std::vector<double> y_lines(const ElasticSoil& soil, const StiffnessCells& cells, const OutwardLines& outward,
                            const std::vector<Storey>& storeys) {
  std::vector<double> y;
  if (soil.is_layer()) {
    y = graded_lines(0., -soil.depth, cells.edge, cells.growth, cells.largest_below());
  } else {
    for (const auto& part : {outward.calm, outward.rings})
      for (const double distance : part) y.push_back(-distance);
  }
  for (const Storey& storey : storeys) y.insert(y.end(), storey.heights.begin(), storey.heights.end());
  std::sort(y.begin(), y.end());
  return joined(y, {});
}

}  // namespace

std::unique_ptr<Mesh> stiffness_mesh(const ElasticSoil& soil, const StiffnessCells& cells,
                                     const std::vector<Storey>& storeys) {
  const OutwardLines outward = outward_lines(cells);
  const auto x = x_lines(cells, outward), y = y_lines(soil, cells, outward, storeys);
  const double tiny = 1e-6 * cells.edge, bottom = y.front(), side = x.back();
  const bool layer = soil.is_layer();
  const auto surface = [&](const dealii::Point<dim>& at) -> std::string {
    if (at[1] > 0.) {
      for (const Storey& storey : storeys)
        if (std::abs(at[0]) < 1. && at[1] < storey.heights.back()) return storey.name;
      return "";
    }
    const int ring = std::max(ring_at(outward, std::abs(at[0]) - 1.), layer ? -1 : ring_at(outward, -at[1]));
    return ring < 0 ? "soil" : ring_name + std::to_string(ring);
  };
  const auto curve = [&](const dealii::Point<dim>& at) -> std::string {
    if (at[1] > tiny) return "block";
    if (at[1] > -tiny) return std::abs(at[0]) > 1. ? "surface" : "";
    return at[1] < bottom + tiny || std::abs(at[0]) > side - tiny ? "far" : "";
  };
  return tensor_mesh(x, y, surface, curve);
}

Scene stiffness_scene(const ElasticSoil& soil, const StiffnessCells& cells, const Mesh& mesh, double a0) {
  Region ground;
  ground.kind = RegionKind::solid;
  ground.shear_modulus = 1.;
  ground.poissons_ratio = soil.nu;
  ground.density = 1.;
  Scene scene;
  const auto n_rings = static_cast<double>(outward_lines(cells).rings.size() - 1);
  for (const std::string& name : mesh.surfaces) {
    scene.regions[name] = ground;
    if (name.compare(0, ring_name.size(), ring_name) != 0) continue;
    const double middle = (std::stoi(name.substr(ring_name.size())) + 0.5) / n_rings, frequency = a0 / (2. * M_PI);
    scene.regions[name].damping = Rayleigh{cells.damping * std::pow(middle, 3), {frequency, frequency}};
  }
  Region& strip = scene.regions["strip"] = Region{};
  strip.kind = RegionKind::rigid;
  strip.mass = 0.;
  strip.moment_of_inertia = 0.;
  strip.centre_of_gravity = {{0., 0.}};
  scene.boundaries["far"].displacement = DisplacementCondition::fixed;
  scene.boundaries["surface"] = scene.boundaries["block"] = {};
  scene.mesh.degree = 3;
  return scene;
}

StiffnessCells cells_for(const ElasticSoil& soil, double a0) {
  const double wavelength = 2. * M_PI / a0;
  StiffnessCells cells;
  if (soil.is_layer() && a0 < soil.cut_off()) {
    cells.largest = wavelength / 3.5;
    cells.calm = 30. * soil.depth;
  } else if (soil.is_layer()) {
    cells.largest = wavelength / 3.5;
    cells.calm = 0.2 * wavelength;
    cells.rings = 40. * wavelength;
    cells.damping = 0.1;
  } else {
    cells.largest = wavelength / 4.5;
    cells.calm = 0.5 * wavelength;
    cells.rings = 2.2 * soil.pressure_wave_speed() * wavelength;
    cells.ring_growth = 1.05;
    cells.damping = 2.;
  }
  return cells;
}

Stiffness computed_stiffness(const Compiled& compiled, double a0) {
  const System& system = compiled.system;
  const FrequencyResponse response(system, a0);
  Stiffness compliance;
  for (int load = 0; load < n_motions; ++load) {
    ComplexVector unit = ComplexVector::Zero(system.n_free());
    unit[compiled.unknowns.coordinate(0, load)] = 1.;
    const ComplexVector x = response.solve(unit);
    for (int motion = 0; motion < n_motions; ++motion)
      compliance(motion, load) = x[compiled.unknowns.coordinate(0, motion)];
  }
  return compliance.inverse();
}

Stiffness computed_stiffness(const ElasticSoil& soil, const StiffnessCells& cells, double a0) {
  const auto mesh = stiffness_mesh(soil, cells, {{"strip", {0., cells.edge}}});
  return computed_stiffness(Compiled(stiffness_scene(soil, cells, *mesh, a0), *mesh), a0);
}

}  // namespace upbead::test
