// Claim: a layer whose base moves as prescribed, or under a wave that comes up through an absorbing base, has the
// motion of d'Alembert's echoes (undamped) and of the layer's transfer function (damped, on rock).
// Source: Kramer, Geotechnical earthquake engineering (1996), eqs. (7.10), (7.18) and (7.28).
// Limits: 1e-3 of the largest exact value, and of the transfer function.

#include <gtest/gtest.h>

#include <cmath>

#include "layer.h"
#include "record.h"
#include "reference.h"
#include "upbead/model/region.h"

namespace upbead::test {
namespace shaken_layer_test {

const double pi = std::acos(-1.);
constexpr double limit = 1e-3;

double speed(const Shaking& shaking) {
  const Region soil = layer_soil(shaking);
  return std::sqrt(modulus(soil, shaking.vertical) / *soil.density);
}

const char* top_velocity(const Shaking& shaking) {
  return shaking.vertical ? "probes/top/velocity_y" : "probes/top/velocity_x";
}

class Echoes : public ::testing::TestWithParam<bool> {};

/// v(H, t) = 2 sum (-1)^n v_base(t - (2 n + 1) H/c).
TEST_P(Echoes, OfAPulseThatTheBasePrescribes) {
  Shaking shaking;
  shaking.vertical = GetParam();
  const double c = speed(shaking), duration = 1.5 * layer_height / c, end = 10. * layer_height / c;
  const TimeFunction pulse = smooth_velocity(0.1, duration);
  const auto mesh = layer_mesh(shaking, 24);
  const Compiled layer(shaken_layer(shaking, pulse), *mesh);
  const Response response = run(layer, end, duration / 100.);
  std::vector<double> exact;
  for (const double t : response.ends.time) {
    double v = 0.;
    for (int n = 0; n < 6; ++n) v += (n % 2 == 0 ? 2. : -2.) * pulse(t - (2 * n + 1) * layer_height / c);
    exact.push_back(v);
  }
  const auto found = sampled(response.ends.time, history(layer, response, top_velocity(shaking)), response.ends.time);
  Record record("shaken_layer");
  const std::string how = shaking.vertical ? "compression" : "shear";
  record.at_most("base prescribed, undamped, " + how + ": velocity of the top over its largest",
                 largest_error(found, exact), limit);
  record.curve({"undamped layer, base prescribed", "time (s)", "velocity of the top (m/s)", how, response.ends.time,
                exact, found});
}

/// A homogeneous half-space: the top has the motion of the outcrop, one travel time later.
TEST_P(Echoes, DoNotComeBackFromAnAbsorbingBase) {
  Shaking shaking;
  shaking.vertical = GetParam();
  shaking.base = DisplacementCondition::absorbing;
  const double c = speed(shaking), duration = 1.5 * layer_height / c, end = 6. * layer_height / c;
  const TimeFunction pulse = smooth_velocity(0.1, duration);
  const auto mesh = layer_mesh(shaking, 24);
  const Compiled layer(shaken_layer(shaking, pulse), *mesh);
  const Response response = run(layer, end, duration / 100.);
  std::vector<double> exact;
  for (const double t : response.ends.time) exact.push_back(pulse(t - layer_height / c));
  const auto found = sampled(response.ends.time, history(layer, response, top_velocity(shaking)), response.ends.time);
  Record record("shaken_layer");
  record.at_most(std::string("waves from below, homogeneous, ") + (shaking.vertical ? "compression" : "shear") +
                     ": velocity of the top over its largest",
                 largest_error(found, exact), limit);
}

INSTANTIATE_TEST_SUITE_P(ShearAndCompression, Echoes, ::testing::Bool());

/// Mass-proportional damping acts on the motion relative to the base: u = u_base (1 - c (1 - cos k(H - z)/cos kH)), c
/// = 1/(1 - i alpha/omega). k H with G (1 + i omega beta) and rho (1 - i alpha/omega), Rayleigh's alpha M + beta K.
std::complex<double> wave_number(const Shaking& shaking, double omega, double stiffer) {
  using namespace std::complex_literals;
  const Region soil = layer_soil(shaking);
  std::complex<double> rho = *soil.density, G = stiffer * modulus(soil, shaking.vertical);
  if (shaking.damping) {
    rho *= 1. - 1.i * shaking.damping->mass_factor() / omega;
    G *= 1. + 1.i * omega * shaking.damping->stiffness_factor();
  }
  return omega * std::sqrt(rho / G);
}

struct Transfer {
  std::string name;
  Shaking shaking;
  double frequency_ratio;  ///< over the layer's natural frequency c/(4 H)
};

class TransferFunction : public ::testing::TestWithParam<Transfer> {};

TEST_P(TransferFunction, OfTheLayer) {
  using namespace std::complex_literals;
  const auto& [name, shaking, ratio] = GetParam();
  const double own = speed(shaking) / (4. * layer_height), f = ratio * own, omega = 2. * pi * f;
  const std::complex<double> kH = layer_height * wave_number(shaking, omega, 1.);
  std::complex<double> exact = 1. / std::cos(kH);
  if (shaking.damping) exact = 1. - (1. - exact) / (1. - 1.i * shaking.damping->mass_factor() / omega);
  if (shaking.rock_stiffness > 0.) {  // relative to the outcrop of the rock, whose base is 5 m deep
    const double stiffer = shaking.rock_stiffness;
    const std::complex<double> z = wave_number(shaking, omega, 1.) / (stiffer * wave_number(shaking, omega, stiffer));
    exact = std::exp(-1.i * 5. * wave_number(shaking, omega, stiffer)) / (std::cos(kH) + 1.i * z * std::sin(kH));
  }
  const double settled = shaking.rock_stiffness > 0. ? 20. / own : 60. / own, end = settled + 4. / f;
  const auto mesh = layer_mesh(shaking, 16);
  const Compiled layer(shaken_layer(shaking, growing_sine(f, 10. / own)), *mesh);
  const Response response = run(layer, end, 1. / (40. * f));
  const std::complex<double> found =
      amplitude(response.ends.time, history(layer, response, top_velocity(shaking)), f, 4) / -1.i;  // sin = Re -i e^
  Record record("shaken_layer");
  record.at_most(name + ": amplitude and phase of the transfer function, relative", std::abs(found / exact - 1.),
                 limit);
  record.measured(name + ": amplification", std::abs(exact));
}

Shaking damped(double ratio, double rock = 0.) {
  Shaking shaking;
  shaking.damping = Rayleigh{ratio, {2., 8.}};
  shaking.rock_stiffness = rock;
  if (rock > 0.) shaking.base = DisplacementCondition::absorbing;
  return shaking;
}

Shaking undamped_on_rock(bool vertical) {
  Shaking shaking;
  shaking.vertical = vertical;
  shaking.rock_stiffness = 9.;
  shaking.base = DisplacementCondition::absorbing;
  return shaking;
}

INSTANTIATE_TEST_SUITE_P(
    Layers, TransferFunction,
    ::testing::Values(Transfer{"damped, base prescribed, half its own frequency", damped(0.05), 0.5},
                      Transfer{"damped, base prescribed, at its own frequency", damped(0.05), 1.},
                      Transfer{"damped, base prescribed, 2.6 times its own frequency", damped(0.05), 2.6},
                      Transfer{"undamped on rock, at its own frequency", undamped_on_rock(false), 1.},
                      Transfer{"undamped on rock, compression, 1.7 times its own frequency", undamped_on_rock(true),
                               1.7}));

}  // namespace shaken_layer_test
}  // namespace upbead::test
