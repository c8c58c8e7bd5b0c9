// Claim: ten lines of C++ compute the response of a reduced model to a wave, here the closed form of an oscillator
// under a step.
#include <gtest/gtest.h>

#include <cmath>

#include "sample_model.h"
#include "upbead/dynamics/modal_response.h"

namespace upbead::test {
namespace library_example_test {

TEST(LibraryExample, LoadsAModelAndEvaluatesAWave) {
  ReducedModelFile made = oscillator();
  made.modes.reading(1, 1) = 0.;  // the mode without physical meaning
  const TemporaryFile file(model_file(made));
  const std::string path = file.path();
  const double pi = std::acos(-1.);

  // The ten lines: the share of a sudden force of 1 MN/m that reaches the bottom within two seconds.
  const ModalModel model = read_model_file(path).modes;
  std::vector<double> time;
  for (int n = 0; n <= 2000; ++n) time.push_back(1e-3 * n);
  const TimeFunction step = piecewise_linear({0., 2.}, {1e6, 1e6}), none;
  const Series answer = respond(model, sample({step, none}, time));
  const auto P = answer.reading.row(model.index("force"));
  const auto F_T = answer.reading.row(model.index("shear_force"));
  const double share = F_T.maxCoeff() / P.maxCoeff();

  // k x + c x' = F (1 - exp(-a t) (cos b t - a / b sin b t)), largest where tan b t = 2 a b / (a^2 - b^2).
  const double a = 0.15 * 4. * pi, b = std::sqrt(16. * pi * pi - a * a);
  const double top = (pi + std::atan(2. * a * b / (a * a - b * b))) / b;
  EXPECT_NEAR(share, 1. - std::exp(-a * top) * (std::cos(b * top) - a / b * std::sin(b * top)), 1e-4);
}

}  // namespace library_example_test
}  // namespace upbead::test
