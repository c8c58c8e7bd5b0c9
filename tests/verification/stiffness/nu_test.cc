// Claim: settlements of a solid layer under a strip load do not lock as Poisson's ratio tends to 0.5: errors stay
// bounded and fall under refinement as at nu = 0.3, at degree 2 with an order at most 1 lower.
// Source: tests/reference/ref9_stress.json, test e (exact layer, nu = 0.3 to 0.499999, itself good to 2e-5). Orders
// are those of the mean settlement of the loaded strip, which is an energy and so converges monotonically, against
// its value extrapolated by h^2 from degree 3. Limits: 0.5 % of the largest settlement at the tabulated points at h =
// b/8; order at most 1 below that at nu = 0.3; error of the mean settlement at nu = 0.499999 at most twice that at
// 0.4999.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "algebra/factorisation.h"
#include "loaded_layer.h"
#include "record.h"

namespace upbead::test {
namespace nu_test {

const std::vector<double> points{0., 0.5, 2.};  ///< x / b
const std::vector<int> levels{2, 4, 8};         ///< cells over half the load's width

struct Settlements {
  std::vector<double> at_points;
  double mean;  ///< of the loaded strip
};

Settlements settle(double nu, double depth, int degree, int n) {
  Region solid;
  solid.kind = RegionKind::solid;
  solid.shear_modulus = 1.;
  solid.poissons_ratio = nu;
  solid.density = 1.;
  Scene scene = loaded_layer(solid, 1., {});
  scene.mesh.degree = degree;
  add_probes_on_surface(scene, "surface", points);
  const auto mesh = even_layer_mesh({1., depth}, n);
  const Compiled compiled(scene, *mesh);
  const System& system = compiled.system;
  const Vector& load = system.loads.front().vector;  // its sum is -q b = -1
  State state = at_rest(system);
  state.x = Factorisation(system.K).solve(load);
  Settlements out{{}, load.dot(state.x)};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const int reading = system.reading("probes/surface" + std::to_string(i) + "/displacement_y");
    out.at_points.push_back(-evaluate(system.readings[static_cast<std::size_t>(reading)], state, {1.}));
  }
  return out;
}

double extrapolated_mean(double nu, double depth) {
  return (4. * settle(nu, depth, 3, 8).mean - settle(nu, depth, 3, 4).mean) / 3.;
}

class NuToHalf : public ::testing::TestWithParam<int> {};

TEST_P(NuToHalf, SettlementsDoNotLock) {
  const Json test = stress_test("e_nu_to_half");
  const double depth = test.at("H_over_b");
  const int degree = GetParam();
  Record record("stress_nu");
  const std::string name = "degree " + std::to_string(degree) + ", nu = ";
  std::vector<double> softness, exact, computed, orders, finest_error;
  for (const Json& row : test.at("rows")) {
    const double nu = row.at("nu"), mean = extrapolated_mean(nu, depth);
    const std::vector<double> u = row.at("u_z");
    Settlements settlements;
    std::vector<double> h, error;
    for (const int n : levels) {
      settlements = settle(nu, depth, degree, n);
      h.push_back(1. / n);
      error.push_back(std::abs(settlements.mean / mean - 1.));
    }
    const std::string here = name + row.at("nu").dump();
    record.at_most(here + ": settlements at h = b/8, largest error over the largest",
                   largest_error(settlements.at_points, u), 5e-3);
    orders.push_back(order(h, error));
    finest_error.push_back(error.back());
    if (orders.size() == 1)
      record.measured(here + ": order of the mean settlement, h = b/2 to b/8", orders.front());
    else
      record.at_least(here + ": order of the mean settlement less that at nu = 0.3", orders.back() - orders.front(),
                      -1.);
    softness.push_back(0.5 - nu);
    exact.push_back(u.front());
    computed.push_back(settlements.at_points.front());
  }
  record.at_most("degree " + std::to_string(degree) + ": error of the mean settlement at nu = 0.499999 over 0.4999",
                 finest_error[6] / finest_error[4], 2.);
  record.curve({"settlement of the middle, h = b/8", "0.5 - nu (log)", "mu u/(q b)", "degree " + std::to_string(degree),
                softness, exact, computed});
}

INSTANTIATE_TEST_SUITE_P(Degrees, NuToHalf, ::testing::Values(2, 3));

}  // namespace nu_test
}  // namespace upbead::test
