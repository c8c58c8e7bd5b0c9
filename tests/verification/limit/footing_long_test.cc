// Claims: the loads of strips that are pushed into ground with friction and weight, or sideways on undrained ground,
// tend to those of plasticity theory from above.

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "footing.h"
#include "from_above.h"

namespace upbead::test {
namespace footing_long_test {

/// A friction angle, the exact factor, the size of the ground, and how often cells are split.
struct Failing {
  double degrees, exact, width, depth, settlement;
  int times;
  double limit;
};

class FootingLong : public ::testing::TestWithParam<Failing> {};

std::string angle(const Failing& p) {
  return std::to_string(static_cast<int>(p.degrees)) + " degrees";
}

Footing on(const Failing& p) {
  Footing f;
  f.soil = {p.degrees, 0., p.degrees, 1e12};
  f.width = p.width;
  f.depth = p.depth;
  f.settlement = p.settlement;
  return f;
}

class Surcharged : public FootingLong {};

/// N_c = (N_q - 1)/tan phi: see footing_test.cc.
TEST_P(Surcharged, TendsToReissners) {
  Record record("footing");
  const Failing& p = GetParam();
  Footing f = on(p);
  f.surcharge = 1.;
  f.largest = 0.75;
  std::vector<std::pair<int, double>> of_q, of_c;
  for (const FootingAnswer& answer : push(f, p.times)) {
    ASSERT_TRUE(answer.report.complete);
    of_q.emplace_back(answer.unknowns, answer.load.back() / p.exact - 1.);
    of_c.emplace_back(answer.unknowns, (answer.load.back() - 1.) / (p.exact - 1.) - 1.);
  }
  tends_from_above(record, "N_q, " + angle(p), of_q, p.limit);
  tends_from_above(record, "N_c, " + angle(p), of_c, p.limit);
}
INSTANTIATE_TEST_SUITE_P(Angles, Surcharged,
                         ::testing::Values(Failing{30., 18.401, 5.25, 2.25, 0.008, 6, 0.0031},
                                           Failing{35., 33.296, 6.75, 2.5, 0.015, 5, 0.0057},
                                           Failing{40., 64.195, 9.5, 3., 0.04, 5, 0.0064}));

class Heavy : public FootingLong {};

/// gamma = B = 1.
TEST_P(Heavy, TendsToMartins) {
  Record record("footing");
  const Failing& p = GetParam();
  Footing f = on(p);
  f.unit_weight = 1.;
  std::vector<std::pair<int, double>> errors;
  for (const FootingAnswer& answer : push(f, p.times)) {
    ASSERT_TRUE(answer.report.complete);
    errors.emplace_back(answer.unknowns, 2. * answer.load.back() / p.exact - 1.);
  }
  tends_from_above(record, "N_gamma, " + angle(p), errors, p.limit);
}
INSTANTIATE_TEST_SUITE_P(Angles, Heavy,
                         ::testing::Values(Failing{30., 14.754, 2.75, 1.25, 0.001, 5, 0.0195},
                                           Failing{35., 34.476, 4.25, 1.75, 0.0025, 3, 0.055},
                                           Failing{40., 85.566, 6.75, 2.25, 0.007, 1, 0.18}));

/// If the strip is pushed along (sqrt 3, -1), its motion is normal to the exact curve at h = 0.5. A load whose
/// component along that normal is not below the exact one lies outside the convex curve.
TEST(FootingAside, FollowsGreen) {
  Record record("footing");
  Footing f = on_clay();
  f.settlement = 0.02;
  f.sideways = std::sqrt(3.);
  const double pi = std::acos(-1.);
  const auto exact = [&](double h) { return 1. + 0.5 * pi + std::acos(h) + std::sqrt(1. - h * h); };
  std::vector<std::pair<int, double>> along, of_V;
  for (const FootingAnswer& answer : push(f, 5)) {
    ASSERT_TRUE(answer.report.complete);
    const double V = answer.load.back(), H = std::abs(answer.shear.back());
    ASSERT_LT(H, 1.);
    along.emplace_back(answer.unknowns, (V + f.sideways * H) / (exact(0.5) + f.sideways * 0.5) - 1.);
    of_V.emplace_back(answer.unknowns, V / exact(H) - 1.);
  }
  tends_from_above(record, "pushed aside, load along the way", along, 0.0085);
  tends_from_above(record, "pushed aside, V against Green's at its H", of_V, 0.0105);
}

}  // namespace footing_long_test
}  // namespace upbead::test
