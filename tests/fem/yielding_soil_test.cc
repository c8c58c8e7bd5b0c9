// Claims: the internal force of yielding soil is, with a law of half the stiffness, half of K x; it is zero below
// yield; a breakwater on soil that yields answers a small force as elastic soil does, and a large one with less F_T, a
// residual displacement and energy lost.

#include "fem/yielding_soil.h"

#include <gtest/gtest.h>

#include "dynamics/yielding.h"
#include "scenes.h"

namespace upbead::test {
namespace {

constexpr double gamma_r = 5e-4;

/// A law for every cell that deforms and is no water, with a share of its stiffness.
CellLaws laws(const Space& space, double share, double strain) {
  CellLaws found;
  for (const Cell& cell : space.dofs().active_cell_iterators()) {
    const ElasticLaw& law = space.material(cell);
    const bool yields = space.has_matrices(cell) && space.kind(cell) != CellKind::water;
    found.push_back(yields ? std::make_shared<HystereticLaw>(
                                 ElasticLaw{share * law.G, share * law.lambda},
                                 backbone(
                                     share * law.G, [=](double gamma) { return 1. / (1. + gamma / strain); },
                                     1e-2 * strain, 30. * strain, 10))
                           : nullptr);
  }
  return found;
}

Vector full(const std::vector<int>& rows, const Vector& p, int n) {
  Vector out = Vector::Zero(n);
  for (std::size_t i = 0; i < rows.size(); ++i) out[rows[i]] = p[static_cast<Eigen::Index>(i)];
  return out;
}

TEST(YieldingSoil, LawOfHalfTheStiffnessTakesHalfOfK) {
  const auto mesh = breakwater_mesh(0.5);
  const Compiled compiled(breakwater(triangle(1., 0.1)), *mesh);
  const System& system = compiled.scene.system;
  const auto soil = yielding_soil(compiled.space, compiled.unknowns, laws(compiled.space, 0.5, 1e6));
  const Vector x = 1e-3 * Vector::Random(system.size());
  Vector p, again;
  soil->evaluate(x, p);
  const Vector Kx = system.K * x;
  EXPECT_LT((full(soil->rows(), p, system.size()) - 0.5 * Kx).norm(), 1e-12 * Kx.norm());
  EXPECT_EQ(soil->commit(x), 0.);
  soil->evaluate(x, again);
  EXPECT_LT((again - p).norm(), 1e-14 * p.norm());
  EXPECT_NEAR(soil->stored_beside_elastic(), -0.25 * x.dot(Kx), 1e-12 * x.dot(Kx));
}

TEST(YieldingSoil, WhatIsNotCommittedIsForgotten) {
  const auto mesh = breakwater_mesh(0.5);
  const Compiled compiled(breakwater(triangle(1., 0.1)), *mesh);
  const auto soil = yielding_soil(compiled.space, compiled.unknowns, laws(compiled.space, 1., gamma_r));
  const Vector x = 1e-3 * Vector::Random(compiled.scene.system.size()), rest = 0. * x;
  Vector first, second, p;
  soil->evaluate(1e-9 * x, p);
  EXPECT_EQ(p.norm(), 0.) << "below yield";
  soil->evaluate(x, first);
  soil->evaluate(3. * x, p);
  soil->evaluate(x, second);
  EXPECT_EQ(first, second);
  soil->evaluate(rest, p);
  EXPECT_EQ(p.norm(), 0.);
  EXPECT_GT(soil->commit(x), 0.);
  soil->evaluate(rest, p);
  EXPECT_GT(p.norm(), 0.) << "what yielded stays";
}

struct Answer {
  double shear, displacement, dissipated;  // largest F_T/P; mean after the pulse (m/N); J/m
  int evaluations, stages;
};

Answer answer(double force, double strain) {
  const auto mesh = breakwater_mesh(0.5);
  const Compiled compiled(breakwater(triangle(force, 0.15)), *mesh);
  const System& system = compiled.scene.system;
  const auto soil = yielding_soil(compiled.space, compiled.unknowns, laws(compiled.space, 1., strain));
  const auto scheme = make_yielding_scheme(system, *soil);
  State state = at_rest(system);
  scheme->start(state);
  const Reading& shear = system.readings[static_cast<std::size_t>(system.reading("shear_force"))];
  const Reading& moved = system.readings[static_cast<std::size_t>(system.reading("caisson/displacement_x"))];
  Answer found{};
  for (int i = 0; i < 200; ++i) {
    scheme->advance(state, 0.0075);
    if (i >= 100) found.displacement += evaluate(moved, state, scheme->end_load()) / (100. * force);
    found.shear = std::max(found.shear, evaluate(shear, state, scheme->end_load()) / force);
  }
  found.dissipated = scheme->yielding()->dissipated;
  found.evaluations = scheme->yielding()->evaluations;
  found.stages = scheme->yielding()->stages;
  return found;
}

TEST(YieldingSoil, BreakwaterIsElasticUnderLittleAndYieldsUnderMuch) {
  const Answer elastic = answer(1e6, 1e6), small = answer(1., gamma_r), large = answer(3e6, gamma_r);
  EXPECT_EQ(small.evaluations, small.stages);
  EXPECT_NEAR(small.shear, elastic.shear, 1e-6 * elastic.shear);
  EXPECT_LT(large.shear, 0.97 * elastic.shear);
  EXPECT_GT(large.displacement, 3. * std::abs(elastic.displacement)) << "residual";
  EXPECT_GT(large.dissipated, 0.);
  EXPECT_LT(large.evaluations, 8 * large.stages);
}

}  // namespace
}  // namespace upbead::test
