// Claim: the iteration for equivalent-linear soil converges to an oscillator with the secant stiffness for its own
// strain. The oscillator: a rigid block on a layer that is 400 times wider than thick, has nearly no mass, and only
// shears: stiffness G B / h, strain u / h. Tolerance: 0.3 % for the effects of the layer's ends and of rocking if
// both make the same number of iterations; 1 %, the program's limit of convergence, against the fixed point.

#include <cmath>

#include "good_case.h"
#include "sheared_layer.h"
#include "upbead/algebra/petsc_session.h"
#include "upbead/case/case_run.h"

namespace upbead::test {
namespace equivalent_linear_test {

constexpr double B = 400., h = 1., mass = 4e6, G_max = 1e6, duration = 0.2;

std::string layer_case(double peak, const std::string& strain, const std::string& time) {
  return R"([mesh]
file = "layer.geo"
[regions.soil]
kind = "solid"
deformation = "elastic"
density = 1e-3
shear_modulus = 1e6
poissons_ratio = 0.3
damping = { ratio = 0.0, frequencies = [1.0, 10.0] }
strain = )" +
         strain + block_on_layer(peak) + "end = 1.5\n" + time;
}

struct Peaks {
  double u = 0., F_T = 0.;
};

/// The oscillator under the triangle, by Runge and Kutta's fourth-order steps.
Peaks oscillate(double G, double stiffness_damping, double peak) {
  const double k = G * B / h, c = stiffness_damping * k, step = 1e-4;
  const auto P = [&](double t) { return t < duration ? peak * (1. - std::abs(2. * t / duration - 1.)) : 0.; };
  double u = 0., v = 0.;
  Peaks peaks;
  for (double t = 0.; t < 1.5; t += step) {
    const auto a = [&](double at, double x, double w) { return (P(at) - c * w - k * x) / mass; };
    const double a1 = a(t, u, v), v2 = v + step / 2. * a1, a2 = a(t + step / 2., u + step / 2. * v, v2);
    const double v3 = v + step / 2. * a2, a3 = a(t + step / 2., u + step / 2. * v2, v3);
    const double v4 = v + step * a3, a4 = a(t + step, u + step * v3, v4);
    u += step / 6. * (v + 2. * v2 + 2. * v3 + v4);
    v += step / 6. * (a1 + 2. * a2 + 2. * a3 + a4);
    peaks.u = std::max(peaks.u, std::abs(u));
    peaks.F_T = std::max(peaks.F_T, std::abs(k * u + c * v));
  }
  return peaks;
}

class EquivalentLinear : public InFolder {
 protected:
  SoilSummary settle(double peak, const std::string& strain, const std::string& time = "step = 0.005\n") {
    static const PetscSession petsc;  // MPI starts once in a process
    write("layer.geo", layer_geo(61));
    write("case.toml", layer_case(peak, strain, time));
    const Case input = read_case("case.toml");
    const Simulation scene = simulation_of(input);
    return *solve(input, scene).summary.soil;
  }
};

TEST_F(EquivalentLinear, SettlesWhereTheOscillatorDoes) {
  for (const double peak : {2e4, 4e5, 2e6}) {
    SCOPED_TRACE(peak);
    const SoilSummary found =
        settle(peak, "{ reference_strain = 1e-3, smallest_damping = 0.0, largest_damping = 0.0 }");
    EXPECT_TRUE(found.converged);
    double G = G_max;
    Peaks peaks = oscillate(G, 0., peak);
    EXPECT_NEAR(found.linear, peaks.F_T, 3e-3 * peaks.F_T);
    for (int i = 0; i < found.iterations; ++i) {
      G = G_max / (1. + 0.65 * peaks.u / h / 1e-3);
      peaks = oscillate(G, 0., peak);
    }
    EXPECT_NEAR(found.settled, peaks.F_T, 3e-3 * peaks.F_T);
    EXPECT_NEAR(found.largest_strain, 0.65 * peaks.u / h, 5e-3 * peaks.u / h);
    for (int i = 0; i < 200; ++i) {
      G = std::sqrt(G * G_max / (1. + 0.65 * peaks.u / h / 1e-3));
      peaks = oscillate(G, 0., peak);
    }
    EXPECT_NEAR(found.settled, peaks.F_T, 0.01 * peaks.F_T) << "the fixed point";
    EXPECT_TRUE(peak < 1e6 || found.settled < 0.8 * found.linear) << "a large wave feels soft soil";
    EXPECT_TRUE(peak > 1e5 || found.settled > 0.95 * found.linear) << "a small one does not";
  }
}

TEST_F(EquivalentLinear, TakesDampingFromTheStrainToo) {
  const double peak = 1e6;
  const SoilSummary found =
      settle(peak, "{ modulus = [[1e-6, 1.0], [1.0, 1.0]], damping = [[1e-4, 0.0], [1e-2, 0.3]] }");
  double damping = 0.;
  Peaks peaks = oscillate(G_max, 0., peak);
  for (int i = 0; i < found.iterations; ++i) {
    damping = 0.3 * std::log(0.65 * peaks.u / h / 1e-4) / std::log(1e2);
    peaks = oscillate(G_max, damping / (std::acos(-1.) * 11.), peak);
  }
  EXPECT_GT(damping, 0.1);
  EXPECT_NEAR(found.settled, peaks.F_T, 3e-3 * peaks.F_T);
  EXPECT_LT(found.settled, 0.97 * found.linear);
  EXPECT_EQ(found.least_modulus_ratio, 1.);
}

TEST_F(EquivalentLinear, SettlesAlikeByReducedModelsAndMarches) {
  for (const std::string damping : {"0.0", "0.1"}) {
    SCOPED_TRACE(damping);
    const std::string strain =
        "{ reference_strain = 1e-3, smallest_damping = " + damping + ", largest_damping = " + damping + " }";
    const SoilSummary reduced = settle(2e6, strain, "scheme = \"reduced\"\n");
    const SoilSummary marched = settle(2e6, strain, "scheme = \"sdirk4\"\nstep = 0.0025\n");
    EXPECT_EQ(reduced.iterations, marched.iterations);
    EXPECT_NE(reduced.settled, marched.settled) << "both were marched";
    EXPECT_NEAR(reduced.linear, marched.linear, 5e-3 * marched.linear);
    EXPECT_NEAR(reduced.settled, marched.settled, 5e-3 * marched.settled);
    EXPECT_NEAR(reduced.largest_strain, marched.largest_strain, 0.01 * marched.largest_strain);
    EXPECT_NEAR(reduced.least_modulus_ratio, marched.least_modulus_ratio, 0.01 * marched.least_modulus_ratio);
  }
}

TEST_F(EquivalentLinear, IsNothingWithoutAStrainLaw) {
  EXPECT_FALSE(follows_strain(Scene()));
}

}  // namespace equivalent_linear_test
}  // namespace upbead::test
