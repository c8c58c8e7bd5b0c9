// Claim: the few elements take the energy, and bear the stress, of the curve that they stand for within 2 %, from a
// damping ratio of 0.4 % on, at its own small-strain modulus and strength. Source: Masing's damping of a hyperbola, D =
// 4/pi (1 + 1/x)(1 - ln(1 + x)/x) - 2/pi, x = gamma/gamma_r; of other curves the overlay of 1700 elements.
#include "material/few_elements.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "law_paths.h"

namespace upbead {
namespace few_elements_test {

constexpr double G = 20e6, pi = 3.14159265358979323846;
const ElasticLaw elastic = elastic_law(G, 0.3);
using Ratio = std::function<double(double)>;

/// What a law takes in a steady cycle of simple shear (J/m3), and its stress at the amplitude.
struct Cycle {
  double energy = 0., stress = 0.;
  double damping(double amplitude) const { return energy / (2. * pi * stress * amplitude); }
};

Cycle cycle(const HystereticLaw& law, double amplitude) {
  constexpr int n = 500;
  testing::SoilPath path(hysteretic_points(std::make_shared<const HystereticLaw>(law))(0), law.elastic());
  path.shear_to(amplitude);
  Cycle found;
  for (int i = 1; i <= n; ++i) {
    const auto answer = path.to({0., 0., 0.5 * amplitude * std::cos(2. * pi * i / n)});
    found.energy += answer.dissipated;
    found.stress = answer.stress.xy;
  }
  return found;
}

std::vector<BackbonePoint> points(const Ratio& ratio, double from, double to, int n) {
  return concave(backbone(G, ratio, from, to, n));
}

double hyperbola(double x) {
  return 1. / (1. + x);
}

TEST(FewElements, DampAHyperbolaByMasing) {
  for (const double gamma_r : {1e-3, 7e-5}) {
    const auto ratio = [gamma_r](double gamma) { return hyperbola(gamma / gamma_r); };
    const auto few = with_few_elements(G, points(ratio, 0.001 * gamma_r, 30. * gamma_r, 1000));
    EXPECT_LE(few.size(), 30U);
    const HystereticLaw law(elastic, few);
    for (double x = 0.02; x < 10.1; x *= 1.1) {
      const Cycle found = cycle(law, x * gamma_r);
      const double stress = G * gamma_r * x * hyperbola(x);
      const double D = 4. / pi * (1. + 1. / x) * (1. - std::log1p(x) / x) - 2. / pi;
      EXPECT_NEAR(found.stress / stress, 1., 0.02) << x;
      EXPECT_NEAR(found.energy / (2. * pi * D * stress * x * gamma_r), 1., 0.02) << x;
      EXPECT_NEAR(found.damping(x * gamma_r) / D, 1., 0.02) << x;
    }
  }
}

/// G/G_max by rows, linear between them over log gamma, as a laboratory gives it; clay of PI 15 and sand.
Ratio table(std::vector<std::array<double, 2>> rows) {
  return [rows](double gamma) {
    std::size_t i = 1;
    while (i + 1 < rows.size() && rows[i][0] < gamma) ++i;
    const double share = std::log(gamma / rows[i - 1][0]) / std::log(rows[i][0] / rows[i - 1][0]);
    return rows[i - 1][1] + std::min(1., std::max(0., share)) * (rows[i][1] - rows[i - 1][1]);
  };
}
const Ratio clay = table(
    {{1e-6, 1.}, {1e-5, 0.99}, {3e-5, 0.96}, {1e-4, 0.87}, {3e-4, 0.68}, {1e-3, 0.43}, {3e-3, 0.22}, {1e-2, 0.1}});
const Ratio sand = table({{1e-6, 0.98}, {1e-5, 0.93}, {1e-4, 0.62}, {1e-3, 0.21}, {1e-2, 0.04}});

void expect_alike(const std::vector<BackbonePoint>& many, const std::vector<BackbonePoint>& given, const char* what) {
  const auto few = with_few_elements(G, given);
  EXPECT_LT(few.size(), 45U) << what;
  const HystereticLaw exact(elastic, many), law(elastic, few);
  EXPECT_NEAR(law.strength() / HystereticLaw(elastic, given).strength(), 1., 1e-9) << what;
  int compared = 0;
  for (double gamma = 1e-6; gamma < many.back().gamma; gamma *= 1.7) {
    const Cycle expected = cycle(exact, gamma), found = cycle(law, gamma);
    if (expected.damping(gamma) < 0.0042) continue;
    ++compared;
    EXPECT_NEAR(found.stress / expected.stress, 1., 0.02) << what << " " << gamma;
    EXPECT_NEAR(found.energy / expected.energy, 1., 0.02) << what << " " << gamma;
  }
  EXPECT_GT(compared, 5) << what;
}

TEST(FewElements, TakeTheEnergyOfATableAndOfAStrength) {
  expect_alike(points(clay, 1e-6, 1e-2, 1700), points(clay, 1e-6, 1e-2, 1000), "clay");
  expect_alike(points(sand, 1e-6, 1e-2, 1700), points(sand, 1e-6, 1e-2, 1000), "sand");
  const auto many = points(clay, 1e-6, 1e-2, 1700), given = points(clay, 1e-6, 1e-2, 1000);
  for (const double share : {0.7, 0.3})
    expect_alike(with_strength(many, share * many.back().tau), with_strength(given, share * given.back().tau), "cut");
}

/// Soil that is elastic up to its strength has one element, before and after.
TEST(FewElements, LeaveWhatHasFew) {
  const std::vector<BackbonePoint> one{{1e-3, 1e3}};
  EXPECT_EQ(with_few_elements(G, one).size(), 1U);
  const auto cut =
      with_strength(points([](double x) { return hyperbola(x / 1e-3); }, 1e-6, 3e-2, 1000), 1e-3 * G * 1e-3);
  EXPECT_NEAR(with_few_elements(G, cut).back().tau, 1e-3 * G * 1e-3, 1e-9 * G * 1e-3);
}

}  // namespace few_elements_test
}  // namespace upbead
