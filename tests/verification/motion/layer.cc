#include "layer.h"

#include <cmath>

#include "tensor_mesh.h"
#include "upbead/model/region.h"

namespace upbead::test {

namespace {

const double pi = std::acos(-1.);
constexpr double rock_depth = 5.;  // m

}  // namespace

Region layer_soil(const Shaking& shaking) {
  Region region;
  region.kind = RegionKind::solid;
  region.deformation = Deformation::elastic;
  region.shear_modulus = 45e6;
  region.poissons_ratio = 0.3;
  region.density = 2000.;
  region.damping = shaking.damping;
  return region;
}

double modulus(const Region& soil, bool vertical) {
  const double G = *soil.shear_modulus, nu = *soil.poissons_ratio;
  return vertical ? 2. * G * (1. - nu) / (1. - 2. * nu) : G;
}

Scene shaken_layer(const Shaking& shaking, const TimeFunction& velocity) {
  Scene scene;
  scene.mesh.degree = 3;
  scene.regions["soil"] = layer_soil(shaking);
  if (shaking.rock_stiffness > 0.) {
    scene.regions["rock"] = layer_soil(shaking);
    scene.regions["rock"].shear_modulus = shaking.rock_stiffness * *scene.regions["soil"].shear_modulus;
  }
  scene.boundaries["base"] = {shaking.base, {}};
  scene.boundaries["sides"] = {shaking.vertical ? DisplacementCondition::roller : DisplacementCondition::level, {}};
  scene.boundaries["top"] = {};
  Load load;
  load.boundary = "base";
  load.kind = LoadKind::velocity;
  load.direction = {shaking.vertical ? 0. : 1., shaking.vertical ? 1. : 0.};
  load.history = velocity;
  scene.loads["shaking"] = load;
  scene.probes["top"].at = {0.5, layer_height};
  return scene;
}

std::unique_ptr<Mesh> layer_mesh(const Shaking& shaking, int cells) {
  const double lowest = shaking.rock_stiffness > 0. ? -rock_depth : 0.;
  const auto curve = [lowest](const dealii::Point<dim>& p) -> std::string {
    if (std::abs(p[1] - lowest) < 1e-9) return "base";
    if (std::abs(p[1] - layer_height) < 1e-9) return "top";
    return std::abs(p[0] - 0.5) > 0.5 - 1e-9 ? "sides" : "";
  };
  const int below = static_cast<int>(std::ceil(cells * -lowest / layer_height));
  std::vector<double> lines = even_lines(0., layer_height, cells);
  if (below > 0) lines = joined(even_lines(lowest, 0., below), lines);
  return tensor_mesh(
      {0., 1.}, lines, [](const dealii::Point<dim>& p) { return p[1] < 0. ? "rock" : "soil"; }, curve);
}

TimeFunction smooth_velocity(double peak, double duration) {
  const auto zero = [](double) { return 0.; };
  const auto wave = [peak, duration](double t) { return peak * std::pow(std::sin(pi * t / duration), 4); };
  return TimeFunction({0., duration}, {zero, wave, zero});
}

TimeFunction growing_sine(double frequency, double growth) {
  const auto zero = [](double) { return 0.; };
  const auto sine = [frequency](double t) { return std::sin(2. * pi * frequency * t); };
  const auto grows = [sine, growth](double t) { return std::pow(std::sin(0.5 * pi * t / growth), 4) * sine(t); };
  return TimeFunction({0., growth}, {zero, grows, sine});
}

std::complex<double> amplitude(const std::vector<double>& time, const Eigen::RowVectorXd& values, double frequency,
                               int periods) {
  const double from = time.back() - periods / frequency, omega = 2. * pi * frequency;
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < time.size(); ++i) {
    if (time[i] < from) continue;
    const Eigen::Vector2d basis(std::cos(omega * time[i]), std::sin(omega * time[i]));
    normal += basis * basis.transpose();
    right += values[static_cast<Eigen::Index>(i)] * basis;
  }
  const Eigen::Vector2d found = normal.ldlt().solve(right);
  return {found[0], -found[1]};  // Re{A e^{i omega t}} = a cos - b sin
}

}  // namespace upbead::test
