// Claims: from the poles of known oscillators follow their periods and damping ratios, with shares by the part of
// each in the reading under the load; a mode that does not oscillate has no period. Exact: closed forms of the
// oscillator.
#include "response/natural_periods.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/numbers.h"

namespace upbead::test {
namespace natural_periods_test {

/// x'' + 2 zeta w x' + w^2 x = f as one mode: its pole, and the rows by which y = factor w^2 x.
void add_oscillator(ModalModel& model, double omega, double zeta, double factor) {
  const std::complex<double> pole(-zeta * omega, omega * std::sqrt(1. - zeta * zeta));
  const Eigen::Index m = model.pole.size();
  model.pole.conservativeResize(m + 1);
  model.load.conservativeResize(m + 1, 1);
  model.reading.conservativeResize(1, m + 1);
  model.pole[m] = pole;
  model.load(m, 0) = 1.;
  model.reading(0, m) = factor * omega * omega / std::complex<double>(0., pole.imag());  // 2 Re(z/(2 i w_d))
}

ModalModel empty() {
  ModalModel model;
  model.feedthrough = model.impulse = Eigen::MatrixXd::Zero(1, 1);
  model.load_name = {"wave"};
  model.reading_label = {{"shear_force", "N/m", ""}};
  return model;
}

/// A step of 1 N/m, 20 s long.
SampledLoads step() {
  std::vector<double> time;
  for (int i = 0; i <= 4000; ++i) time.push_back(0.005 * i);
  return sample({TimeFunction({0.}, {[](double) { return 0.; }, [](double) { return 1.; }})}, time);
}

TEST(NaturalPeriods, AreThoseOfKnownOscillators) {
  ModalModel model = empty();
  add_oscillator(model, two_pi / 0.8, 0.03, 1.);
  add_oscillator(model, two_pi / 0.1, 0.2, 3.);
  const auto found = natural_periods(model, "shear_force", step());
  ASSERT_EQ(found.size(), 2U);
  EXPECT_NEAR(found[0].period, 0.1 / std::sqrt(1. - 0.2 * 0.2), 1e-14);
  EXPECT_NEAR(found[0].damping_ratio, 0.2, 1e-14);
  EXPECT_NEAR(found[1].period, 0.8 / std::sqrt(1. - 0.03 * 0.03), 1e-14);
  EXPECT_NEAR(found[1].damping_ratio, 0.03, 1e-14);
  // the peak under a step is 1 + exp(-pi zeta/sqrt(1 - zeta^2)) times the static value
  const auto peak = [](double zeta) { return 1. + std::exp(-0.5 * two_pi * zeta / std::sqrt(1. - zeta * zeta)); };
  EXPECT_NEAR(found[0].share, 3. * peak(0.2) / (3. * peak(0.2) + peak(0.03)), 1e-3);
  EXPECT_NEAR(found[0].share + found[1].share, 1., 1e-14);
}

TEST(NaturalPeriods, LeaveOutWhatDoesNotSwingOrDoesNotCount) {
  ModalModel model = empty();
  add_oscillator(model, 10., 0.05, 1.);
  add_oscillator(model, 20., 0.75, 5.);    // damping above 1/sqrt(2)
  add_oscillator(model, 30., 0.05, 1e-3);  // a share below a hundredth
  const auto found = natural_periods(model, "shear_force", step());
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].damping_ratio, 0.05, 1e-14);
}

}  // namespace natural_periods_test
}  // namespace upbead::test
