// Claim: the answer of a soil is the reduced model of its System, and a soil outside the box is refused with the box.
#include "soils/soil_answers.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "../output/sample_soils.h"

namespace upbead::test {

namespace soil_answers_test {

SoilAnswers answers() {
  return {two_soils(), "soils.h5"};
}

std::string refusal(const Soil& soil) {
  try {
    answers().whole(soil);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(SoilAnswers, CoefficientsFollowFromTheText) {
  const SoilAnswers model = answers();
  const Soil soil = model.whole({{"regions.sand.shear_modulus", 5e7}});
  EXPECT_EQ(soil.at("regions.sand.hydraulic_conductivity"), 2e-1) << "the case's value";
  const std::vector<double> factors = model.factors(soil);
  ASSERT_EQ(factors.size(), 2U);
  EXPECT_EQ(factors[0], 5e7);
  EXPECT_NEAR(factors[1], 2e-1 / (1000. * 10.), 1e-15);  // k / (rho_f g)
}

TEST(SoilAnswers, KeysMayBeQuoted) {
  EXPECT_EQ(answers().whole({{"regions.\"sand\".shear_modulus", 5e7}}).at("regions.sand.shear_modulus"), 5e7);
}

TEST(SoilAnswers, RefusesASoilOutsideTheBoxAndNamesTheBox) {
  const std::string box = "regions.sand.shear_modulus from " + number_text(1e7) + " to " + number_text(1e8);
  EXPECT_NE(refusal({{"regions.sand.shear_modulus", 2e8}}).find("lies outside the box"), std::string::npos);
  EXPECT_NE(refusal({{"regions.sand.shear_modulus", 2e8}}).find(box), std::string::npos);
  EXPECT_NE(refusal({{"regions.sand.porosity", 0.4}}).find("is no key that the model varies"), std::string::npos);
  EXPECT_NE(refusal({{"loads.impact.factor", 2.}}).find(box), std::string::npos);
  EXPECT_EQ(refusal({{"regions.sand.shear_modulus", 1e8}}), "");
}

TEST(SoilAnswers, AMemberIsTheModelOfItsOwnSoil) {
  const SoilAnswers model = answers();
  const ReducedModelFile soft = model.at(model.whole({{"regions.sand.shear_modulus", 1e7}}));
  const ReducedModelFile stiff = model.at(model.whole({{"regions.sand.shear_modulus", 1e8}}));
  for (const auto& [found, G] : {std::pair(&soft, 1e7), std::pair(&stiff, 1e8)}) {
    const ReducedSystem member = model.file().family.reduced.at({G, 2e-5});
    const std::complex<double> s(1., 20.);
    const Eigen::Matrix3cd T = s * s * member.M.cast<std::complex<double>>() + s * member.C + member.K;
    const Eigen::Vector3cd x = T.partialPivLu().solve(member.load.col(0).cast<std::complex<double>>());
    const std::complex<double> exact = 1. - 6e5 * s * s * x[0];
    EXPECT_LT(std::abs(found->modes.transfer(0, 0, s) - exact), 1e-6 * std::abs(exact)) << G;
    EXPECT_GT(found->highest_frequency, 50.) << "the space of three coordinates is exhausted, so that it is exact";
    ASSERT_TRUE(found->nested);
    EXPECT_LT(std::abs(found->nested->reference.transfer(0, 0, s) - exact), 1e-6 * std::abs(exact)) << G;
  }
}

TEST(SoilAnswers, TellsATextThatDoesNotFit) {
  SoilModelFile file = two_soils();
  file.box[0].key = "regions.sand.youngs_modulus";
  file.family.terms[1].region = "clay";
  try {
    const SoilAnswers model(file, "soils.h5");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.diagnostics().list().size(), 2U);
  }
}

TEST(SoilAnswers, ReadsOptions) {
  EXPECT_EQ(soil_of_options({"a.b=25e6", "c=1"}), (Soil{{"a.b", 25e6}, {"c", 1.}}));
  for (const char* wrong : {"a.b", "a.b=", "=1", "a.b=x", "a.b=nan", "a.b=1x"})
    EXPECT_THROW(soil_of_options({wrong}), InputError) << wrong;
  EXPECT_THROW(soil_of_options({"a=1", "a=2"}), InputError);
}

}  // namespace soil_answers_test
}  // namespace upbead::test
