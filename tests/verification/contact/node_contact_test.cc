// Claims about contact node by node in the finite-element model: on rigid ground it is the exact block of eq. (4);
// the law holds at every node and step to round-off; friction only dissipates; mirrored pulses cause mirrored slips;
// half the step changes S by less than 1 %; larger waves slide farther. Sources: sliding/block.h, the law itself.
#include <gtest/gtest.h>

#include "contact_case.h"

namespace upbead::test {
namespace node_contact_test {

TEST(NodeContact, OnRigidGroundIsTheExactBlockAtLength) {
  Record record("contact_block");
  const double R = friction * submerged_weight(), duration = 3.;
  const auto mesh = breakwater_mesh(0.25);
  for (const double r : {1.1, 1.5, 2.}) {
    Scene scene = drained_section(triangle(r * R, duration), 0.);
    stiffen(scene);
    const ContactMarch run(scene, *mesh, friction, 6., duration / 3000.);
    const Sliding exact = slide(caisson_mass(), {{0., duration / 2., duration}, {0., r * R, 0.}}, R);
    const std::string at = ", r = " + std::to_string(r).substr(0, 3);
    record.at_most("S against that of the block" + at, std::abs(run.S() / exact.residual - 1.), 1e-6);
    record.at_most("largest opening over S" + at, run.opening.maxCoeff() / exact.residual, 1e-5);
  }
}

class Section : public testing::TestWithParam<bool> {
 protected:
  Scene scene(double peak, double arm = 8.) const {
    const TimeFunction force = triangle(peak, 0.15);
    return GetParam() ? wet_section(force, arm) : drained_section(force, arm);
  }
  std::unique_ptr<Mesh> mesh() const { return GetParam() ? breakwater_mesh(0.25, with_sea()) : breakwater_mesh(0.25); }
  std::string name() const { return GetParam() ? "with pore water and sea" : "drained"; }
};

TEST_P(Section, ObeysTheLawAtEveryNode) {
  Record record("contact_law");
  const ContactMarch run(scene(7e6), *mesh(), friction, 0.8, 0.15 / 48.);
  const double W = submerged_weight();
  record.at_most("penetration over S, " + name(), std::max(0., -run.opening.minCoeff()) / run.S(), 0.);
  record.at_most("tension over W', " + name(), -run.normal.minCoeff() / W, 1e-10);
  record.at_most("force at open nodes over W', " + name(),
                 (run.opening.array() > 0.).select(run.normal.array().abs(), 0.).maxCoeff() / W, 1e-10);
  record.at_most("abs(T) beyond mu N over W', " + name(),
                 (run.shear.array().abs() - friction * run.normal.array()).maxCoeff() / W, 1e-10);
  record.at_most("energy that is not accounted for, " + name(), run.energy().mismatch(), 1e-10);
  double last = 0., fall = 0.;
  for (const EnergyAccount& account : run.response.energy) {
    fall = std::max(fall, last - account.friction);
    last = account.friction;
  }
  record.at_most("energy that friction gives back, of what it takes, " + name(), fall / last, 1e-12);
  record.measured("S (m), " + name(), run.S());
  record.measured("largest opening (m), " + name(), run.opening.maxCoeff());
}

TEST_P(Section, StuckNodesDoNotCreep) {
  Record record("contact_law");
  const ContactMarch run(scene(7e6), *mesh(), friction, 16., 0.15 / 16.);
  const Eigen::Index n = run.slip.cols();
  record.at_most("slip after the motion has died away, over S, " + name(),
                 (run.slip.rightCols(n / 8).colwise() - run.slip.rightCols(1).col(0)).cwiseAbs().maxCoeff() / run.S(),
                 0.);
}

TEST_P(Section, MirroredPulsesMakeMirroredSlips) {
  Record record("contact_law");
  const auto section = mesh();
  const ContactMarch there(scene(7e6), *section, friction, 0.6, 0.15 / 32.),
      back(scene(-7e6), *section, friction, 0.6, 0.15 / 32.);
  record.at_most("S of a pulse and of its mirror image, " + name(), std::abs(there.S() + back.S()) / there.S(), 1e-6);
  record.at_most("openings of a pulse and of its mirror image, " + name(),
                 (there.opening - back.opening.colwise().reverse()).cwiseAbs().maxCoeff() / there.opening.maxCoeff(),
                 1e-6);
}

TEST_P(Section, HalfTheStepChangesLittle) {
  Record record("contact_steps");
  const auto section = mesh();
  for (const double peak : {5e6, 7e6, 10e6}) {
    const ContactMarch coarse(scene(peak), *section, friction, 0.8, 0.15 / 32.),
        fine(scene(peak), *section, friction, 0.8, 0.15 / 64.);
    record.at_most("S in steps of 1/32 and 1/64 of the duration, peak " + std::to_string(static_cast<int>(peak / 1e6)) +
                       " MN/m, " + name(),
                   std::abs(coarse.S() / fine.S() - 1.), 0.01);
  }
}

TEST_P(Section, LargerWavesSlideFarther) {
  Record record("contact_law");
  const auto section = mesh();
  double last = 0., fall = 0.;
  for (double peak = 3e6; peak <= 12e6; peak += 0.75e6) {
    const double slip = ContactMarch(scene(peak), *section, friction, 0.6, 0.15 / 32.).largest_slip();
    fall = std::max(fall, last - slip);
    last = std::max(last, slip);
  }
  record.at_most("decrease of the largest slip as the peak grows, over its largest, " + name(), fall / last, 0.);
}

INSTANTIATE_TEST_SUITE_P(Flow, Section, testing::Bool(),
                         [](const auto& flow) { return flow.param ? "Wet" : "Drained"; });

}  // namespace node_contact_test
}  // namespace upbead::test
