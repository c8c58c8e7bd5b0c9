#include "upbead/response/step_choice.h"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <cstdio>

#include "upbead/algebra/factorisation.h"
#include "upbead/base/stopwatch.h"
#include "upbead/fem/caisson_readings.h"

namespace upbead {

namespace {

constexpr double pi = boost::math::constants::pi<double>();

/// Natural period of the caisson on its ground (s), 0 where no load moves it.
double natural_period(const CompiledScene& compiled, double s) {
  const System& system = compiled.system;
  Vector b = Vector::Zero(system.size());
  double force = 0.;
  for (std::size_t k = 0; k < system.loads.size(); ++k) {
    b += system.loads[k].vector;
    force += compiled.loads_on_caisson[k].force_x;
  }
  const int n = system.n_free();
  const SparseMatrix S = (s * s * system.M + s * system.C + system.K).eval().topLeftCorner(n, n);
  const Vector x = Factorisation(S, system.blocks).solve(b.head(n));
  double x_G = 0.;
  for (const auto& [i, weight] : system.readings[system.reading(reading::displacement_x)].position)
    if (i < n) x_G += weight * x[i];
  const double mass = compiled.caisson->body.mass;
  const double stiffness = x_G != 0. ? force / x_G - mass * s * s : 0.;
  return stiffness > 0. ? 2. * pi * std::sqrt(mass / stiffness) : 0.;
}

std::string text(const char* format, double a, double b) {
  char buffer[160];
  std::snprintf(buffer, sizeof buffer, format, a, b);
  return buffer;
}

}  // namespace

StepChoice choose_step(const Scene& scene, const CompiledScene& compiled, int order) {
  const Stopwatch watch;
  const double end = scene.time.end;
  const double jump_free = std::min(shortest_duration(scene), end);
  const double duration = jump_free > 0. ? jump_free : end / 20.;
  StepChoice choice;
  if (compiled.caisson && scene.time.inertia) {
    choice.natural_period = natural_period(compiled, pi / duration);
    choice.factorisations = 1;
  }
  const double period = choice.natural_period > 0. ? choice.natural_period : duration;
  // Fractions measured for a tolerance of 0.5 %: docs/accuracy.md.
  const double fraction = (order >= 4 ? 1. / 8. : 1. / 64.) * std::pow(scene.tolerance / 0.005, 1. / order);
  choice.largest_step = std::min(fraction * std::min(duration, period), end);
  choice.reason = text("shortest load %.4g s, natural period %.4g s", duration, choice.natural_period);
  choice.seconds = watch.seconds();
  return choice;
}

}  // namespace upbead
