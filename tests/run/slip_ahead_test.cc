// Claims: the slip of a caisson is the same to the last bit whether it was prepared on another core or not; it is
// prepared only if the loads exceed friction; a preparation that is not used has no effect; it is the same to the last
// bit with the vectors that another wave on the same scene has left.
#include "run/sliding/slip_ahead.h"

#include <cstdlib>
#include <memory>

#include "base/cores.h"
#include "case/case_run.h"
#include "dynamics/basis.h"
#include "good_case.h"
#include "run/derived.h"
#include "section_case.h"
#include "upbead/algebra/petsc_session.h"
#include "upbead/case/case_run.h"

namespace upbead::test {
namespace slip_ahead_test {

const std::string breakwater_toml =
    section_case({{"cells = 0.5, seabed_front = 60, seabed_back = 60", "cells = 0.35"}}) +
    "[initial]\nwater_level = 15.0\n[sliding]\nsubmerged_weight = 4.296e6\n";

/// While this exists, the process looks as if mpirun had started it, if `is`.
class Launched {
 public:
  explicit Launched(bool is) {
    if (is) setenv(name, "2", 1);
  }
  ~Launched() { unsetenv(name); }

 private:
  static constexpr const char* name = "PMI_SIZE";
};

class SlipAheadRun : public InFolder {
 protected:
  SlipAheadRun() {
    unsetenv("UPBEAD_MESHES");
    write("case.toml", breakwater_toml);
  }
  static upbead::Run solve(const std::vector<std::string>& overrides) {
    static const PetscSession petsc;
    const Case problem = read_case("case.toml", overrides);
    return upbead::solve(problem, simulation_of(problem));
  }
};

TEST_F(SlipAheadRun, IsTheSameAsSlipAfterwards) {
  for (const std::vector<std::string>& overrides :
       {std::vector<std::string>{"loads.impulse.factor=8"},
        std::vector<std::string>{"loads.impulse.factor=8", "output.fields={ every = 0.1 }",
                                 "regions.mound.strength.friction_angle=40"}}) {
    upbead::Run alone;
    {
      const Launched launched(true);
      EXPECT_FALSE(has_spare_core());
      alone = solve(overrides);
    }
    if (!has_spare_core()) GTEST_SKIP() << "one core";
    const upbead::Run beside = solve(overrides);
    const auto &a = alone.summary.sliding->coupled, &b = beside.summary.sliding->coupled;
    ASSERT_TRUE(a && b && a->history && b->history);
    EXPECT_GT(a->slip.residual, 0.01);
    EXPECT_EQ(a->vectors, b->vectors);
    EXPECT_EQ(a->history->slip, b->history->slip);
    EXPECT_EQ(a->history->normal_force, b->history->normal_force);
    EXPECT_EQ(alone.response.ends.reading, beside.response.ends.reading);
  }
}

TEST_F(SlipAheadRun, IsTheSameBesideTheBasisOfAnotherWave) {
  static const PetscSession petsc;
  const Case other = read_case("case.toml", {"loads.impulse.factor=10", "time.scheme='reduced'"});
  const Case problem = read_case("case.toml", {"loads.impulse.factor=8", "time.scheme='reduced'"});
  const Simulation before = with_room(simulation_of(other));
  ASSERT_TRUE(upbead::solve(other, before).summary.sliding->coupled);
  ASSERT_TRUE(before.room()->slip());
  const Simulation after = simulation_after(&before, problem, before.mesh());
  ASSERT_EQ(after.room(), before.room());
  EXPECT_FALSE(slip_ahead(after)) << "nothing is left to do";
  const upbead::Run shared = upbead::solve(problem, after), alone = upbead::solve(problem, simulation_of(problem));
  const auto &a = alone.summary.sliding->coupled, &b = shared.summary.sliding->coupled;
  ASSERT_TRUE(a && b && a->history && b->history);
  EXPECT_EQ(a->vectors, b->vectors);
  EXPECT_EQ(a->history->slip, b->history->slip);
  EXPECT_EQ(a->history->normal_force, b->history->normal_force);
}

TEST_F(SlipAheadRun, WhatNobodyAsksForIsLeft) {
  if (!has_spare_core()) GTEST_SKIP() << "one core";
  const Case problem = read_case("case.toml", {"loads.impulse.factor=8"});
  static const PetscSession petsc;
  const auto unused = slip_ahead(with_room(simulation_of(problem)));
  ASSERT_TRUE(unused);
  unused->leave_mesh();
  EXPECT_FALSE(slip_ahead(simulation_of(problem))) << "no room for the basis that both are made in";
  const Case weak = read_case("case.toml", {"loads.impulse.factor=0.01"});
  EXPECT_FALSE(slip_ahead(with_room(simulation_of(weak))));
}

}  // namespace slip_ahead_test
}  // namespace upbead::test
