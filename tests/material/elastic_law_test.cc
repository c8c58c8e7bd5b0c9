#include "upbead/material/elastic_law.h"

#include <gtest/gtest.h>

#include <initializer_list>

namespace upbead {
namespace elastic_law_test {

constexpr double E = 30e6, nu = 0.2;
const ElasticLaw law = elastic_law(E / (2. * (1. + nu)), nu);

/// sigma_xx of a bar that strains by eps_xx, free to widen in y and held in z: E/(1 - nu^2) eps_xx.
TEST(ElasticLaw, FreeInOneDirectionOfThePlane) {
  const double xx = 1e-3, yy = -nu / (1. - nu) * xx;
  const PlaneStress stress = law.stress({xx, yy, 0.});
  EXPECT_NEAR(stress.xx, E / (1. - nu * nu) * xx, 1e-12 * stress.xx);
  EXPECT_NEAR(stress.yy, 0., 1e-12 * stress.xx);
  EXPECT_NEAR(stress.zz, nu * stress.xx, 1e-12 * stress.xx);
  EXPECT_EQ(stress.xy, 0.);
}

TEST(ElasticLaw, ConstrainedModulusIsThatOfAColumn) {
  EXPECT_NEAR(law.constrained_modulus(), E * (1. - nu) / ((1. + nu) * (1. - 2. * nu)), 1e-12 * E);
  EXPECT_EQ(law.stress({0., 1., 0.}).yy, law.constrained_modulus());
}

TEST(ElasticLaw, TangentAndRootSayWhatTheStressSays) {
  const auto D = law.tangent();
  const ElasticRoot root(law);
  for (const PlaneStrain strain : {PlaneStrain{1., 0., 0.}, {0., 1., 0.}, {0., 0., 1.}, {0.3, -0.7, 0.2}}) {
    const PlaneStress s = law.stress(strain);
    const double by_tangent[] = {D[0][0] * strain.xx + D[0][1] * strain.yy, D[1][0] * strain.xx + D[1][1] * strain.yy,
                                 D[2][2] * 2. * strain.xy};
    EXPECT_NEAR(s.xx, by_tangent[0], 1e-14 * E);
    EXPECT_NEAR(s.yy, by_tangent[1], 1e-14 * E);
    EXPECT_NEAR(s.xy, by_tangent[2], 1e-14 * E);
    double values[ElasticRoot::n_values], sum = 0.;
    root.write(strain, values);
    for (const double value : values) sum += value * value;
    EXPECT_NEAR(sum, s.xx * strain.xx + s.yy * strain.yy + 2. * s.xy * strain.xy, 1e-13 * E);
  }
}

TEST(ElasticLaw, KeepsPoissonsRatioWithAnotherModulus) {
  const ElasticLaw softer = law.with_shear_modulus(1e6), direct = elastic_law(1e6, nu);
  EXPECT_EQ(softer.G, direct.G);
  EXPECT_NEAR(softer.lambda, direct.lambda, 1e-13 * direct.lambda);
}

}  // namespace elastic_law_test
}  // namespace upbead
