#include "response/mesh_error.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "fem/caisson_readings.h"
#include "fem/surplus.h"
#include "response/spectrum.h"
#include "response/step_choice.h"

namespace upbead {

namespace {

/// Real part of s over the imaginary one: resonances that are narrower than the distance of two frequencies are seen
/// between them, too.
constexpr double decay = 0.25;
constexpr int n_frequencies = 12;

/// From one half-wave in the whole run to four in the shortest load, in equal ratios: waves that the caisson sends out
/// long after a short pulse are slow.
std::vector<std::complex<double>> frequencies(const Scene& scene) {
  const double low = pi / scene.time.end, high = std::max(4. * pi / step_of_loads(scene, 4).duration, 2. * low);
  std::vector<std::complex<double>> s;
  for (int j = 0; j < n_frequencies; ++j) {
    const double omega = low * std::pow(high / low, j / (n_frequencies - 1.));
    s.emplace_back(decay * omega, omega);
  }
  return s;
}

/// b'X of all loads.
std::complex<double> work(const System& system, const Eigen::VectorXcd& X, const Eigen::VectorXcd& F) {
  std::complex<double> sum = 0.;
  for (std::size_t k = 0; k < system.loads.size(); ++k)
    sum += F[static_cast<Eigen::Index>(k)] * (system.loads[k].vector.array() * X.array()).sum();
  return sum;
}

}  // namespace

MeshError mesh_error(const Scene& scene, const Space& space, const Unknowns& unknowns, const CompiledScene& compiled) {
  const System& system = compiled.system;
  const Spectrum spectrum = solve_spectrum(scene, compiled, frequencies(scene));
  const Reading& x_G = system.readings[system.reading(reading::displacement_x)];
  const auto n = static_cast<Eigen::Index>(spectrum.s.size());
  Eigen::VectorXd weight(n);
  double total = 0.;
  for (Eigen::Index j = 0; j < n; ++j) {
    const std::complex<double> s = spectrum.s[static_cast<std::size_t>(j)];
    const Eigen::VectorXcd X = spectrum.X.col(j), F = spectrum.F.col(j);
    // b'x stands for F x_G; F_T errs by m s^2 times the error of x_G.
    const double done = std::abs(work(system, X, F)), x = std::abs(evaluate(x_G, X, s, F));
    const double part = s.imag();  // of the integral over frequency: d omega of equal ratios
    weight[j] = done > 0. ? part * compiled.caisson->body.mass * std::norm(s) * x / done : 0.;
    total += part * std::abs(spectrum.shear[static_cast<std::size_t>(j)]);
  }
  const Eigen::VectorXd of_cell = cell_errors(scene, space, unknowns, spectrum.X, spectrum.s) * weight;
  MeshError error;
  for (const double value : of_cell) {
    error.of_cell.push_back(total > 0. ? value / total : 0.);
    error.sum += error.of_cell.back();
  }
  return error;
}

}  // namespace upbead
