// Systems of independent linear limit states, whose probabilities are products; and the judgement of several methods.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/math/distributions/normal.hpp>
#include <cmath>

#include "reliability/answer.h"
#include "reliability/chance.h"
#include "reliability/system_form.h"

namespace upbead {
namespace system_test {

using Values = std::vector<double>;

const Values betas{2., 2.5, 3.};

double phi(double beta) {
  return boost::math::cdf(boost::math::normal(), -beta);
}

std::vector<DesignPointSearch> independent() {
  std::vector<DesignPointSearch> list;
  for (std::size_t i = 0; i < betas.size(); ++i)
    list.push_back(find_design_point([i](const Values& u) { return betas[i] - u[i]; }, betas.size()));
  return list;
}

double margin_of_series(const Values& u) {
  return std::min({betas[0] - u[0], betas[1] - u[1], betas[2] - u[2]});
}

double margin_of_parallel(const Values& u) {
  return std::max(betas[0] - u[0], betas[1] - u[1]);
}

TEST(System, InSeriesIsThatOfIndependentStates) {
  const double exact = *index_of(1. - (1. - phi(2.)) * (1. - phi(2.5)) * (1. - phi(3.)));
  const std::vector<DesignPointSearch> events = independent();
  const CutSets sets{{0}, {1}, {2}};
  EXPECT_NEAR(*by_system_form(events, sets).index, exact, 1e-3);
  EXPECT_NEAR(*by_importance(margin_of_series, design_points(events, sets), {1, 400000, 1000, 0.003}).index, exact,
              5e-3);
  EXPECT_NEAR(*by_subset(margin_of_series, 3, {1, 50000, 1000, 0.01}).index, exact, 0.03);
}

TEST(System, InParallelIsTheProduct) {
  const double exact = *index_of(phi(2.) * phi(2.5));
  const std::vector<DesignPointSearch> events = independent();
  const CutSets sets{{0, 1}};
  const std::vector<DesignPoint> points = design_points(events, sets);
  EXPECT_NEAR(points.front().index, std::sqrt(2. * 2. + 2.5 * 2.5), 1e-4);  // the corner
  EXPECT_NEAR(*by_system_form(events, sets).index, exact, 1e-3);
  EXPECT_NEAR(*by_importance(margin_of_parallel, points, {1, 400000, 1000, 0.003}).index, exact, 5e-3);
  EXPECT_NEAR(*by_subset(margin_of_parallel, 3, {1, 50000, 1000, 0.01}).index, exact, 0.05);
}

/// Five states of two variables, two of them equal: those that add nothing change nothing.
TEST(System, OfMoreStatesThanVariablesHasAForm) {
  std::vector<DesignPointSearch> events;
  for (const Values& a :
       {Values{1., 0., 2.}, Values{0., 1., 2.5}, Values{1., 0., 2.}, Values{0.6, 0.8, 6.}, Values{-1., 0., 7.}})
    events.push_back(find_design_point([a](const Values& u) { return a[2] - a[0] * u[0] - a[1] * u[1]; }, 2));
  const double exact = *index_of(1. - (1. - phi(2.)) * (1. - phi(2.5)));
  EXPECT_NEAR(*by_system_form(events, {{0}, {1}, {2}, {3}, {4}}).index, exact, 1e-3);
}

TEST(System, ThatFailsForCertainHasAnIndex) {
  std::vector<DesignPointSearch> events = independent();
  events.push_back(find_design_point([](const Values& u) { return -10. - u[0]; }, betas.size()));
  const MethodAnswer answer = by_system_form(events, {{0}, {1, 2}, {3}});
  EXPECT_EQ(*answer.probability, 1.);
  EXPECT_NEAR(*answer.index, -10., 1e-3);
  EXPECT_EQ(*by_system_form(events, {{0}, {3}}).probability, 1.);
}

DesignPointSearch state_at(double angle, double index) {
  DesignPoint point;
  point.alpha = {std::cos(angle), std::sin(angle)};
  point.u = {index * point.alpha[0], index * point.alpha[1]};
  point.index = index;
  return {point, ""};
}

/// Of two variables, by the distance of the nearest plane in every direction: 1 - (1/2 pi) int (1 - exp(-r^2/2)).
double by_directions(const std::vector<DesignPointSearch>& events) {
  double sum = 0.;
  constexpr int n = 200000;
  for (int i = 0; i < n; ++i) {
    const double angle = 2. * std::acos(-1.) * (i + 0.5) / n;
    double r = 1e9;
    for (const DesignPointSearch& event : events) {
      const double along = std::cos(angle) * event.point->alpha[0] + std::sin(angle) * event.point->alpha[1];
      if (along > 0.) r = std::min(r, event.point->index / along);
    }
    sum += std::exp(-0.5 * r * r) / n;
  }
  return sum;
}

/// Nearly equal states, for which Phi_n of a nearly singular R was off by more than all that they add.
TEST(System, OfNearlyEqualStatesIsThatOfItsPlanes) {
  for (const double turn : {0., 1e-9, 1e-4, 0.01, 0.3, 2.})
    for (const double index : {0.1, 0.86, 2., 4.}) {
      std::vector<DesignPointSearch> events;
      CutSets sets;
      for (std::size_t i = 0; i < 6; ++i) {
        events.push_back(state_at(turn * static_cast<double>(i), index + 0.01 * static_cast<double>(i % 3)));
        sets.push_back({i});
      }
      const double exact = by_directions(events), p = *by_system_form(events, sets).probability;
      EXPECT_NEAR(p / exact, 1., 1e-3) << turn << " " << index;
      EXPECT_GE(p, phi(index)) << "no less than one of its parts";
    }
}

/// Independent states of up to seven variables, where one may have failed already at the origin.
TEST(System, InSeriesOfManyVariablesIsTheProduct) {
  for (const std::size_t size : {3U, 7U})
    for (const double least : {-0.5, 1., 3.}) {
      std::vector<DesignPointSearch> events;
      CutSets sets;
      double holds = 1.;
      for (std::size_t i = 0; i < size; ++i) {
        DesignPoint point;
        point.alpha.assign(size, 0.);
        point.alpha[i] = 1.;
        point.index = least + 0.1 * static_cast<double>(i);
        point.u = point.alpha;
        for (double& x : point.u) x *= point.index;
        holds *= 1. - phi(point.index);
        events.push_back({point, ""});
        sets.push_back({i});
      }
      EXPECT_NEAR(*by_system_form(events, sets).probability / (1. - holds), 1., 1e-3) << size << " " << least;
    }
}

/// A union of sets: between the most probable one and the sum, whatever Phi_n says of nearly equal states.
TEST(System, OfSetsOfNearlyEqualStatesIsWithinItsBounds) {
  for (const double turn : {0., 1e-6, 1e-3, 0.1}) {
    std::vector<DesignPointSearch> events;
    for (std::size_t i = 0; i < 5; ++i) events.push_back(state_at(turn * static_cast<double>(i), 0.86));
    const MethodAnswer found = by_system_form(events, {{0}, {1, 2}, {2, 3}, {3, 4}});
    ASSERT_TRUE(found.probability);
    EXPECT_GE(*found.probability, phi(0.86)) << turn;
    EXPECT_LE(*found.probability, 4. * phi(0.86)) << turn;
    if (turn <= 1e-3) {
      EXPECT_NEAR(*found.probability / phi(0.86), 1., 5e-3) << turn;
    }
  }
}

TEST(System, WithoutADesignPointOfOneStateHasNoForm) {
  std::vector<DesignPointSearch> events = independent();
  events[1] = {{}, "none"};
  EXPECT_FALSE(by_system_form(events, {{0}, {1}}).index);
  EXPECT_EQ(design_points(events, {{0}, {1}}).size(), 1U);
}

MethodAnswer found(const std::string& method, double index) {
  return {method, phi(index), index, {}, 1., ""};
}

TEST(Judgement, TakesTheWorseWhereMethodsDisagree) {
  ModeAnswer mode;
  mode.methods = {found("form", 3.), found("subset", 2.8)};
  const ModeAnswer out = judged(mode, 2., 50.);
  EXPECT_EQ(out.governing, "subset");
  EXPECT_EQ(*out.occasion.index, 2.8);
  EXPECT_NEAR(*out.year.probability, 1. - std::pow(1. - phi(2.8), 2), 1e-12);
  EXPECT_NEAR(*out.life.probability, 1. - std::pow(1. - phi(2.8), 100), 1e-12);
  EXPECT_THAT(out.disagreement, testing::HasSubstr("both stand"));
}

TEST(Judgement, SaysNothingWhereMethodsAgreeWithinATenth) {
  ModeAnswer mode;
  mode.methods = {found("form", 3.), found("subset", 2.95)};
  EXPECT_EQ(judged(mode, 1., 50.).disagreement, "");
}

TEST(Judgement, HasNoProbabilityWhereNoMethodHas) {
  ModeAnswer mode;
  mode.methods = {{"form", {}, {}, {}, 1., "no design point"}};
  const ModeAnswer out = judged(mode, 1., 50.);
  EXPECT_FALSE(out.life.probability);
  EXPECT_EQ(out.why_not, "no method found a probability");
}

}  // namespace system_test
}  // namespace upbead
