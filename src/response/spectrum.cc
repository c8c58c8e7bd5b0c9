#include "response/spectrum.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "dynamics/frequency_response.h"
#include "dynamics/projection.h"
#include "fem/caisson_readings.h"
#include "response/reduction.h"
#include "response/step_choice.h"

namespace upbead {

namespace {

using Complex = std::complex<double>;

constexpr int rough_vectors_per_load = 20, least_frequencies = 10, most_frequencies = 80;
constexpr double decay = 2., spacing = pi;  // both over the window

}  // namespace

Complex evaluate(const Reading& reading, const Eigen::VectorXcd& X, Complex s, const Eigen::VectorXcd& F) {
  Complex value = 0.;
  for (const auto& [i, weight] : reading.position) value += weight * X[i];
  for (const auto& [i, weight] : reading.velocity) value += weight * s * X[i];
  for (const auto& [i, weight] : reading.acceleration) value += weight * s * s * X[i];
  for (std::size_t k = 0; k < reading.feedthrough.size(); ++k)
    value += reading.feedthrough[k] * F[static_cast<Eigen::Index>(k)];
  return value;
}

Spectrum solve_spectrum(const Scene& scene, const CompiledScene& compiled, double until) {
  const double duration = step_of_loads(scene, 4).duration, window = std::max(1.2 * until, duration);
  const int n = std::clamp(static_cast<int>(std::ceil(least_frequencies * window / duration)), least_frequencies,
                           most_frequencies);
  std::vector<Complex> s;
  for (int j = 0; j < n; ++j) s.emplace_back(decay / window, j * spacing / window);
  return solve_spectrum(scene, compiled, s);
}

Spectrum solve_spectrum(const Scene& scene, const CompiledScene& compiled, const std::vector<Complex>& s) {
  const System& system = compiled.system;
  SecondOrderKrylov krylov(system, krylov_shift(scene), compiled.body_coordinates);
  while (krylov.n_vectors() < rough_vectors_per_load * krylov.n_independent_loads() && krylov.extend()) {
  }
  const Projection projection(system, krylov);
  const SampledLoads loads = sampled_loads(scene, system);
  const Reading& F_T = system.readings[system.reading(reading::shear_force)];
  Spectrum spectrum;
  spectrum.s = s;
  const auto n = static_cast<Eigen::Index>(s.size());
  spectrum.X.resize(system.size(), n);
  spectrum.F.resize(static_cast<Eigen::Index>(system.loads.size()), n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const Complex at = s[static_cast<std::size_t>(j)];
    spectrum.F.col(j) = laplace_transform(loads, at);
    spectrum.X.col(j) = frequency_response(krylov, projection.reduced(), at, spectrum.F.col(j));
    spectrum.shear.push_back(evaluate(F_T, spectrum.X.col(j), at, spectrum.F.col(j)));
  }
  return spectrum;
}

double shear_at(const std::vector<Complex>& s, const std::vector<Complex>& shear, double time) {
  Complex sum = 0.;
  for (std::size_t j = 0; j < s.size(); ++j) sum += (j == 0 ? 0.5 : 1.) * shear[j] * std::exp(s[j] * time);
  return sum.real() * s.at(1).imag() / pi;
}

}  // namespace upbead
