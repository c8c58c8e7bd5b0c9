// Claims: if no node slips or is in tension the run is the bonded one, whether contact is skipped or marched;
// otherwise the contact is solved, S is given beside the other measures, and the balance of energy closes; regions
// that cannot slip are reported. Tolerances: round-off.

#include <algorithm>
#include <cmath>
#include <map>

#include "case/case_run.h"
#include "good_case.h"
#include "run/contact/contact_room.h"
#include "run/derived.h"
#include "run/monitors.h"
#include "section_case.h"
#include "upbead/algebra/petsc_session.h"
#include "upbead/base/error.h"
#include "upbead/case/case_run.h"

namespace upbead::test {
namespace contact_run_test {

const std::string breakwater_toml = section_case({{"cells = 0.5, seabed_front = 60, seabed_back = 60", "cells = 0.35"},
                                                  {"damping = { ratio = 0.05, frequencies = [1, 10] }\n", ""}}) +
                                    "[initial]\nwater_level = 15.0\n[sliding]\nsubmerged_weight = 4.296e6\n";

const std::string friction = "regions.caisson.interface.kind=\"friction\"";

class ContactRun : public InFolder {
 protected:
  ContactRun() {
    unsetenv("UPBEAD_MESHES");
    write("case.toml", breakwater_toml);
  }
  struct Solved {
    upbead::Run run;
    double last(const std::string& reading) const {
      return run.response.ends.reading(run.simulation->system().reading(reading), run.response.ends.reading.cols() - 1);
    }
  };
  static Solved solve(const std::vector<std::string>& overrides) {
    static const PetscSession petsc;
    const Case problem = read_case("case.toml", overrides);
    return {upbead::solve(problem, simulation_of(problem))};
  }
  static std::string refusal(const std::vector<std::string>& overrides) {
    try {
      solve(overrides);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
};

TEST_F(ContactRun, IsTheTiedRunWhereNothingMoves) {
  const std::vector<std::string> steps{"time.scheme=\"sdirk4\"", "time.step=0.005", "loads.impulse.factor=0.5"};
  std::vector<std::string> with = steps, in_full = steps;
  with.push_back(friction);
  in_full.insert(in_full.end(), {friction, "output.fields={ every = 0.1 }"});  // fields require a march with contact
  const Solved tied = solve(steps), shortly = solve(with), fully = solve(in_full);
  EXPECT_FALSE(tied.run.summary.contact);
  ASSERT_TRUE(shortly.run.summary.contact && fully.run.summary.contact);
  EXPECT_FALSE(shortly.run.summary.contact->solved);
  EXPECT_LT(shortly.run.summary.contact->demand.slip, 1.);
  EXPECT_GT(shortly.run.summary.contact->demand.least_normal, 0.);
  const std::vector<Skipped>& skipped = shortly.run.summary.skipped;
  EXPECT_TRUE(
      std::any_of(skipped.begin(), skipped.end(), [](const Skipped& s) { return s.what == "contact node by node"; }));
  ASSERT_TRUE(fully.run.summary.contact->solved);
  EXPECT_EQ(fully.run.summary.discretisation.scheme, "contact");
  EXPECT_EQ(fully.run.summary.contact->solved->slip, 0.);
  const auto& peak = tied.run.summary.response;
  for (const Solved* other : {&shortly, &fully}) {
    const auto& response = other->run.summary.response;
    EXPECT_NEAR(response->peak_displacement, peak->peak_displacement, 1e-11 * peak->peak_displacement);
    EXPECT_NEAR(other->last("shear_force"), tied.last("shear_force"), 1e-9 * peak->peak_shear);
    EXPECT_EQ(other->run.simulation->system().readings.size(),
              static_cast<std::size_t>(other->run.response.ends.reading.rows()));
  }
  EXPECT_NEAR(shortly.run.summary.response->peak_shear, peak->peak_shear, 1e-11 * peak->peak_shear);
}

TEST_F(ContactRun, IsTheReducedTiedRunToo) {
  const Solved tied = solve({"loads.impulse.factor=0.5"}), free = solve({"loads.impulse.factor=0.5", friction});
  EXPECT_FALSE(free.run.summary.contact->solved);
  EXPECT_NEAR(free.run.summary.response->peak_shear / tied.run.summary.response->peak_shear, 1., 2e-3);
}

TEST_F(ContactRun, SlidesByEveryMeasure) {
  const Solved slid = solve({"loads.impulse.factor=8", friction});
  const Summary& summary = slid.run.summary;
  ASSERT_TRUE(summary.contact && summary.contact->solved && summary.sliding && summary.sliding->coupled);
  const NodeContact& contact = *summary.contact->solved;
  EXPECT_NEAR(summary.contact->weight, 4.296e6, 1.);
  EXPECT_GT(contact.slip, 0.01);
  // the same terms summed with weights that are rounded differently: equal to round-off, which depends on the machine
  EXPECT_NEAR(contact.slip, slid.last("interface/slip"), 1e-14 * contact.slip);
  EXPECT_GE(contact.largest_slip, contact.slip);
  EXPECT_LE(std::abs(contact.least_slip), contact.slip);
  EXPECT_GT(contact.opening_seaward, 0.);
  EXPECT_LT(contact.least_contact, 1.);
  EXPECT_GT(contact.dissipated, 0.);
  EXPECT_LT(summary.energy->mismatch(), 1e-9);
  EXPECT_NEAR(contact.dissipated, summary.energy->friction, 1e-9 * contact.dissipated);
  // slip of the whole bottom by the reduced model, and by eq. (4) on the bonded history: of the same order, not equal
  EXPECT_GT(summary.sliding->coupled->slip.residual, 0.01);
  EXPECT_GT(summary.sliding->history.by_history.residual, 0.01);
  EXPECT_LT(summary.sliding->coupled->glued_error, 5e-3);
  ASSERT_TRUE(summary.sliding->coupled->history && slid.run.contact && slid.run.contact->history);
  EXPECT_EQ(summary.sliding->coupled->history->slip.back(), summary.sliding->coupled->slip.residual);
  const std::size_t n = static_cast<std::size_t>(summary.contact->nodes);
  EXPECT_EQ(slid.run.contact->history->slip.size(), n * slid.run.contact->history->time.size());
}

/// The peak of every reading is that of the march within the tolerance, or the ground names the reading.
void expect_told(const upbead::Run& march, const upbead::Run& reduced, const ContactGround& ground) {
  const std::vector<Reading>& readings = march.simulation->system().readings;
  std::map<std::string, double> largest;
  const auto peak = [](const upbead::Run& run, std::size_t i) {
    return run.response.ends.reading.row(static_cast<Eigen::Index>(i)).cwiseAbs().maxCoeff();
  };
  for (std::size_t i = 0; i < readings.size(); ++i)
    largest[readings[i].unit] = std::max(largest[readings[i].unit], peak(march, i));
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const std::string name = readings[i].name.text();
    const bool named = std::any_of(ground.inexact.begin(), ground.inexact.end(),
                                   [&](const InexactReading& reading) { return reading.name == name; });
    if (named || peak(march, i) < 1e-6 * largest[readings[i].unit]) continue;
    EXPECT_NEAR(peak(reduced, i), peak(march, i), ground.tolerance_of_others * peak(march, i)) << name;
  }
}

TEST_F(ContactRun, OnAReducedGroundIsThatOfTheWholeOne) {
  const Solved whole = solve({"loads.impulse.factor=4", friction}),
               reduced = solve({"loads.impulse.factor=4", friction, "time.scheme=\"reduced\""});
  const NodeContact &a = *whole.run.summary.contact->solved, &b = *reduced.run.summary.contact->solved;
  ASSERT_FALSE(a.ground);
  ASSERT_TRUE(b.ground);
  EXPECT_LT(b.ground->coordinates, whole.run.summary.discretisation.unknowns / 4);
  EXPECT_EQ(reduced.run.ladder.back().way, "contact on a reduced ground");
  const double tolerance = 0.005, F_T = whole.run.summary.response->peak_shear;
  EXPECT_LE(b.ground->peak_shear, tolerance);
  EXPECT_LE(b.ground->slip, tolerance * b.largest_slip);
  EXPECT_NE(a.slip, b.slip);  // else it would be the same march
  EXPECT_NEAR(a.slip, b.slip, tolerance * a.slip);
  EXPECT_NEAR(reduced.run.summary.response->peak_shear, F_T, tolerance * F_T);
  EXPECT_NEAR(b.opening_seaward, a.opening_seaward, 0.01 * a.opening_seaward);
  EXPECT_NEAR(b.least_normal_force, a.least_normal_force, 0.01 * a.least_normal_force);
  EXPECT_NEAR(b.dissipated, a.dissipated, 0.01 * a.dissipated);
  EXPECT_FALSE(reduced.run.summary.energy);
  const LeastPressure &p = *whole.run.monitors->pressure, &q = *reduced.run.monitors->pressure;
  const bool named = std::any_of(b.ground->inexact.begin(), b.ground->inexact.end(), [](const InexactReading& reading) {
    return reading.name == "the least pressure of the water";
  });
  EXPECT_NEAR(q.excess(), p.excess(), (named ? b.ground->others : b.ground->tolerance_of_others) * -p.excess());
  expect_told(whole.run, reduced.run, *b.ground);
}

TEST_F(ContactRun, WavesOfOtherPeaksDurationsAndFrictionShareOneReducedGround) {
  const auto wave = [](const std::vector<std::string>& keys) {
    std::vector<std::string> all{friction, "time.scheme=\"reduced\""};
    all.insert(all.end(), keys.begin(), keys.end());
    return read_case("case.toml", all);
  };
  solve({"time.end=0.01"});  // begins PETSc's session
  const Case first = wave({"loads.impulse.factor=4"}),
             second = wave({"loads.impulse.factor=3.5", "loads.impulse.pulse.duration=0.16", "sliding.friction=0.55"});
  const Simulation before = with_room(simulation_of(first)), after = simulation_after(&before, second, before.mesh());
  ASSERT_EQ(after.room(), before.room());
  upbead::solve(first, before);
  const ReducedGround* ground = before.room()->contact()->ground.get();
  const BasisRoom* bonded = before.room()->contact()->bonded.get();
  ASSERT_NE(ground, nullptr);
  const upbead::Run shared = upbead::solve(second, after), alone = upbead::solve(second, simulation_of(second));
  EXPECT_EQ(after.room()->contact()->ground.get(), ground);
  EXPECT_EQ(after.room()->contact()->bonded.get(), bonded);
  const NodeContact &a = *shared.summary.contact->solved, &b = *alone.summary.contact->solved;
  ASSERT_TRUE(a.ground && b.ground);
  EXPECT_EQ(a.slip, b.slip);
  EXPECT_EQ(a.ground->slip, b.ground->slip);
  EXPECT_EQ(shared.summary.response->peak_shear, alone.summary.response->peak_shear);
}

TEST_F(ContactRun, MarchesTheWholeGroundWhereAllCellsAreAskedFor) {
  const std::vector<std::string> with_fields{"loads.impulse.factor=6", friction, "output.fields={ every = 0.5 }"};
  std::vector<std::string> by_name = with_fields;
  by_name.emplace_back("time.scheme=\"reduced\"");
  const Solved whole = solve(with_fields), asked = solve(by_name);
  EXPECT_FALSE(asked.run.summary.contact->solved->ground);
  EXPECT_EQ(asked.run.summary.contact->solved->slip, whole.run.summary.contact->solved->slip);
}

TEST_F(ContactRun, MarchesTheWholeGroundWhereTheSeaEntersGaps) {
  const std::string sea = "regions.caisson.interface={ kind = \"friction\", gap = \"sea\" }";
  const Solved marched = solve({"loads.impulse.factor=6", sea}),
               asked = solve({"loads.impulse.factor=6", sea, "time.scheme=\"reduced\""});
  EXPECT_FALSE(asked.run.summary.contact->solved->ground);
  EXPECT_EQ(asked.run.summary.contact->solved->slip, marched.run.summary.contact->solved->slip);
  EXPECT_TRUE(asked.run.summary.contact->solved->gap_force);
}

TEST_F(ContactRun, CoupledSlipIsSkippedWhereTheCaissonSticks) {
  const Solved stuck = solve({});
  ASSERT_TRUE(stuck.run.summary.sliding->coupled);
  EXPECT_EQ(stuck.run.summary.sliding->coupled->slip.residual, 0.);
  EXPECT_EQ(stuck.run.summary.sliding->coupled->vectors, 0);
  EXPECT_EQ(stuck.run.summary.skipped.back().what, "slip of the caisson with its ground");
}

TEST_F(ContactRun, RefusesWhatCannotSlip) {
  write("case.toml", breakwater_toml + "[regions.seabed.interface]\nkind = \"tied\"\n");
  EXPECT_NE(refusal({}).find("'interface' does not belong in [regions.seabed]"), std::string::npos);
}

}  // namespace contact_run_test
}  // namespace upbead::test
