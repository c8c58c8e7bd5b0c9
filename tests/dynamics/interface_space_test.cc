// Claims: where the directions of an InterfaceSpace span all motions, contact on it is contact on the system itself, to
// round-off, whether bodies keep their coordinates or not; its readings and loads are those of the system; each level
// contains the one before.
#include "dynamics/interface_space.h"

#include <gtest/gtest.h>

#include "contact_systems.h"
#include "system/interface.h"

namespace interface_space_test {

using namespace upbead;
using namespace upbead::test;

constexpr int nodes = 7;

System block_on_nodes() {
  BlockOnNodes block;
  block.position.clear();
  for (int i = 0; i < nodes; ++i) block.position.push_back(-9. + 3. * i);
  block.kx = 1.2e9 / nodes;
  block.ky = 2.4e9 / nodes;
  block.cx = 1e7 / nodes;
  block.cy = 2e7 / nodes;
  block.node_mass = 2e5 / nodes;
  block.link = 5e7 * nodes / 18.;
  System system = block.system(triangle(4e6, 0.3));
  system.readings = {position_reading("x", "m", "", {{0, 1.}}), velocity_reading("slip rate", "m/s", "", {{4, 1.}}),
                     acceleration_reading("turning", "1/s2", "", {{2, 1.}})};
  system.readings.back().feedthrough = {1e-6, 0.};
  return system;
}

Response contact_response(const System& system) {
  const auto scheme = make_contact_scheme(system);
  return march(system, *scheme, make_time_grid({0.15, 0.3}, 0.6, 0.005), {});
}

/// With all readings of the whole system.
Response contact_response(const InterfaceModel& model) {
  const auto scheme = make_contact_scheme(model.system, model.ground);
  Motions motions;
  MarchOptions options;
  options.observers = {&motions};
  return model.read(march(model.system, *scheme, make_time_grid({0.15, 0.3}, 0.6, 0.005), options), motions);
}

TEST(InterfaceSpace, IsTheSystemWhereItSpansAllMotions) {
  const System system = block_on_nodes();
  const Response whole = contact_response(system);
  ASSERT_GT(std::abs(whole.final_state.x[3]), 1e-3);  // it slips
  for (const std::vector<int>& exact : {std::vector<int>{0, 1, 2}, std::vector<int>{}, std::vector<int>{1}}) {
    const InterfaceSpace space(system, 20., exact, {});
    const InterfaceModel model = space.model();
    EXPECT_EQ(model.system.size(), system.size());
    const Response reduced = contact_response(model);
    ASSERT_EQ(reduced.ends.time, whole.ends.time);
    for (Eigen::Index i = 0; i < 3; ++i) {
      const double largest = whole.ends.reading.row(i).cwiseAbs().maxCoeff();
      EXPECT_LT((reduced.ends.reading.row(i) - whole.ends.reading.row(i)).cwiseAbs().maxCoeff(), 1e-8 * largest) << i;
    }
    const State lifted = model.whole(reduced.final_state);
    EXPECT_LT((lifted.x - whole.final_state.x).norm(), 1e-8 * whole.final_state.x.norm());
    const Eigen::Index n = 2 * nodes;
    EXPECT_LT((reduced.final_state.x.tail(n) - whole.final_state.x.tail(n)).norm(),
              1e-8 * whole.final_state.x.tail(n).norm());
    EXPECT_NEAR(reduced.energy.back().friction, whole.energy.back().friction, 1e-8 * whole.energy.back().friction);
    EXPECT_LT(reduced.energy.back().mismatch(), 1e-9);
  }
}

TEST(InterfaceSpace, LevelsAreNested) {
  const System system = block_on_nodes();
  InterfaceSpace space(system, 20., {0, 1, 2}, {});
  const Eigen::MatrixXd low = space.model().displacements.columns();
  const int solves = space.n_solves();
  space.extend();
  EXPECT_GT(space.n_solves(), solves);
  EXPECT_EQ(space.model().displacements.columns().leftCols(low.cols()), low);
}

}  // namespace interface_space_test
