// Claims: a column turned by 30 degrees settles along its axis like an upright one (rollers on inclined sides); peaks
// are found inside steps; both schemes agree after a jump. Sources: the equations. Tolerances are stated with their
// reason beside each.

#include <deal.II/grid/grid_tools.h>
#include <gtest/gtest.h>

#include <cmath>

#include "scenes.h"

namespace upbead::test {
namespace agreement_test {

double largest_difference(const Eigen::RowVectorXd& a, const Eigen::RowVectorXd& b) {
  return (a - b).cwiseAbs().maxCoeff() / a.cwiseAbs().maxCoeff();
}

TEST(Agreement, TurnedColumnIsTheSameColumn) {
  const double angle = std::acos(-1.) / 6.;
  Scene scene = column(sand(), triangle(1e5, 0.1));
  scene.probes["top"].at = {0.5, 10.};
  const auto upright_mesh = column_mesh(10., 16);
  const Compiled upright(scene, *upright_mesh);
  const auto turned_mesh = column_mesh(10., 16);
  dealii::GridTools::rotate(angle, turned_mesh->triangulation);
  const auto turn = [&](double x, double y) {
    return std::array<double, 2>{x * std::cos(angle) - y * std::sin(angle), x * std::sin(angle) + y * std::cos(angle)};
  };
  scene.probes["top"].at = turn(0.5, 10.);
  scene.loads["top"].direction = turn(0., -1.);
  const Compiled turned(scene, *turned_mesh);
  const Response a = run(upright, 0.2, 0.005), b = run(turned, 0.2, 0.005);
  const auto settlement = history(upright, a, "probes/top/displacement_y");
  const Eigen::RowVectorXd along = -std::sin(angle) * history(turned, b, "probes/top/displacement_x") +
                                   std::cos(angle) * history(turned, b, "probes/top/displacement_y");
  EXPECT_LE(largest_difference(settlement, along), 1e-10);  // round-off
  EXPECT_LE(largest_difference(history(upright, a, "probes/top/effective_stress_zz"),
                               history(turned, b, "probes/top/effective_stress_zz")),
            1e-9);
}

TEST(Peaks, AreFoundInsideTheSteps) {
  // The peak lies between two ends of coarse steps: measured 6e-6 and 5e-4 of the peak, against 5e-3 at the ends alone.
  const auto mesh = breakwater_mesh(0.5);
  const Compiled compiled(breakwater(triangle(1.6e6, 0.15)), *mesh);
  const auto peak = [&](double step, SchemeKind scheme) {
    return shear_of(compiled, run(compiled, 0.3, step, scheme)).peak_shear;
  };
  const double fine = peak(0.15 / 256, SchemeKind::sdirk4);
  EXPECT_NEAR(peak(0.15 / 8, SchemeKind::sdirk4) / fine, 1., 1e-4);
  EXPECT_NEAR(peak(0.15 / 32, SchemeKind::generalised_alpha) / fine, 1., 2e-3);
}

TEST(JumpingLoad, BothSchemesAgree) {
  const auto mesh = breakwater_mesh(0.5);
  Pulse step;
  step.shape = PulseShape::step;
  step.peak = 1e6;
  Scene scene = breakwater(time_function(step));
  scene.regions["seabed"].flow = Flow::darcy;
  const Compiled compiled(scene, *mesh);
  const Response a = run(compiled, 0.3, 0.002, SchemeKind::sdirk4);
  const Response b = run(compiled, 0.3, 0.0005, SchemeKind::generalised_alpha);
  const auto x = history(compiled, a, "caisson/displacement_x"), y = history(compiled, b, "caisson/displacement_x");
  EXPECT_NEAR(x.tail<1>()[0], y.tail<1>()[0], 1e-3 * x.cwiseAbs().maxCoeff());
}

}  // namespace agreement_test
}  // namespace upbead::test
