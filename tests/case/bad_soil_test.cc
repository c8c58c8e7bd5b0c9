// Claim: contradictory or impossible keys of a soil's stiffness are reported, and valid ones are echoed as they were.
#include "bad_case.h"

namespace upbead::test {
namespace bad_soil_test {

class BadSoil : public BadCaseTest {};

TEST_P(BadSoil, IsExplained) {
  check();
}

const std::vector<BadCase> rows{
    BadCase{"NoReference", "shear_modulus = 100e6", "shear_modulus = { exponent = 0.5 }",
            "case.toml:16:1: 'reference' is missing in [regions.rubble.shear_modulus]; add reference, a number (Pa)"},
    BadCase{"UnknownKeyOfTheLaw", "shear_modulus = 100e6", "shear_modulus = { reference = 1e8, exponnt = 0.5 }",
            "case.toml:16:36: unknown key 'exponnt' in [regions.rubble.shear_modulus]; did you mean 'exponent'?"},
    BadCase{"ExponentAboveOne", "shear_modulus = 100e6", "shear_modulus = { reference = 1e8, exponent = 1.5 }",
            "case.toml:16:36: exponent = 1.5 is outside [0, 1]; give the exponent of the stress"},
    BadCase{"FloorZero", "shear_modulus = 100e6", "shear_modulus = { reference = 1e8, floor = 0.0 }",
            "case.toml:16:36: floor = 0 is outside (0, inf); give the least mean effective stress that counts (Pa)"},
    BadCase{"LawOfASolid", "youngs_modulus = 30e9", "shear_modulus = { reference = 1e8 }",
            "case.toml:29:19: [regions.block]: 'shear_modulus.reference' does not belong to a solid region; remove it"},
    BadCase{"LawAndYoungsModulus", "shear_modulus = 100e6", "shear_modulus = { reference = 1e8 }\nyoungs_modulus = 1e8",
            "case.toml:17:1: [regions.rubble]: both 'shear_modulus' and 'youngs_modulus' are given; keep one of them"},
    BadCase{
        "K0Negative", "[time]", "[initial]\nk0 = -0.5\n[time]",
        "case.toml:67:1: k0 = -0.5 is outside (0, 5); give the ratio K_0 of horizontal to vertical effective stress"},
    BadCase{"StageWithoutOrder", "[time]", "[construction]\nmound = { regions = [\"rubble\"] }\n[time]",
            "case.toml:67:1: 'order' is missing in [construction.mound]; add order, a whole number"},
    BadCase{"StageOfAWord", "[time]", "[construction]\nmound = { order = 1, regions = \"rubble\" }\n[time]",
            "case.toml:67:22: regions: expected a list of strings, found a string; give the regions that appear in "
            "this stage, without stress, on what stands already"},
    BadCase{"StrainWithoutDamping", "damping = { ratio = 0.05, frequencies = [1.0, 8] }", "strain = {}",
            "case.toml:14:10: [regions.rubble]: 'damping' is missing, whose frequencies strain-dependent damping "
            "needs; add damping = { ratio = 0.05, frequencies = [1.0, 10.0] }"},
    BadCase{"DampingDescends", "tortuosity = 1.2",
            "tortuosity = 1.2\nstrain = { smallest_damping = 0.2, largest_damping = 0.1 }",
            "case.toml:23:1: [regions.rubble]: largest_damping is less than smallest_damping; give the damping at "
            "large strain as the larger"},
    BadCase{"TableOfStrainDescends", "tortuosity = 1.2",
            "tortuosity = 1.2\nstrain = { modulus = [[1e-3, 0.5], [1e-4, 1.0]] }",
            "case.toml:23:1: [regions.rubble]: a table of strain does not ascend from above 0, or has a negative "
            "value; give pairs (strain, value) in ascending strain"},
    BadCase{"RatioAboveOne", "tortuosity = 1.2", "tortuosity = 1.2\nstrain = { modulus = [[1e-4, 1.5]] }",
            "case.toml:23:1: [regions.rubble]: G/G_max of a table lies outside (0, 1]; give ratios of the secant to "
            "the largest stiffness"},
    BadCase{"DampingInPercent", "tortuosity = 1.2", "tortuosity = 1.2\nstrain = { damping = [[1e-4, 5.0]] }",
            "case.toml:23:1: [regions.rubble]: a damping ratio of a table is not below 1; give ratios, not percent"},
    BadCase{
        "StrainOfARigidRegion", "mass = 756e3", "mass = 756e3\nstrain = {}",
        "case.toml:36:1: 'strain' does not belong in [regions.caisson] (only in porous and solid regions); remove it"},
    BadCase{"DensificationOfElasticSoil", "tortuosity = 1.2",
            "tortuosity = 1.2\ndensification = { relative_density = 0.5 }",
            "case.toml:23:1: [regions.rubble]: soil that packs denser needs a law that follows its history; add law = "
            "\"hysteretic\" or law = \"mohr_coulomb\""},
    BadCase{
        "DensificationOfWhat", "tortuosity = 1.2",
        "tortuosity = 1.2\nlaw = \"hysteretic\"\nstrength = { friction_angle = 35 }\ndensification = {}",
        "case.toml:25:1: [regions.rubble]: neither 'relative_density' nor 'c1' is given, one of which densification "
        "needs; add relative_density = 0.5, or the measured c1"},
    BadCase{"DensificationTwice", "tortuosity = 1.2",
            "tortuosity = 1.2\nlaw = \"hysteretic\"\nstrength = { friction_angle = 35 }\n"
            "densification = { relative_density = 0.5, c1 = 0.4 }",
            "case.toml:25:1: [regions.rubble]: both 'relative_density' and 'c1' are given; keep one of them"},
    BadCase{"DensificationBySecondConstantAlone", "tortuosity = 1.2",
            "tortuosity = 1.2\nlaw = \"hysteretic\"\nstrength = { friction_angle = 35 }\n"
            "densification = { relative_density = 0.5, c2 = 0.4 }",
            "case.toml:25:1: [regions.rubble]: c2 is given without c1; give both, or relative_density alone, which "
            "gives both"},
    BadCase{"RelativeDensityInPercent", "tortuosity = 1.2",
            "tortuosity = 1.2\ndensification = { relative_density = 50 }",
            "case.toml:23:19: relative_density = 50 is outside [0.2, 1]; give the relative density D_r"},
    BadCase{"DensificationOfASolid", "youngs_modulus = 30e9",
            "youngs_modulus = 30e9\ndensification = { relative_density = 0.5 }",
            "case.toml:30:1: 'densification' does not belong in [regions.block] (only in porous regions); remove it"},
    BadCase{"CyclicOfWhat", "tortuosity = 1.2", "tortuosity = 1.2\ncyclic = { alpha = 0.25 }",
            "case.toml:23:1: [regions.rubble]: neither 'relative_density' nor both of 'alpha' and 'beta' are given, "
            "which cyclic needs; add relative_density = 0.5, or alpha and beta of cyclic tests"},
    BadCase{
        "CyclicOfYieldingSoil", "tortuosity = 1.2",
        "tortuosity = 1.2\nlaw = \"hysteretic\"\nstrength = { friction_angle = 35 }\n"
        "cyclic = { relative_density = 0.6 }",
        "case.toml:25:1: [regions.rubble]: the shear of soil that yields is not proportional to the wave, as cycles "
        "of a storm need; write law = \"elastic\", or use densification, which follows every cycle, instead of "
        "cyclic"},
    BadCase{"CyclicOfASolid", "youngs_modulus = 30e9", "youngs_modulus = 30e9\ncyclic = { relative_density = 0.5 }",
            "case.toml:30:1: 'cyclic' does not belong in [regions.block] (only in porous regions); remove it"},
    BadCase{"UnknownFit", "ratio = 0.05,", "ratio = 0.05, fit = \"bnad\",",
            "case.toml:25:27: fit = \"bnad\" is none of ends, band; did you mean 'band'?"},
};

INSTANTIATE_TEST_SUITE_P(, BadSoil, testing::ValuesIn(rows), name_of);

class SoilEcho : public InFolder {};

TEST_F(SoilEcho, KeepsLawsAndInitialState) {
  std::string text = good_case;
  const std::string G = "shear_modulus = 100e6", time = "[time]";
  text.replace(text.find(G), G.size(),
               "shear_modulus = { reference = 180e6, pressure = 98e3, exponent = 0.5 }\n"
               "strain = { reference_strain = 4e-4, modulus = [[1e-6, 1.0], [1e-2, 0.1]] }");
  text.replace(text.find(time), time.size(), "[initial]\nwater_level = 15.0\n[time]");
  write("case.toml", text);
  std::filesystem::create_directories("out");
  const std::string echo = effective_case(read_case("case.toml"), "out");
  for (const char* part : {"[regions.rubble.shear_modulus]\nreference = 1.8e8  # Pa\npressure = 98000.0  # Pa\n",
                           "[regions.rubble.strain]\nreference_strain = 4e-4\n", "[initial]\nwater_level = 15.0  # m\n",
                           "# floor: a tenth of the region's mean\n"})
    EXPECT_NE(echo.find(part), std::string::npos) << part << " is missing in\n" << echo;
  write("out/case.toml", echo);
  const Case again = read_case("out/case.toml");
  EXPECT_EQ(effective_case(again, "out"), echo);
  EXPECT_EQ(again.scene.regions.at("rubble").stress_law->reference, 180e6);
  EXPECT_FALSE(again.scene.regions.at("rubble").shear_modulus);
}

}  // namespace bad_soil_test
}  // namespace upbead::test
