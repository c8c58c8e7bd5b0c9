// Claim: between the ends of long steps the history of F_T is that of short steps, and at a jump of the force it has
// both values.
#include "response/shear_response.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scenes.h"

namespace upbead::test {
namespace base_history_test {

constexpr double duration = 0.15, end = 0.45;

class BaseHistoryTest : public testing::Test {
 protected:
  static Scene scene_of(const TimeFunction& force) {
    Scene scene = breakwater(force);
    scene.time.end = end;
    return scene;
  }
  const std::unique_ptr<Mesh> mesh_ = breakwater_mesh(0.5);
};

TEST_F(BaseHistoryTest, ResolvesWhatHappensInsideSteps) {
  const Compiled compiled(scene_of(triangle(1.6e6, duration)), *mesh_);
  const Response coarse = run(compiled, end, duration / 8.), fine = run(compiled, end, duration / 128.);
  const BaseHistory dense = read_base_history(compiled.scene, coarse, true);
  const Eigen::RowVectorXd exact = history(compiled, fine, "shear_force");
  const Eigen::RowVectorXd steps = history(compiled, coarse, "shear_force");
  const double peak = exact.maxCoeff();
  double error = 0., error_of_steps = 0.;
  const std::vector<double> step_values(steps.begin(), steps.end());
  for (std::size_t n = 0; n < fine.ends.time.size(); ++n) {
    const double t = fine.ends.time[n], F = exact[static_cast<Eigen::Index>(n)];
    error = std::max(error, std::abs(value_at(dense.shear_force.time, dense.shear_force.value, t) - F));
    error_of_steps = std::max(error_of_steps, std::abs(value_at(coarse.ends.time, step_values, t) - F));
  }
  EXPECT_LT(error, 2e-3 * peak);
  EXPECT_GT(error_of_steps, 5. * error) << "else the history would not need its points inside the steps";
  EXPECT_NEAR(*std::max_element(dense.shear_force.value.begin(), dense.shear_force.value.end()),
              shear_of(compiled, coarse).peak_shear, 1e-3 * peak);
  EXPECT_TRUE(std::is_sorted(dense.shear_force.time.begin(), dense.shear_force.time.end()));
  EXPECT_EQ(dense.normal_force.time.size(), dense.normal_force.value.size());
}

TEST_F(BaseHistoryTest, KeepsBothValuesOfAForceThatJumps) {
  const TimeFunction ramp({duration}, {[](double t) { return 1.6e6 * t / duration; }, [](double) { return 0.; }});
  const Compiled compiled(scene_of(ramp), *mesh_);
  const BaseHistory dense = read_base_history(compiled.scene, run(compiled, end, duration / 8.), true);
  std::vector<double> at_jump;
  for (std::size_t i = 0; i < dense.force.time.size(); ++i)
    if (std::abs(dense.force.time[i] - duration) < 1e-9) at_jump.push_back(dense.force.value[i]);
  ASSERT_EQ(at_jump.size(), 2u);
  EXPECT_NEAR(at_jump[0], 1.6e6, 1.);
  EXPECT_EQ(at_jump[1], 0.);
}

TEST_F(BaseHistoryTest, WithoutInertiaHasTheEndsOfSteps) {
  const Compiled compiled(scene_of(triangle(1.6e6, duration)), *mesh_);
  const Response response = run(compiled, end, duration / 8.);
  EXPECT_EQ(read_base_history(compiled.scene, response, false).shear_force.time, response.ends.time);
}

}  // namespace base_history_test
}  // namespace upbead::test
