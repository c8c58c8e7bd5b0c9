#include "upbead/response/mesh_error.h"

#include "upbead/fem/caisson_readings.h"
#include "upbead/fem/surplus.h"
#include "upbead/response/spectrum.h"

namespace upbead {

namespace {

/// True errors were 0.1 to 2 times the sum of the cells' on twelve scenes (docs/verification.md); this puts the worst
/// underestimate to 1.7.
constexpr double underestimate = 1.25;

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
  const Spectrum spectrum = solve_spectrum(scene, compiled);
  const Reading& x_G = system.readings[system.reading(reading::displacement_x)];
  const auto n = static_cast<Eigen::Index>(spectrum.s.size());
  Eigen::VectorXd weight(n);
  double total = 0.;
  for (Eigen::Index j = 0; j < n; ++j) {
    const std::complex<double> s = spectrum.s[static_cast<std::size_t>(j)];
    const Eigen::VectorXcd X = spectrum.X.col(j), F = spectrum.F.col(j);
    // b'x stands for F x_G; F_T errs by m s^2 times the error of x_G.
    const double done = std::abs(work(system, X, F)), x = std::abs(evaluate(x_G, X, s, F));
    weight[j] = done > 0. ? compiled.caisson->body.mass * std::norm(s) * x / done : 0.;
    total += std::abs(spectrum.shear[static_cast<std::size_t>(j)]);
  }
  const Eigen::VectorXd of_cell = cell_errors(scene, space, unknowns, spectrum.X, spectrum.s) * weight;
  MeshError error;
  for (const double value : of_cell) {
    error.of_cell.push_back(total > 0. ? underestimate * value / total : 0.);
    error.sum += error.of_cell.back();
  }
  return error;
}

}  // namespace upbead
