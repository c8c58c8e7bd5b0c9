// Claim: the chain from a wave to its safety factor and tau_0, row by row of a table that was computed once by another
// program; the section is declared, not published. Tolerances are half a unit of the last digit that the table has. The
// sliding distances of these rows are tested with the sliding formulas.

#include <gtest/gtest.h>

#include "sections.h"
#include "upbead/waves/goda.h"

namespace upbead::test {
namespace regression_test {

struct Row {
  double H, alpha_2, alpha_I, alpha_star, tau_0F, k, tau_0;
  double P, P_digits, U, U_digits, safety;  ///< kN/m
};

const Row rows[] = {{8., 0.1304, 0.1438, 0.1438, 5.200, 0.4115, 2.1397, 1170.78, 0.005, 363.22, 0.005, 1.3513},
                    {9., 0.1654, 0.1618, 0.1654, 5.100, 0.3991, 2.0356, 1360.8, 0.05, 408.6, 0.05, 1.1426},
                    {10., 0.2047, 0.1798, 0.2047, 5.000, 0.3804, 1.9021, 1583.8, 0.05, 454.0, 0.05, 0.9646},
                    {11., 0.2482, 0.1978, 0.2482, 4.900, 0.3636, 1.7818, 1826.2, 0.05, 499.4, 0.05, 0.8216},
                    {12., 0.2961, 0.2157, 0.2961, 4.800, 0.3484, 1.6725, 2090.2, 0.05, 544.8, 0.05, 0.7048}};

TEST(Regression, HoldsRowByRow) {
  constexpr double digit_4 = 5.01e-5;
  for (const Row& row : rows) {
    SCOPED_TRACE(row.H);
    const Section s = sliding_section();
    const Goda goda(s, Water(), sliding_wave(row.H));
    EXPECT_NEAR(goda.wavelength(), 135.3522, digit_4);
    const WavePressure p = goda.at(row.H);
    EXPECT_NEAR(p.alpha_1, 0.871899, 5.01e-7);
    EXPECT_NEAR(p.alpha_3, 0.858935, 5.01e-7);
    EXPECT_NEAR(p.alpha_2, row.alpha_2, digit_4);
    EXPECT_NEAR(p.alpha_I, row.alpha_I, digit_4);
    EXPECT_NEAR(p.alpha_star, row.alpha_star, digit_4);
    const double tau_0F = standing_duration(row.H, 15., 12.), k = DurationFactor()(p.alpha_star);
    EXPECT_NEAR(tau_0F, row.tau_0F, 5.01e-4);
    EXPECT_NEAR(k, row.k, digit_4);
    EXPECT_NEAR(k * tau_0F, row.tau_0, digit_4);
    EXPECT_NEAR(p.force / 1e3, row.P, 1.01 * row.P_digits);
    EXPECT_NEAR(p.uplift / 1e3, row.U, 1.01 * row.U_digits);
    EXPECT_NEAR(stability(s, p).safety_sliding, row.safety, digit_4);
  }
}

}  // namespace regression_test
}  // namespace upbead::test
