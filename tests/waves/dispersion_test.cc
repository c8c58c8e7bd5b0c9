// Claim: kh solves omega^2 h/g = kh tanh(kh) to round-off from a millimetre of water to the deepest sea.

#include "upbead/waves/wave_heights.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace upbead {
namespace dispersion_test {

constexpr double pi = 3.14159265358979323846;

TEST(Dispersion, SolvesItsEquation) {
  for (const double T : {0.5, 3.04, 12., 1e3})
    for (const double h : {1e-3, 0.1, 1., 15., 100., 1e4, 1e7}) {
      const double kh = relative_wave_number(T, h, 9.81), y = 4. * pi * pi * h / (9.81 * T * T);
      EXPECT_NEAR(kh * std::tanh(kh) / y, 1., 1e-14) << "T " << T << ", h " << h;
    }
}

TEST(Dispersion, HasBothLimits) {
  EXPECT_NEAR(wavelength(10., 1e5, 9.81) / deep_water_wavelength(10., 9.81), 1., 1e-14);
  EXPECT_NEAR(wavelength(1e4, 1., 9.81) / (std::sqrt(9.81) * 1e4), 1., 1e-7);
}

TEST(Dispersion, GivesTheLengthOfGodasExample) {
  EXPECT_NEAR(wavelength(11.4, 10.1, 9.81), 107.5376, 5e-5);
  EXPECT_NEAR(relative_wave_number(11.4, 10.1, 9.81), 0.59012, 5e-6);
}

TEST(Dispersion, RefusesWhatIsNotPositive) {
  for (const double bad : {0., -1., std::nan(""), HUGE_VAL}) {
    EXPECT_THROW(wavelength(bad, 1., 9.81), std::invalid_argument);
    EXPECT_THROW(wavelength(1., bad, 9.81), std::invalid_argument);
    EXPECT_THROW(wavelength(1., 1., bad), std::invalid_argument);
    EXPECT_THROW(deep_water_wavelength(bad, 9.81), std::invalid_argument);
  }
}

}  // namespace dispersion_test
}  // namespace upbead
