#include "wave_seabed.h"

#include <cmath>

#include "tensor_mesh.h"

namespace upbead::test {

namespace {

/// (height y, cos(k y)) over half a wave; the error of 2000 straight pieces is (pi / 2000)^2 / 8 = 3e-7.
std::vector<std::array<double, 2>> cosine(double wavelength) {
  const int pieces = 2000;
  std::vector<std::array<double, 2>> pairs;
  for (int i = 0; i <= pieces; ++i)
    pairs.push_back({0.5 * wavelength * i / pieces, std::cos(std::acos(-1.) * i / pieces)});
  return pairs;
}

std::string name_of(char where, std::size_t i) {
  return where + std::to_string(i);
}

Scene scene_of(const WaveSeabed& seabed, int degree) {
  Scene scene;
  scene.fluid = seabed.fluid;
  scene.time.inertia = seabed.inertia;
  scene.mesh.degree = degree;
  scene.regions["soil"] = seabed.soil;
  scene.boundaries["mudline"] = {DisplacementCondition::free, PressureCondition::open};
  scene.boundaries["bottom"] = {DisplacementCondition::fixed, PressureCondition::sealed};
  for (const char* side : {"crest", "trough"})
    scene.boundaries[side] = {DisplacementCondition::roller, PressureCondition::sealed};
  if (seabed.water > 0.) {
    scene.boundaries.erase("mudline");
    scene.boundaries["level"].pressure = PressureCondition::open;
    scene.boundaries["ends"].pressure = PressureCondition::sealed;
    scene.regions["water"].kind = RegionKind::water;
    scene.regions["water"].compressibility = Compressibility::compressible;
  }
  Load wave;
  wave.boundary = seabed.water > 0. ? "level" : "mudline";
  wave.kind = LoadKind::pressure;
  wave.shape = cosine(seabed.wavelength);
  wave.history = triangle(1., 1.);  // any history: the response is to unit amplitude
  scene.loads["wave"] = wave;
  for (std::size_t i = 0; i < seabed.depths.size(); ++i) {
    scene.probes[name_of('c', i)].at = {seabed.depths[i], 0.};  // crest
    // a quarter of a wavelength from the crest
    scene.probes[name_of('q', i)].at = {seabed.depths[i], 0.25 * seabed.wavelength};
  }
  return scene;
}

std::unique_ptr<Mesh> mesh_of(const WaveSeabed& seabed, const SeabedMesh& sizes) {
  const double z = seabed.thickness, y = 0.5 * seabed.wavelength, small = 1e-12 * z, level = -seabed.water;
  const auto curve = [=](const dealii::Point<dim>& at) -> std::string {
    if (level < 0. && at[0] < level + small) return "level";
    if (at[0] < -small) return at[1] < small || at[1] > y - small ? "ends" : "";
    if (at[0] < small) return "mudline";
    if (at[0] > z - small) return "bottom";
    return at[1] < small ? "crest" : at[1] > y - small ? "trough" : "";
  };
  const auto from = [&](double side) { return graded_lines(side, 0.5 * z, sizes.first, sizes.growth, sizes.largest); };
  auto lines = joined(from(0.), from(z));
  if (level < 0.) lines = joined(even_lines(level, 0., 2), lines);
  return tensor_mesh(
      lines, even_lines(0., y, sizes.along), [](const auto& at) { return at[0] < 0. ? "water" : "soil"; }, curve);
}

}  // namespace

WaveSeabed wave_seabed(const Json& entry, const std::string& model) {
  Json material = entry.at("case").at("mat");
  material["Kf"] = entry.at("Kf");
  WaveSeabed seabed;
  seabed.soil = soil(material, model == "full" ? Flow::inertial : Flow::darcy);
  seabed.fluid = fluid(material);
  seabed.inertia = model != "qs";
  seabed.wavelength = entry.at("wavelength");
  seabed.omega = entry.at("omega");
  const Json& thickness = entry.at("case").at("H");
  seabed.thickness = thickness.is_null() ? 2. * seabed.wavelength : thickness.get<double>();
  seabed.depths = entry.at("z").get<std::vector<double>>();
  return seabed;
}

SeabedResponse respond(const WaveSeabed& seabed, const SeabedMesh& sizes) {
  const auto mesh = mesh_of(seabed, sizes);
  const Compiled compiled(scene_of(seabed, sizes.degree), *mesh);
  const System& system = compiled.system;
  const FrequencyResponse response(system, seabed.omega);
  const std::vector<Complex> load(system.loads.size(), 1.);  // total stress and pore pressure of the wave
  const ComplexVector x = response(load);
  const auto read = [&](char where, const char* quantity) {
    std::vector<Complex> over_depth;
    for (std::size_t i = 0; i < seabed.depths.size(); ++i) {
      const int k = system.reading("probes/" + name_of(where, i) + "/" + quantity);
      over_depth.push_back(response.read(system.readings[static_cast<std::size_t>(k)], x, load));
    }
    return over_depth;
  };
  return {read('c', "pressure"), read('c', "effective_stress_xx"), read('q', "effective_stress_xy"),
          read('q', "displacement_y"), read('c', "displacement_x")};
}

}  // namespace upbead::test
