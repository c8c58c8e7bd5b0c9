// Claims: of a block that is pulled up and falls back, the recorder tells the energy of the lift, which is its weight
// times the height; the speed at which it lands, which has that energy; when it does, and since when it touches; and of
// a run that ends before, that it is open.
#include "run/contact/contact_recorder.h"

#include <gtest/gtest.h>

#include <cmath>

#include "upbead/dynamics/time_grid.h"

namespace upbead {
namespace contact_recorder_test {

constexpr double mass = 6e5, gravity = 9.81, weight = mass * gravity;

/// A block that only heaves (y), on one node of ground without mass on stiff springs and dashpots: y, slip, opening.
/// The pull is twice its weight for 0.4 s.
System heaving_block(double mass_of_block) {
  constexpr double k = 1e12, c = 2e10;  // it springs up by W/k, 6 um
  System system;
  Eigen::MatrixXd M = Eigen::MatrixXd::Zero(3, 3), heave = M;
  M(0, 0) = mass_of_block;
  heave << 1., 0., -1., 0., 1., 0., -1., 0., 1.;
  system.M = M.sparseView();
  system.C = (c * heave).sparseView();
  system.K = (k * heave).sparseView();
  system.field.assign(3, Field::displacement);
  system.n_prescribed = 2;
  system.interface = Interface{{0.}, {1.}, Vector::Constant(1, weight), 0.6};
  system.loads = {{"pull", Vector::Unit(3, 0), piecewise_linear({0., 0.2, 0.4}, {0., 2. * weight, 0.}), -1}};
  return system;
}

NodeContact marched(double end) {
  const System system = heaving_block(mass);
  const auto scheme = make_contact_scheme(system);
  ContactRecorder recorder(system, *scheme);
  MarchOptions options;
  options.observers = {&recorder};
  march(system, *scheme, make_time_grid(kinks(system), end, 5e-4), options);
  return recorder.summary();
}

TEST(ContactRecorder, TellsHowABlockFallsBack) {
  const NodeContact found = marched(2.);
  const double height = found.opening_seaward;
  // pull less weight, over the weight: 0 at 0.1 s, 1 at 0.2 s, 0 at 0.3 s, -1 from 0.4 s on; integrated twice
  const double speed = 0.05 * gravity, rise = (0.01 + 0.01 - 1e-3 / 0.6 + 0.5 * 0.05 * 0.05) * gravity;
  EXPECT_NEAR(height, rise, 2e-3 * rise);
  EXPECT_NEAR(found.lift_energy, weight * height, 1e-9 * found.lift_energy);
  EXPECT_NEAR(0.5 * mass * found.closing_speed * found.closing_speed, found.lift_energy, 0.01 * found.lift_energy);
  ASSERT_TRUE(found.closing_time && found.last_closing);
  EXPECT_NEAR(*found.closing_time, 0.4 + speed / gravity + std::sqrt(2. * height / gravity), 2e-3);
  EXPECT_GE(*found.last_closing, *found.closing_time);
  EXPECT_LT(*found.last_closing, *found.closing_time + 0.05);
  EXPECT_EQ(found.open_in_end, 0.);
  EXPECT_FALSE(found.gap_force);
}

TEST(ContactRecorder, TellsThatItIsOpenInTheEnd) {
  const NodeContact found = marched(0.5);
  EXPECT_TRUE(found.first_open);
  EXPECT_FALSE(found.last_closing || found.closing_time);
  EXPECT_EQ(found.closing_speed, 0.);
  EXPECT_EQ(found.open_in_end, 1.);
}

}  // namespace contact_recorder_test
}  // namespace upbead
