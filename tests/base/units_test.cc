// Claim: units have the meaning that laboratories give them. Source of the factors: BIPM, The International System of
// Units (2019), and NIST SP 811 (2008), appendix B.
#include "base/units.h"

#include <gtest/gtest.h>

namespace upbead {
namespace units_test {

TEST(Units, AreReadHoweverTheyAreWritten) {
  for (const char* text : {"kN/m2", "kN/m^2", "kN/m²", "kN / m2", "kPa"}) {
    ASSERT_TRUE(unit_of(text)) << text;
    EXPECT_EQ(unit_of(text)->si, "Pa") << text;
    EXPECT_EQ(unit_of(text)->factor, 1e3) << text;
  }
  for (const char* text : {"KN/M", "kN m-1", "kN m^-1", "kN m⁻¹", "kN per m", "ｋＮ／ｍ"}) {
    ASSERT_TRUE(unit_of(text)) << text;
    EXPECT_EQ(unit_of(text)->si, "N/m") << text;
    EXPECT_EQ(unit_of(text)->factor, 1e3) << text;
  }
  EXPECT_EQ(unit_of("m s-2").value().si, "m/s2");
  EXPECT_EQ(unit_of("s-1").value().si, "1/s");
  EXPECT_EQ(unit_of("秒").value().si, "s");
  for (const char* text : {"kN m/m", "kN.m/m", "kN*m/m", "kNm/m"}) {
    ASSERT_TRUE(unit_of(text)) << text;
    EXPECT_EQ(unit_of(text)->si, "N m/m") << text;
  }
  EXPECT_FALSE(unit_of("furlong"));
  EXPECT_FALSE(unit_of(""));
}

TEST(Units, HaveTheirFactors) {
  const auto factor = [](const char* text) { return unit_of(text).value().factor; };
  EXPECT_EQ(factor("Gal"), 0.01);
  EXPECT_EQ(factor("µm"), 1e-6);
  EXPECT_DOUBLE_EQ(factor("tf/m2"), 9806.65);
  EXPECT_DOUBLE_EQ(factor("kgf/cm2"), 98066.5);
  EXPECT_DOUBLE_EQ(factor("tf/m"), 9806.65);
  EXPECT_EQ(factor("kN/m3"), 1e3);
  EXPECT_DOUBLE_EQ(factor("1/h"), 1. / 3600.);
  EXPECT_DOUBLE_EQ(factor("mH2O"), 9806.65);
  EXPECT_NEAR(factor("psi"), 0.45359237 * 9.80665 / (0.0254 * 0.0254), 1e-9);
  EXPECT_NEAR(180. * factor("deg"), 3.141592653589793, 1e-15);
}

TEST(Units, AreListedByQuantity) {
  EXPECT_EQ(units_like("N m/m"), "Nm/m, kNm/m, MNm/m, kgfm/m, tfm/m");
  EXPECT_EQ(units_like("rad/s"), "rad/s, deg/s");
  EXPECT_EQ(units_like("lux"), "");
}

}  // namespace units_test
}  // namespace upbead
