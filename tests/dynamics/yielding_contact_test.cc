// Claims: soil that yields and friction node by node are solved together: where the soil cannot yield the result is
// that of contact alone, step by step; where friction prevents all slip it is that of the soil alone; a slider in the
// soil and a slider under the block slide equally far; where both act each keeps its own law, and the balance of
// energy has a term for each and closes, also through impacts.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "contact_systems.h"
#include "dynamics/yielding.h"
#include "system/interface.h"

namespace upbead::test {
namespace yielding_contact_test {

/// The horizontal springs under the nodes of a block slide at a strength of their own.
class YieldingGround : public InternalForce {
 public:
  YieldingGround(const BlockOnNodes& block, double strength, bool is_bonded = false)
      : kx_(block.kx), height_(block.height), strength_(strength), n_(block.position.size()), slid_(n_, 0.) {
    rows_ = {0, 2};
    for (std::size_t i = 0; !is_bonded && i < n_; ++i) rows_.push_back(3 + static_cast<int>(i));
    bonded_ = is_bonded;
  }
  const std::vector<int>& rows() const override { return rows_; }
  void evaluate(const Vector& x, Vector& p) override {
    p.setZero(static_cast<Eigen::Index>(rows_.size()));
    for (std::size_t i = 0; i < n_; ++i) {
      const double u = displacement(x, i), c = kx_ * u - force(u, i);
      p[0] += c;
      p[1] += height_ * c;
      if (!bonded_) p[2 + static_cast<Eigen::Index>(i)] -= c;
    }
  }
  double commit(const Vector& x) override {
    double lost = 0.;
    stored_ = 0.;
    largest_ = 0.;
    for (std::size_t i = 0; i < n_; ++i) {
      const double u = displacement(x, i), f = force(u, i), more = u - f / kx_ - slid_[i];
      lost += f * more;
      slid_[i] += more;
      stored_ += 0.5 * kx_ * ((u - slid_[i]) * (u - slid_[i]) - u * u);
      largest_ = std::max(largest_, std::abs(f));
    }
    return lost;
  }
  double stored_beside_elastic() const override { return stored_; }
  const Vector& added_to_readings() const override { return none_; }
  double exerted() const override { return 0.; }
  double largest() const { return largest_; }  ///< |force| of a node at the last commit

 private:
  double displacement(const Vector& x, std::size_t i) const {
    return x[0] + height_ * x[2] - (bonded_ ? 0. : x[3 + static_cast<Eigen::Index>(i)]);
  }
  double force(double u, std::size_t i) const { return std::clamp(kx_ * (u - slid_[i]), -strength_, strength_); }

