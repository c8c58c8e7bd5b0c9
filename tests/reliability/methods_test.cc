// Each method against limit states whose probability is known.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <cmath>

#include "reliability/chance.h"
#include "reliability/methods.h"
#include "reliability/random_variables.h"

namespace upbead {
namespace methods_test {

using boost::math::cdf;
using boost::math::complement;
using Values = std::vector<double>;

/// R and S normal, with means 10 and 6, deviations 1.2 and 1.6: beta = 4/2 = 2 (Cornell 1969).
RandomVariables resistance_and_load() {
  RandomVariables variables{{"R", "S"}, {RandomVariable(), RandomVariable()}, {}};
  variables.list[0].mean = 10.;
  variables.list[0].deviation = 1.2;
  variables.list[1].mean = 6.;
  variables.list[1].deviation = 1.6;
  return variables;
}

Margin in_physical(const RandomVariables& variables, const std::function<double(const Values&)>& g) {
  const StandardSpace space(variables);
  return [space, g](const Values& u) { return g(space.physical(u)); };
}

double difference(const Values& x) {
  return x[0] - x[1];
}

TEST(Form, IsExactForTheDifferenceOfNormalVariables) {
  const DesignPointSearch found = find_design_point(in_physical(resistance_and_load(), difference), 2);
  EXPECT_NEAR(*by_form(found).index, 2., 1e-6);
  EXPECT_NEAR(*by_form(found).probability, cdf(boost::math::normal(), -2.), 1e-8);
  EXPECT_NEAR(found.point->alpha[0], -0.6, 1e-5);  // -1.2/2: the resistance is low
  EXPECT_NEAR(found.point->alpha[1], 0.8, 1e-5);
}

TEST(Form, KnowsDependence) {
  RandomVariables variables = resistance_and_load();
  variables.correlations.push_back({"R", "S", 0.5});
  const double beta = 4. / std::sqrt(1.2 * 1.2 + 1.6 * 1.6 - 2. * 0.5 * 1.2 * 1.6);
  EXPECT_NEAR(*by_form(find_design_point(in_physical(variables, difference), 2)).index, beta, 1e-5);
}

TEST(Form, DoesNotDependOnUnits) {
  const Margin small = in_physical(resistance_and_load(), difference);
  const Margin large = [small](const Values& u) { return 1e9 * small(u); };
  EXPECT_NEAR(*by_form(find_design_point(large, 2)).index, *by_form(find_design_point(small, 2)).index, 1e-5);
}

TEST(Form, HasANegativeIndexWhereTheMeansFail) {
  const DesignPointSearch found =
      find_design_point(in_physical(resistance_and_load(), [](const Values& x) { return x[0] - x[1] - 6.; }), 2);
  EXPECT_NEAR(*by_form(found).index, -1., 1e-5);
  EXPECT_NEAR(*by_form(found).probability, cdf(boost::math::normal(), 1.), 1e-6);
  EXPECT_NEAR(found.point->alpha[0], -0.6, 1e-4);
}

TEST(Form, ThatEndsAtNoDesignPointHasFoundNothing) {
  const auto never = [](const Values&) { return 1.; };
  const DesignPointSearch found = find_design_point(never, 2);
  EXPECT_FALSE(found.point);
  EXPECT_FALSE(by_form(found).probability);
  EXPECT_THAT(by_form(found).why_not, testing::HasSubstr("no design point"));
  EXPECT_FALSE(by_sorm(never, found).probability);
  EXPECT_FALSE(by_importance(never, {}, {}).probability);
}

/// ln R - ln S of lognormal variables is normal: beta in closed form.
TEST(Form, IsExactForTheQuotientOfLognormalVariables) {
  RandomVariables variables = resistance_and_load();
  for (RandomVariable& v : variables.list) v.kind = RandomKind::lognormal;
  const double r = std::log1p(0.12 * 0.12), s = std::log1p(std::pow(1.6 / 6., 2));
  const double beta = (std::log(10. / 6.) - 0.5 * r + 0.5 * s) / std::sqrt(r + s);
  EXPECT_NEAR(*by_form(find_design_point(in_physical(variables, difference), 2)).index, beta, 1e-4);
}

/// One variable: whatever its distribution, beta is -Phi^-1(1 - F(limit)).
void expect_exact(const RandomVariable& variable, double limit, double exceedance) {
  const Margin margin = in_physical({{"X"}, {variable}, {}}, [limit](const Values& x) { return limit - x[0]; });
  EXPECT_NEAR(*by_form(find_design_point(margin, 1)).index, *index_of(exceedance), 1e-4);
}

TEST(Form, IsExactForOneVariableOfAnyDistribution) {
  RandomVariable v;
  v.mean = 6.;
  v.deviation = 1.;
  v.kind = RandomKind::gumbel;  // scale sqrt(6)/pi, location mean - Euler's constant times scale
  const double scale = std::sqrt(6.) / M_PI, location = 6. - 0.57721566490153286 * scale;
  expect_exact(v, 10., -std::expm1(-std::exp(-(10. - location) / scale)));
  v.kind = RandomKind::weibull;  // shape 1 about 5: an exponential law
  v.location = 5.;
  expect_exact(v, 12., std::exp(-7.));
  v = {};
  v.kind = RandomKind::uniform;
  v.low = 2.;
  v.high = 4.;
  expect_exact(v, 3.9, 0.05);
  v.kind = RandomKind::triangular;
  v.mode = 3.;
  expect_exact(v, 3.8, 0.5 * 0.2 * 0.2);
  v = {};
  v.mean = 0.;
  v.deviation = 1.;
  v.high = 1.;  // cut
  const boost::math::normal normal;
  expect_exact(v, 0.5, (cdf(normal, 1.) - cdf(normal, 0.5)) / cdf(normal, 1.));
}

/// g = beta - u_n + kappa/2 (u_1^2 + ... ): beta as curvatures kappa (Breitung 1984): Phi(-beta) prod (1 + beta
/// kappa)^-1/2.
TEST(Sorm, IsBreitungsFormulaForAParaboloid) {
  const double beta = 3., kappa = 0.2;
  const Margin margin = [=](const Values& u) { return beta - u[2] + 0.5 * kappa * (u[0] * u[0] + u[1] * u[1]); };
  const DesignPointSearch found = find_design_point(margin, 3);
  EXPECT_NEAR(*by_form(found).index, beta, 1e-4);
  const double breitung = cdf(boost::math::normal(), -beta) / (1. + beta * kappa);
  EXPECT_NEAR(*by_sorm(margin, found).probability, breitung, 1e-3 * breitung);
}

/// Failure outside a sphere: chi square. FORM sees one point of it, and sampling all around sees the whole.
TEST(Subset, FindsTheOutsideOfASphereThatFormCannot) {
  const double radius = 4.;
  const Margin margin = [=](const Values& u) { return radius * radius - u[0] * u[0] - u[1] * u[1] - u[2] * u[2]; };
  const double exact = *index_of(cdf(complement(boost::math::chi_squared(3), radius * radius)));
  const MethodAnswer subset = by_subset(margin, 3, {1, 50000, 1000, 0.01});
  EXPECT_NEAR(*subset.index, exact, 0.03);
  EXPECT_GT(*subset.variation, 0.);
  EXPECT_NEAR(*by_plain(margin, 3, {1, 1000, 1000000, 0.01}).index, exact, 0.03);
  const DesignPointSearch found = find_design_point([=](const Values& u) { return margin(u) + u[0]; }, 3);
  ASSERT_TRUE(found.point);
  EXPECT_GT(*by_form(found).index - exact, 0.3);
}

TEST(Importance, KnowsASmallProbabilityToAThousandthOfTheIndex) {
  const Margin margin = in_physical(resistance_and_load(), [](const Values& x) { return x[0] - x[1] + 4.; });
  const DesignPointSearch found = find_design_point(margin, 2);
  const MethodAnswer answer = by_importance(margin, {*found.point}, {1, 1000000, 1000, 0.003});
  EXPECT_NEAR(*answer.index, 4., 1e-3 * 4.);
  EXPECT_LE(*answer.variation, 0.003);
  EXPECT_LT(answer.evaluations, 1e6);  // it ends once its probability is known that well
}

TEST(Sampling, OfOneSeedGivesTheSameNumbers) {
  const Margin margin = in_physical(resistance_and_load(), difference);
  const std::vector<DesignPoint> points{*find_design_point(margin, 2).point};
  for (int i = 0; i < 2; ++i) {
    const Sampling one{7, 5000, 5000, 0.001}, other{8, 5000, 5000, 0.001};
    EXPECT_EQ(*by_importance(margin, points, one).probability, *by_importance(margin, points, one).probability);
    EXPECT_NE(*by_importance(margin, points, one).probability, *by_importance(margin, points, other).probability);
    EXPECT_EQ(*by_subset(margin, 2, one).probability, *by_subset(margin, 2, one).probability);
    EXPECT_EQ(*by_plain(margin, 2, one).probability, *by_plain(margin, 2, one).probability);
  }
}

TEST(Plain, WithoutAFailureHasFoundNothing) {
  const MethodAnswer answer = by_plain([](const Values& u) { return 30. - u[0]; }, 1, {1, 1000, 1000, 0.01});
  EXPECT_FALSE(answer.probability);
  EXPECT_THAT(answer.why_not, testing::HasSubstr("no sample of 1000 failed"));
}

TEST(Subset, EndsWithAReasonWhereNothingFails) {
  const MethodAnswer answer = by_subset([](const Values& u) { return 30. - u[0]; }, 1, {1, 1000, 1000, 0.01});
  EXPECT_FALSE(answer.probability);
  EXPECT_EQ(answer.why_not, "its probability is below 1e-12");
}

TEST(Variables, ThatReachZeroAreWarnedOf) {
  RandomVariables variables = resistance_and_load();  // 10 - 4.8 and 6 - 6.4
  variables.list[0].acts_on = variables.list[1].acts_on = "force";
  const NumberedWarnings found = not_positive(variables);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].value, -0.4, 1e-9);
  EXPECT_THAT(found[0].what, testing::HasSubstr("the variable S falls to -0.4"));
  variables.list[1].kind = RandomKind::lognormal;
  EXPECT_TRUE(not_positive(variables).empty());
  variables.list[1].kind = RandomKind::normal;
  variables.list[1].acts_on = "water_level";
  EXPECT_TRUE(not_positive(variables).empty());
}

TEST(Chance, OfManyOccasionsKeepsTheDigitsOfASmallOne) {
  EXPECT_NEAR(of_occasions(1e-12, 50.), 5e-11, 1e-20);
  EXPECT_NEAR(of_occasions(0.1, 2.), 0.19, 1e-15);
  EXPECT_FALSE(index_of(0.));
  EXPECT_NEAR(*index_of(1e-15), 7.941345326170998, 1e-9);
}

}  // namespace methods_test
}  // namespace upbead
