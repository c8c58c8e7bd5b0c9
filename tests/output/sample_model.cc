#include "sample_model.h"

#include <cmath>

#include "upbead/base/error.h"

namespace upbead::test {

ReducedModelFile oscillator() {
  using Complex = std::complex<double>;
  const double mass = 604.8e3, rate = 4. * std::acos(-1.), ratio = 0.15;
  const Complex pole(-ratio * rate, rate * std::sqrt(1. - ratio * ratio));
  const Complex x(0., -1. / (mass * pole.imag()));  // x = Re (x z), the impulse response exp(-a t) sin(b t) / (m b)
  ReducedModelFile model;
  model.title = "oscillator";
  model.case_text = "title = \"oscillator\"\n";
  ModalModel& modes = model.modes;
  modes.pole = Eigen::Vector2cd(pole, Complex(-60., 200.));
  modes.load = Eigen::MatrixXcd::Ones(2, 2);
  modes.reading.setZero(3, 2);
  modes.reading.row(1) << mass * (rate * rate + 2. * ratio * rate * pole) * x, Complex(0.5, -1.);
  modes.reading(2, 0) = x;
  modes.feedthrough.setZero(3, 2);
  modes.feedthrough.row(0).setOnes();
  modes.impulse.setZero(3, 2);
  modes.load_name = {"impact", "slow"};
  modes.reading_label = {{"force", "N/m", "P"}, {"shear_force", "N/m", "F_T"}, {"caisson/displacement_x", "m", "x_G"}};
  model.loads = {{"impact", "N/m", 1.6e6, 0.15}, {"slow", "N/m", 4e5, 3.}};
  model.caisson_mass = mass;
  model.end = 4.;
  model.highest_frequency = 50.;
  model.tolerance = 0.01;
  model.error = 0.004;
  model.error_peak = 0.003;
  model.error_march = 0.002;
  model.unknowns = 12345;
  model.solves = 20;
  model.factorisations = 2;
  return model;
}

NestedModels nested_oscillators(double middle, double reference) {
  const ModalModel modes = oscillator().modes;
  const auto times = [&modes](double factor) {
    ModalModel larger = modes;
    larger.reading = factor * modes.reading.row(1);
    larger.feedthrough = factor * modes.feedthrough.row(1);
    larger.impulse = factor * modes.impulse.row(1);
    larger.reading_label = {modes.reading_label[1]};
    return larger;
  };
  return {times(middle), times(reference), 30, 3};
}

ModelSlip slipping_oscillator() {
  const double mass = oscillator().caisson_mass, rate = 4. * std::acos(-1.), ratio = 0.15, ground = 50e3;
  Eigen::Matrix2d of_ground;  // matrix over (x, s) of a unit spring to the ground, which moves by x - s
  of_ground << 1., -1., -1., 1.;
  ModelSlip slip;
  ReducedSystem& system = slip.system;
  system.M = ground * of_ground;
  system.M(0, 0) += mass;
  system.C = 2. * ratio * rate * mass * of_ground;
  system.K = rate * rate * mass * of_ground;
  system.load.setZero(2, 3);
  system.load.row(0) << 1., 1., 0.;
  system.load(1, 2) = -1.;
  system.prescribed = {-1, -1, -1};
  system.position.setZero(3, 2);
  system.position(1, 1) = 1.;
  system.velocity.setZero(3, 2);
  system.velocity(2, 1) = 1.;
  system.acceleration.setZero(3, 2);
  system.feedthrough.setZero(3, 3);
  system.is_phi = {false, false};
  system.shift = 50.;
  system.load_name = {"impact", "slow", "interface/friction"};
  system.reading_label = {{"normal_force", "N/m", "no change of N'"},
                          {"interface/slip", "m", "s"},
                          {"interface/slip_velocity", "m/s", "s'"}};
  slip.error = 0.001;
  slip.glued_error = 0.002;
  slip.vectors = 2;
  slip.solves = 3;
  return slip;
}

CircleModel circles_under_an_oscillator() {
  CircleModel model;
  model.family.left = -6.;
  model.family.right = 6.;
  for (const bool landward : {true, false}) {
    FamilyCircle c{0., 8., std::hypot(9., 8.), -9., 9., landward, landward ? 1e3 : -2e3, {}};
    for (const double x : {-6., 0., 6.})
      c.slices.push_back({x, 6., -x / c.radius, std::sqrt(1. - x * x / (c.radius * c.radius)), 1e4, 0.7, 3e4});
    model.family.circles.push_back(c);
  }
  model.pressures = oscillator().modes;
  const auto n = static_cast<Eigen::Index>(model.family.n_readings());
  model.pressures.reading.resize(n, 2);
  for (Eigen::Index i = 0; i < n; ++i)
    model.pressures.reading.row(i) << std::complex<double>(0.1 * static_cast<double>(i), 1.), 2e3;
  model.pressures.feedthrough = Eigen::MatrixXd::Constant(n, 2, 0.01);
  model.pressures.impulse = Eigen::MatrixXd::Zero(n, 2);
  model.pressures.reading_label.assign(static_cast<std::size_t>(n), {});
  model.gap = 0.013;
  return model;
}

std::string refusal_by(const std::function<void(const std::string& path)>& read, const std::string& path) {
  try {
    read(path);
  } catch (const InputError& error) {
    std::string messages;
    for (Diagnostic mistake : error.diagnostics()) {
      if (mistake.place.file == path) mistake.place.file = "m";
      messages += (messages.empty() ? "" : "\n") + to_string(mistake);
    }
    return messages;
  }
  return "";
}

}  // namespace upbead::test