  double kx_, height_, strength_;
  std::size_t n_;
  bool bonded_ = false;
  std::vector<double> slid_;
  std::vector<int> rows_;
  double stored_ = 0., largest_ = 0.;
  Vector none_;
};

constexpr double never = 1e300, tight = 1e-9;

BlockOnNodes one_node() {
  BlockOnNodes block;
  block.inertia = 1e12;
  return block;
}

struct Marched {
  State state;
  EnergyAccount energy;
  double largest_shear = 0., mismatch = 0., beyond_friction = 0.;
  int impacts = 0;
};

Marched march_both(const System& system, const BlockOnNodes& block, YieldingGround& ground, double end, int n,
                   const State* from = nullptr) {
  const auto scheme = make_yielding_scheme(system, ground, {tight, false});
  Marched found{from ? *from : at_rest(system), {}};
  scheme->start(found.state);
  for (int i = 0; i < n; ++i) {
    scheme->advance(found.state, end / n);
    found.largest_shear = std::max(found.largest_shear, ground.largest());
    found.mismatch = std::max(found.mismatch, scheme->energy().mismatch());
    if (!scheme->contact()) continue;
    const InterfaceForces& forces = scheme->contact()->forces;
    for (Eigen::Index k = 0; k < forces.shear.size(); ++k)
      found.beyond_friction =
          std::max(found.beyond_friction, std::abs(forces.shear[k]) - block.friction * forces.normal[k]);
  }
  found.energy = scheme->energy();
  if (scheme->contact()) found.impacts = scheme->contact()->impacts;
  return found;
}

TEST(YieldingContact, IsContactAloneWhereTheSoilCannotYield) {
  const BlockOnNodes block = one_node();
  const System system = block.system(triangle(1e6, 0.2));
  State start = at_rest(system);
  start.v[0] = start.v[system.first_slip()] = 1.;  // it slips throughout
  const auto alone = make_contact_scheme(system);
  State exact = start;
  alone->start(exact);
  for (int i = 0; i < 40; ++i) alone->advance(exact, 0.0025);
  ASSERT_GT(exact.v[system.first_slip()], 0.);
  YieldingGround ground(block, never);
  const Marched both = march_both(system, block, ground, 0.1, 40, &start);
  EXPECT_LT((both.state.x - exact.x).norm(), 1e-12 * exact.x.norm());
  EXPECT_LT((both.state.v - exact.v).norm(), 1e-12 * exact.v.norm());
  EXPECT_NEAR(both.energy.friction, alone->energy().friction, 1e-12 * both.energy.friction);
  EXPECT_EQ(both.energy.plastic, 0.);
}

TEST(YieldingContact, IsTheSoilAloneWhereFrictionHoldsEverything) {
  BlockOnNodes block = one_node();
  block.friction = 1e6;
  const System system = block.system(triangle(4e6, 0.2)), tied = bonded(system);
  YieldingGround under(block, 1.5e6), soil(block, 1.5e6, true);
  const Marched both = march_both(system, block, under, 0.6, 240), alone = march_both(tied, block, soil, 0.6, 240);
  EXPECT_LT((both.state.x.head(3) - alone.state.x.head(3)).norm(), 1e-8 * alone.state.x.head(3).norm());
  EXPECT_NEAR(both.energy.plastic, alone.energy.plastic, 1e-7 * alone.energy.plastic);
  EXPECT_GT(alone.energy.plastic, 0.1 * alone.energy.largest_work);
  EXPECT_EQ(both.energy.friction, 0.);
}

/// An elastic spring in series with a slider: the motion is the same with the slider in the soil and under the block.
TEST(YieldingContact, ASliderInTheSoilSlidesAsFarAsOneUnderTheBlock) {
  BlockOnNodes block = one_node();
  block.arm = -block.height;
  const double strength = block.friction * block.weight;
  const System slides = block.system(triangle(4e6, 0.2));
  block.friction = 1e6;
  const System holds = block.system(triangle(4e6, 0.2));
  std::vector<double> difference;
  for (const int n : {300, 1200, 4800}) {
    YieldingGround weak(block, strength), strong(block, never);
    const Marched soil = march_both(holds, block, weak, 0.6, n), friction = march_both(slides, block, strong, 0.6, n);
    EXPECT_GT(friction.state.x[slides.first_slip()], 1e-3);
    difference.push_back(std::abs(soil.state.x[0] / friction.state.x[0] - 1.));
    EXPECT_NEAR(soil.energy.plastic, friction.energy.friction, 1e-2 * friction.energy.friction);
  }
  EXPECT_LT(difference.back(), 2e-5);
  EXPECT_LT(difference.back(), 0.1 * difference.front());
}

TEST(YieldingContact, EachKeepsItsLawAndTheEnergyCloses) {
  BlockOnNodes block;
  block.position = {-9., -4.5, 0., 4.5, 9.};
  block.kx = 1.2e8;
  block.ky = 1.2e8;
  block.cx = block.cy = 1e5;
  const System system = block.system(triangle(5e6, 0.25));
  YieldingGround ground(block, 3.2e5);
  const Marched both = march_both(system, block, ground, 1., 800);
  EXPECT_LT(both.beyond_friction, 1e-5 * block.weight);
  EXPECT_LT(both.largest_shear, 3.2e5 * (1. + 1e-9));
  EXPECT_LT(both.mismatch, 1e-6);
  EXPECT_GT(both.impacts, 0);
  EXPECT_GT(both.energy.friction, 1e-3 * both.energy.largest_work);
  EXPECT_GT(both.energy.plastic, 1e-3 * both.energy.largest_work);
  EXPECT_LT(std::abs(both.energy.scheme), 0.05 * both.energy.largest_work);
}

}  // namespace yielding_contact_test
}  // namespace upbead::test
