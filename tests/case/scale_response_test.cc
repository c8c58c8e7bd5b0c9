// Claim: the scaled case with Froude-similar soil has the same dimensionless F_T, marched and reduced.
#include "case/scale.h"
#include "good_case.h"
#include "section_case.h"
#include "upbead/algebra/petsc_session.h"
#include "upbead/case/case_run.h"

namespace upbead::test {
namespace scale_response_test {

const std::string small_case =
    section_case({{"cells = 0.5, seabed_front = 60, seabed_back = 60", "cells = 0.4, grading = 4"},
                  {", frequencies = [1, 10]", ""},
                  {", frequencies = [1, 10]", ""},
                  {"left = { displacement = \"roller\"", "left = { displacement = \"absorbing\""},
                  {"kind = \"force\"", "shape = [[6.0, 0.4], [22.0, 1.0]]"},
                  {"peak = 1e6", "peak = 1.6e6"},
                  {"end = 0.6", "end = 0.5\nstep = 0.005"}});

class ScaledResponse : public InFolder, public testing::WithParamInterface<std::string> {
 protected:
  ScaledResponse() {
    static const PetscSession petsc;  // MPI starts once in a process
    unsetenv("UPBEAD_MESHES");
  }

  /// F_T at the ends of all steps.
  static Eigen::RowVectorXd shear_force(const std::string& path) {
    const Case problem = read_case(path, {"time.scheme=" + GetParam()});
    const Simulation scene = simulation_of(problem);
    return solve(problem, scene).response.ends.reading.row(scene.system().reading("shear_force"));
  }

  /// The case at 1/20 of its size has the same history of F_T / L^2, step by step.
  static void expect_similar(const std::string& text) {
    write("case.toml", text);
    const double factor = 0.05;
    const ScaledCase scaled = scale_case(read_case("case.toml"), {factor, SoilScaling::froude, {}}, "out");
    std::filesystem::create_directories("out");
    write("out/case.toml", scaled.text);
    const Eigen::RowVectorXd before = shear_force("case.toml");
    const Eigen::RowVectorXd after = shear_force("out/case.toml") / (factor * factor);
    ASSERT_EQ(after.size(), before.size());
    const double peak = before.cwiseAbs().maxCoeff();
    EXPECT_GT(peak, 1e5);
    EXPECT_LT((after - before).cwiseAbs().maxCoeff(), 1e-8 * peak);
  }
};

TEST_P(ScaledResponse, IsTheSameInForcesOverTheSquareOfTheLength) {
  expect_similar(small_case);
}

TEST_P(ScaledResponse, IsTheSameWhereStiffnessFollowsStress) {
  std::string text = small_case;
  text.replace(text.find("30e6"), 4, "{ reference = 60e6 }");
  text.replace(text.find("50e6"), 4, "{ reference = 120e6, pressure = 100e3, exponent = 0.4, floor = 2e4 }");
  expect_similar(text + "[initial]\nwater_level = 15\n");
}

TEST_P(ScaledResponse, DiffersWithTheSameSoil) {
  write("case.toml", small_case);
  const double factor = 0.05;
  const ScaledCase scaled = scale_case(read_case("case.toml"), {factor, SoilScaling::same, {}}, "out");
  std::filesystem::create_directories("out");
  write("out/case.toml", scaled.text);
  EXPECT_GT(shear_force("out/case.toml").maxCoeff() / (factor * factor), 1.2 * shear_force("case.toml").maxCoeff());
}

INSTANTIATE_TEST_SUITE_P(, ScaledResponse, testing::Values("generalised_alpha", "sdirk4", "reduced"));

}  // namespace scale_response_test
}  // namespace upbead::test
