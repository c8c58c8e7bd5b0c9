// Claims: where no node opens, the caisson that slips as a whole and contact node by node agree on S within 2 %; on
// rigid ground the former is the exact block, too. Where nodes open they differ, by how much is written down.
#include <gtest/gtest.h>

#include "contact_case.h"
#include "upbead/response/slip_reduction.h"
#include "upbead/sliding/coupled_slip.h"

namespace upbead::test {
namespace {

constexpr double duration = 0.15;

std::string two_digits(double value) {
  return std::to_string(value).substr(0, 4);
}

/// S of a scene whose caisson slips as a whole.
double coupled_slip(const Scene& input, const Mesh& mesh, double end) {
  Scene scene = input;
  scene.time.end = end;
  const Compiled loose(scene, mesh, true), tied(scene, mesh);
  const double step = scene.loads["impulse"].history.kinks().back() / 128.;
  const Response glued = run(tied, end, 4. * step);
  const SlipReduction reduction = reduce_slip(loose.resolved, loose.scene, SlipUplift::computed, glued.ends);
  const int n = static_cast<int>(end / step) + 1;
  WaveSamples loads(2, n);
  for (int i = 0; i < n; ++i) loads.col(i) << scene.loads["impulse"].history(i * step), buoyant_weight();
  const SlipLaw law = slip_law(reduction.system, friction, SlipUplift::computed);
  return CoupledSlip(slip_model(reduction.system, law), step).slide(loads).slip.residual;
}

TEST(Levels, RigidSlipOnRigidGroundIsTheExactBlock) {
  Record record("contact_block");
  const double R = friction * buoyant_weight();
  const auto mesh = breakwater_mesh(0.25);
  for (const double r : {1.1, 1.5, 2.}) {
    Scene scene = drained_section(triangle(r * R, 3.), 0.);
    stiffen(scene);
    const Sliding exact = slide(caisson_mass(), {{0., 1.5, 3.}, {0., r * R, 0.}}, R);
    record.at_most("S of the caisson that slips as a whole, r = " + two_digits(r),
                   std::abs(coupled_slip(scene, *mesh, 6.) / exact.residual - 1.), 1e-6);
  }
}

class Levels : public testing::TestWithParam<bool> {
 protected:
  Scene scene(double peak, double arm) const {
    return GetParam() ? wet_section(triangle(peak, duration), arm) : drained_section(triangle(peak, duration), arm);
  }
  std::unique_ptr<Mesh> mesh() const { return GetParam() ? breakwater_mesh(0.35, with_sea()) : breakwater_mesh(0.35); }
  std::string name() const { return GetParam() ? "with pore water and sea" : "drained"; }
};

TEST_P(Levels, AgreeWhereNoNodeOpens) {
  Record record("contact_levels");
  const auto section = mesh();
  for (const double peak : {8e6, 12e6, 16e6}) {
    const Scene pushed = scene(peak, 2.);
    const ContactMarch nodes(pushed, *section, friction, 1., duration / 64.);
    const double S = coupled_slip(pushed, *section, 1.);
    const std::string at = ", peak " + std::to_string(static_cast<int>(peak / 1e6)) + " MN/m, arm 2 m, " + name();
    record.at_most("largest opening (m)" + at, nodes.opening.maxCoeff(), 0.);
    record.at_most("S as a whole over S by nodes, less 1" + at, std::abs(S / nodes.S() - 1.), 0.02);
    record.measured("S by nodes (m)" + at, nodes.S());
  }
}

TEST_P(Levels, DifferWhereTheEdgeLifts) {
  Record record("contact_levels");
  const auto section = mesh();
  for (const double arm : {5., 8.}) {
    const Scene pushed = scene(8e6, arm);
    const ContactMarch nodes(pushed, *section, friction, 1., duration / 64.);
    const double S = coupled_slip(pushed, *section, 1.);
    const std::string at = ", peak 8 MN/m, arm " + std::to_string(static_cast<int>(arm)) + " m, " + name();
    EXPECT_GT(nodes.opening.maxCoeff(), 0.) << at;
    record.measured("S as a whole over S by nodes, less 1" + at, S / nodes.S() - 1.);
    record.measured("largest opening (m)" + at, nodes.opening.maxCoeff());
  }
}

INSTANTIATE_TEST_SUITE_P(Flow, Levels, testing::Bool(),
                         [](const auto& flow) { return flow.param ? "Wet" : "Drained"; });

}  // namespace
}  // namespace upbead::test
