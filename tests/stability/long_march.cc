#include "long_march.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <complex>

#include "dynamics/frequency_response.h"
#include "dynamics/projection.h"
#include "scenes.h"

namespace upbead::test {

namespace {

constexpr double pi = boost::math::constants::pi<double>();

/// A column of 5 m in two cells.
Compiled sand_column(bool wet, bool damped, const TimeFunction& load) {
  Region soil = sand();
  if (!wet) soil.flow = Flow::drained;
  if (!damped) soil.damping.reset();
  return Compiled(column(soil, load), *column_mesh(5., 2));
}

std::unique_ptr<Scheme> scheme_of(const System& system, SchemeKind kind) {
  SchemeOptions options;
  options.kind = kind;
  return make_scheme(system, options);
}

/// Product of the displacements in x with `direction`; phi is left out, as it is zero only once all water has come to
/// rest.
double along(const System& system, const Vector& x, const Vector& direction) {
  double sum = 0.;
  for (int i = 0; i < system.size(); ++i)
    if (system.field[static_cast<std::size_t>(i)] == Field::displacement) sum += x[i] * direction[i];
  return sum;
}

/// The static displacement; for a wet column that of the dry one, whose K is the same in u.
Vector static_answer(const System& system) {
  Eigen::MatrixXd K = system.K;
  Vector f = system.loads[0].vector;
  for (int i = 0; i < system.size(); ++i) {
    if (system.field[static_cast<std::size_t>(i)] == Field::displacement) continue;
    K.row(i).setZero();
    K.col(i).setZero();
    K(i, i) = 1.;
    f[i] = 0.;
  }
  return K.llt().solve(f);
}

}  // namespace

LongMarch march_long(SchemeKind kind, bool wet, int steps) {
  const Compiled compiled =
      sand_column(wet, wet, TimeFunction({0.}, {[](double) { return 0.; }, [](double) { return 1e4; }}));
  const System& system = compiled.system;
  const Vector answer = 1e4 * static_answer(system);
  const double size = along(system, answer, answer), h = 0.01;
  // Rayleigh's quotient of the static displacement: the frequency of the slowest mode to a few per cent
  const double omega = std::sqrt(answer.dot(system.K * answer) / answer.dot(system.M * answer));
  const auto scheme = scheme_of(system, kind);
  State state = at_rest(system);
  scheme->start(state);
  LongMarch found{system.n_free(), steps * h * omega / (2. * pi), 0., 0., 0., false};
  double first = 0., last = 0., mean = 0.;
  const int tenth = steps / 10;
  for (int i = 0; i < steps; ++i) {
    state.time = i * h;
    scheme->advance(state, h);
    if (i < tenth) first = std::max(first, scheme->energy().kinetic);
    if (i < steps - tenth) continue;
    last = std::max(last, scheme->energy().kinetic);
    mean += along(system, state.x, answer) / size / tenth;
  }
  found.energy = scheme->energy().mismatch();
  found.drift = std::abs(mean - 1.);
  found.motion = last / first;
  found.finite = std::isfinite(state.x.sum() + state.v.sum() + state.a.sum());
  return found;
}

std::vector<double> steady_state_errors(SchemeKind kind, int halvings) {
  const double omega = 2. * pi * 8., period = 2. * pi / omega;
  const Compiled compiled = sand_column(
      false, true, TimeFunction({0.}, {[](double) { return 0.; }, [omega](double t) { return std::sin(omega * t); }}));
  const System& system = compiled.system;
  SecondOrderKrylov krylov(system, omega);
  while (krylov.extend()) continue;
  const Projection projection(system, krylov);
  const Eigen::VectorXcd X = frequency_response(krylov, projection.reduced(), std::complex<double>(0., omega),
                                                Eigen::VectorXcd::Constant(1, 1.));
  std::vector<double> errors;
  for (int k = 0; k < halvings; ++k) {
    const int per_period = 16 << k, periods = 400;
    const double h = period / per_period;
    const auto scheme = scheme_of(system, kind);
    State state = at_rest(system);
    scheme->start(state);
    double error = 0., size = 0.;
    for (int i = 0; i < per_period * periods; ++i) {
      state.time = i * h;
      scheme->advance(state, h);
      if (i < per_period * (periods - 1)) continue;
      const Eigen::VectorXd exact = (X * std::exp(std::complex<double>(0., omega * (i + 1) * h))).imag();
      Vector difference = state.x - exact;
      for (int j = 0; j < system.size(); ++j)
        if (system.field[static_cast<std::size_t>(j)] != Field::displacement) difference[j] = 0.;
      error = std::max(error, difference.norm());
      size = std::max(size, exact.norm());
    }
    errors.push_back(error / size);
  }
  return errors;
}

}  // namespace upbead::test
