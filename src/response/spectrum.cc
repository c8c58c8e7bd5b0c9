#include "response/spectrum.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "dynamics/basis.h"
#include "dynamics/frequency_response.h"
#include "fem/caisson/readings.h"
#include "fem/error_indicator.h"
#include "response/reduction.h"
#include "response/time_choice.h"

namespace upbead {

namespace {

using Complex = std::complex<double>;

constexpr int rough_vectors_per_load = 20, least_frequencies = 10, most_frequencies = 80;
constexpr double decay = 2., spacing = pi;  // both over the window

/// A reading of x at X, X' = s X, X'' = s^2 X under loads F.
Complex evaluate(const Reading& reading, const Eigen::VectorXcd& X, Complex s, const Eigen::VectorXcd& F) {
  Complex value = 0.;
  for (const auto& [i, weight] : reading.position) value += weight * X[i];
  for (const auto& [i, weight] : reading.velocity) value += weight * s * X[i];
  for (const auto& [i, weight] : reading.acceleration) value += weight * s * s * X[i];
  for (std::size_t k = 0; k < reading.feedthrough.size(); ++k)
    value += reading.feedthrough[k] * F[static_cast<Eigen::Index>(k)];
  return value;
}

/// Real part of s over the imaginary one: so resonances narrower than the distance of two frequencies are also seen.
constexpr double decay_ratio = 0.25;
constexpr int n_frequencies = 12;

/// From one half-wave in the whole run to four in the shortest load, in equal ratios: long after a short pulse the
/// caisson still sends out waves, which are slow.
std::vector<std::complex<double>> frequencies(const Scene& scene) {
  const double low = pi / scene.time.end, high = std::max(4. * pi / step_of_loads(scene, 4).duration, 2. * low);
  std::vector<std::complex<double>> s;
  for (int j = 0; j < n_frequencies; ++j) {
    const double omega = low * std::pow(high / low, j / (n_frequencies - 1.));
    s.emplace_back(decay_ratio * omega, omega);
  }
  return s;
}

/// The sum of b'X of all loads.
std::complex<double> work(const System& system, const Eigen::VectorXcd& X, const Eigen::VectorXcd& F) {
  std::complex<double> sum = 0.;
  for (std::size_t k = 0; k < system.loads.size(); ++k)
    sum += F[static_cast<Eigen::Index>(k)] * (system.loads[k].vector.array() * X.array()).sum();
  return sum;
}

}  // namespace

Spectrum solve_spectrum(const Scene& scene, const CompiledScene& compiled, double until) {
  const double duration = step_of_loads(scene, 4).duration, window = std::max(1.2 * until, duration);
  const int n = std::clamp(static_cast<int>(std::ceil(least_frequencies * window / duration)), least_frequencies,
                           most_frequencies);
  std::vector<Complex> s;
  for (int j = 0; j < n; ++j) s.emplace_back(decay / window, j * spacing / window);
  return solve_spectrum(scene, compiled, s);
}

Spectrum solve_spectrum(const Scene& scene, const CompiledScene& compiled, const std::vector<Complex>& s,
                        BasisRoom* room) {
  const System& system = compiled.system;
  ReductionTargets targets;
  if (room == nullptr) targets.first_vectors = rough_vectors_per_load;
  const ReduceOptions options = reduce_options(scene, compiled, targets);
  BasisRoom of_its_own;
  const auto basis = (room != nullptr ? *room : of_its_own).basis(system, options);
  const ReducedSystem& reduced = basis->look(0).system;
  const Reading& F_T = system.readings[system.reading(reading::shear_force)];
  Spectrum spectrum;
  spectrum.s = s;
  const auto n = static_cast<Eigen::Index>(s.size());
  spectrum.X.resize(system.size(), n);
  spectrum.F.resize(static_cast<Eigen::Index>(system.loads.size()), n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const Complex at = s[static_cast<std::size_t>(j)];
    spectrum.F.col(j) = laplace_transform(options.training, at);
    spectrum.X.col(j) = frequency_response(basis->krylov(), reduced, at, spectrum.F.col(j));
    spectrum.shear.push_back(evaluate(F_T, spectrum.X.col(j), at, spectrum.F.col(j)));
  }
  return spectrum;
}

double shear_at(const std::vector<Complex>& s, const std::vector<Complex>& shear, double time) {
  Complex sum = 0.;
  for (std::size_t j = 0; j < s.size(); ++j) sum += (j == 0 ? 0.5 : 1.) * shear[j] * std::exp(s[j] * time);
  return sum.real() * s.at(1).imag() / pi;
}

MeshError mesh_error(const Scene& scene, const Space& space, const Unknowns& unknowns, const CompiledScene& compiled,
                     BasisRoom* room) {
  const System& system = compiled.system;
  const Spectrum spectrum = solve_spectrum(scene, compiled, frequencies(scene), room);
  const Reading& x_G = system.readings[system.reading(reading::displacement_x)];
  const auto n = static_cast<Eigen::Index>(spectrum.s.size());
  Eigen::VectorXd weight(n);
  double total = 0.;
  for (Eigen::Index j = 0; j < n; ++j) {
    const std::complex<double> s = spectrum.s[static_cast<std::size_t>(j)];
    const Eigen::VectorXcd X = spectrum.X.col(j), F = spectrum.F.col(j);
    // b'x stands for F x_G; F_T errs by m s^2 times the error of x_G.
    const double done = std::abs(work(system, X, F)), x = std::abs(evaluate(x_G, X, s, F));
    const double part = s.imag();  // weight in the integral over omega, for equal ratios
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
