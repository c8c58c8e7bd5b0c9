#include "material/hysteretic_law.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "law_paths.h"
#include "upbead/base/error.h"

namespace upbead {
namespace hysteretic_law_test {

using namespace testing;

constexpr double G = 80e6, nu = 0.3, gamma_r = 5e-4;
const ElasticLaw elastic = elastic_law(G, nu);

double hyperbola(double gamma) {
  return G * gamma / (1. + gamma / gamma_r);
}

HystereticLaw law_of(int n, double from = 1e-2 * gamma_r, double to = 30. * gamma_r) {
  return HystereticLaw(elastic, backbone(
                                    G, [](double gamma) { return 1. / (1. + gamma / gamma_r); }, from, to, n));
}

SoilPath path_of(const HystereticLaw& law) {
  return {hysteretic_points(std::make_shared<const HystereticLaw>(law))(0), law.elastic()};
}

TEST(HystereticLaw, FirstShearFollowsTheBackbone) {
  const HystereticLaw law = law_of(12);
  SoilPath path = path_of(law);
  for (const BackbonePoint& point : backbone(
           G, [](double x) { return 1. / (1. + x / gamma_r); }, 1e-2 * gamma_r, 30. * gamma_r, 12))
    EXPECT_NEAR(path.shear_to(point.gamma), hyperbola(point.gamma), 1e-12 * G * gamma_r);
  double sum = 0.;
  for (const HystereticLaw::Element& element : law.elements()) sum += element.h;
  EXPECT_NEAR(sum, G, 1e-14 * G);
  EXPECT_NEAR(path.shear_to(1.), hyperbola(30. * gamma_r), 1e-9 * G * gamma_r) << "level beyond the last point";
}

TEST(HystereticLaw, SmallStrainsAreElastic) {
  const HystereticLaw law = law_of(12);
  SoilPath path = path_of(law);
  const PlaneStrain strain{2e-7, -1e-7, 3e-7};
  const SoilPath::Answer answer = path.to(strain);
  const PlaneStress expected = elastic.stress(strain);
  EXPECT_EQ(answer.stress.xx, expected.xx);
  EXPECT_EQ(answer.stress.zz, expected.zz);
  EXPECT_EQ(answer.stress.xy, expected.xy);
  EXPECT_EQ(answer.dissipated, 0.);
}

/// Masing (1926): tau_a - tau = 2 f((gamma_a - gamma)/2) on unloading, and the same on reloading; loops close.
TEST(HystereticLaw, UnloadsAndReloadsByMasing) {
  const HystereticLaw law = law_of(12);
  for (const double top : {0.3 * gamma_r, gamma_r, 9. * gamma_r}) {
    const auto first = [&](double gamma) {
      SoilPath path = path_of(law);
      return path.shear_to(gamma);
    };
    SoilPath path = path_of(law);
    const double tau_top = path.shear_to(top);
    for (const double gamma : {0.7 * top, 0., -0.4 * top, -top})
      EXPECT_NEAR(path.shear_to(gamma), tau_top - 2. * first(0.5 * (top - gamma)), 1e-12 * tau_top);
    for (const double gamma : {-0.2 * top, 0.6 * top, top})
      EXPECT_NEAR(path.shear_to(gamma), -tau_top + 2. * first(0.5 * (top + gamma)), 1e-12 * tau_top);
  }
}

/// D = 4/pi (1 + 1/x)(1 - ln(1 + x)/x) - 2/pi, x = gamma/gamma_r: damping of a hyperbola by Masing's rules.
TEST(HystereticLaw, ModulusAndDampingOverStrain) {
  const HystereticLaw law = law_of(400, 1e-4 * gamma_r, 20. * gamma_r);
  const double pi = std::acos(-1.);
  for (const double x : {0.1, 1., 10.}) {
    const double top = x * gamma_r, damping = 4. / pi * (1. + 1. / x) * (1. - std::log1p(x) / x) - 2. / pi;
    SoilPath path = path_of(law);
    const double tau = path.shear_to(top);
    EXPECT_NEAR(tau / (G * top), 1. / (1. + x), 1e-4 / (1. + x));
    double loop = 0.;
    for (int i = 1; i <= 2000; ++i) loop += path.to({0., 0., 0.5 * top * std::cos(2. * pi * i / 2000)}).dissipated;
    EXPECT_NEAR(loop / (2. * pi * tau * top), damping, 1e-3 * damping) << "x = " << x;
  }
}

/// In every step, average stress times strain is the energy stored plus the energy lost; no step releases energy.
TEST(HystereticLaw, EnergyClosesAndDissipationIsNeverNegative) {
  const HystereticLaw law = law_of(10);
  std::mt19937 random(24);
  double worst = 0., least = 0.;
  for (int run = 0; run < 1000; ++run) {
    SoilPath path = path_of(law);
    PlaneStress before;
    PlaneStrain strain;
    for (int i = 0; i < 1000; ++i) {
      const PlaneStrain step = random_strain(random, gamma_r * std::pow(10., -2. + 3. * (run % 10) / 9.));
      const double stored = path.stored();
      const PlaneStrain last = strain;
      strain = plus(step, strain, 0.9);  // energies are found beside those of elastic soil, which grow with the strain
      const SoilPath::Answer answer = path.to(strain);
      const PlaneStrain moved = plus(strain, last, -1.);
      const double done = 0.5 * (work(before, moved) + work(answer.stress, moved));
      const double scale = path.stored() + stored + answer.dissipated;
      EXPECT_NEAR(answer.stress.xx + answer.stress.yy + answer.stress.zz,
                  (3. * elastic.lambda + 2. * G) * (strain.xx + strain.yy), 1e-9 * G * gamma_r);
      worst = std::max(worst, std::abs(done - answer.dissipated - path.stored() + stored) / scale);
      least = std::min(least, answer.dissipated);
      before = answer.stress;
    }
  }
  EXPECT_LT(worst, 1e-11);
  EXPECT_GE(least, 0.);
}

TEST(HystereticLaw, AnswersInTurnedAxesAndInOtherUnits) {
  const HystereticLaw law = law_of(10),
                      in_kPa(elastic_law(1e-3 * G, nu), backbone(
                                                            1e-3 * G, [](double x) { return 1. / (1. + x / gamma_r); },
                                                            1e-2 * gamma_r, 30. * gamma_r, 10));
  std::mt19937 random(3);
  SoilPath path = path_of(law), turned = path_of(law), other = path_of(in_kPa);
  for (int i = 0; i < 100; ++i) {
    const PlaneStrain strain = random_strain(random, gamma_r);
    const SoilPath::Answer answer = path.to(strain), kPa = other.to(strain);
    const PlaneStress back = in_turned_axes(turned.to(in_turned_axes(strain, 0.4)).stress, -0.4);
    EXPECT_NEAR(back.xx, answer.stress.xx, 1e-11 * G * gamma_r);
    EXPECT_NEAR(back.xy, answer.stress.xy, 1e-11 * G * gamma_r);
    EXPECT_NEAR(1e3 * kPa.stress.xx, answer.stress.xx, 1e-11 * G * gamma_r);
    EXPECT_NEAR(1e3 * kPa.dissipated, answer.dissipated, 1e-11 * G * gamma_r * gamma_r);
  }
}

TEST(HystereticLaw, StrengthCutsTheBackbone) {
  const auto points = backbone(
      G, [](double x) { return 1. / (1. + x / gamma_r); }, 1e-2 * gamma_r, 30. * gamma_r, 10);
  for (const double strength : {0.9 * points.back().tau, 0.5 * points.back().tau, 0.5 * points.front().tau}) {
    const HystereticLaw law(elastic, with_strength(points, strength));
    SoilPath path = path_of(law);
    EXPECT_NEAR(path.shear_to(1.), strength, 1e-9 * strength);
  }
  EXPECT_EQ(with_strength(points, 2. * points.back().tau).size(), points.size());
  const auto cut = with_strength(points, points[4].tau);
  ASSERT_EQ(cut.size(), 5u) << "a point at the strength is the last, and stands there once";
  EXPECT_EQ(cut.back().gamma, points[4].gamma);
}

TEST(HystereticLaw, MobilisesAllOfItsStrengthWhereItFlows) {
  const HystereticLaw law = law_of(10);
  SoilPath path = path_of(law);
  const double knee = 1e-2 * gamma_r * std::pow(3000., 5. / 9.);  // a corner of the polygon, on the hyperbola
  EXPECT_NEAR(law.mobilised({0., 0., path.shear_to(knee), 0.}), hyperbola(knee) / hyperbola(30. * gamma_r), 1e-9);
  EXPECT_NEAR(law.mobilised(path.to({0.3, -0.1, 0.2}).stress), 1., 1e-4);
}

TEST(HystereticLaw, RefusesWhatIsNoBackbone) {
  try {
    HystereticLaw(elastic, {});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("at a strain of 0.000000"), std::string::npos) << error.what();
  }
  EXPECT_THROW(HystereticLaw(elastic, {{1e-4, 1.1e-4 * G}}), InputError) << "stiffer than G";
  EXPECT_THROW(HystereticLaw(elastic, {{1e-4, 0.9e-4 * G}, {2e-4, 0.8e-4 * G}}), InputError) << "softens";
  EXPECT_THROW(HystereticLaw(elastic, {{1e-4, 0.5e-4 * G}, {2e-4, 0.6e-4 * G}, {3e-4, 1.2e-4 * G}}), InputError);
}

}  // namespace hysteretic_law_test
}  // namespace upbead
