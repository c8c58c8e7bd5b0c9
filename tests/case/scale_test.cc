// Claim: every number of a scaled case follows Froude's law, the inverse factor gives the original case again, and
// what cannot be scaled is reported.
#include <cmath>
#include <regex>
#include <sstream>
#include <stdexcept>

#include "case/scale.h"
#include "good_case.h"

namespace upbead::test {
namespace scale_test {

const std::string geometry =
    "DefineConstant[\n"
    "  mound_height = 5,     // m: height\n"
    "  sand_depth = 15,      // m: depth\n"
    "  crest = 16,           // m: half of the crest\n"
    "  slope = 2,            // -: slope\n"
    "  celerity = {3, Name \"m/s: speed\"}\n"
    "];\n";

class Scale : public InFolder {
 protected:
  Scale() {
    write("meshes/composite.geo", geometry);
    write("case.toml", good_case);
  }

  static ScaleOptions by(double factor) {
    ScaleOptions options;
    options.factor = factor;
    return options;
  }

  /// Scales a case into a folder and reads the scaled case.
  static Case scaled(const std::string& path, const ScaleOptions& options, const std::string& folder) {
    const ScaledCase result = scale_case(read_case(path), options, folder);
    std::filesystem::create_directories(folder);
    write(folder + "/case.toml", result.text);
    for (const NamedText& history : result.histories) write(folder + "/" + history.path, history.text);
    return read_case(folder + "/case.toml");
  }

  /// The text that the user sees.
  static std::string told(const std::string& path, const ScaleOptions& options) {
    try {
      scale_case(read_case(path), options, "out");
    } catch (const InputError& error) {
      return error.what();
    }
    return "nothing";
  }
};

TEST(Froude, PowersOfTheLength) {
  for (const auto& [unit, exponent] : std::vector<std::pair<std::string, double>>{{"", 0.},
                                                                                  {"-", 0.},
                                                                                  {"m", 1.},
                                                                                  {"s", 0.5},
                                                                                  {"Hz", -0.5},
                                                                                  {"m/s", 0.5},
                                                                                  {"m/s2", 0.},
                                                                                  {"kg/m3", 0.},
                                                                                  {"Pa", 1.},
                                                                                  {"N/m", 2.},
                                                                                  {"kg/m", 2.},
                                                                                  {"kg m2/m", 4.},
                                                                                  {"N s/m2", 1.5},
                                                                                  {"N/m3", 0.},
                                                                                  {"1/s", -0.5}})
    EXPECT_DOUBLE_EQ(froude_exponent(unit), exponent) << unit;
  EXPECT_THROW(froude_exponent("furlong"), std::invalid_argument);
  EXPECT_THROW(froude_exponent("N/m or Pa"), std::invalid_argument);
}

TEST(Froude, KnowsTheUnitOfEveryKeyOfACase) {
  const std::regex row(R"(\| `(\w+)` \| a [^|]*?(number|numbers|pairs) \(([^)]*)\))");
  const std::string text = case_reference();
  int n = 0;
  for (std::sregex_iterator match(text.begin(), text.end(), row), end; match != end; ++match, ++n) {
    const std::string unit = (*match)[3];
    if (unit == "N/m or Pa") continue;  // which of the two depends on the load's kind
    EXPECT_NO_THROW(froude_exponent(unit)) << (*match)[1];
  }
  EXPECT_GT(n, 35);
}

TEST_F(Scale, MultipliesEveryNumberByItsDimension) {
  const Scene before = read_case("case.toml").scene, after = scaled("case.toml", by(4.), "out").scene;
  const auto expect_factor = [](double scaled_value, double value, double factor) {
    EXPECT_NEAR(scaled_value / value, factor, 1e-14 * factor);
  };
  EXPECT_EQ(after.gravity, before.gravity);
  EXPECT_EQ(after.fluid.density, before.fluid.density);
  EXPECT_TRUE(std::isinf(after.fluid.bulk_modulus));
  const Region &rubble = before.regions.at("rubble"), &scaled_rubble = after.regions.at("rubble");
  expect_factor(*scaled_rubble.shear_modulus, *rubble.shear_modulus, 4.);
  expect_factor(*scaled_rubble.hydraulic_conductivity, *rubble.hydraulic_conductivity, 2.);
  expect_factor(scaled_rubble.grain_bulk_modulus, rubble.grain_bulk_modulus, 4.);
  expect_factor(*scaled_rubble.grain_density, *rubble.grain_density, 1.);
  expect_factor(scaled_rubble.tortuosity, rubble.tortuosity, 1.);
  expect_factor(scaled_rubble.damping->frequencies[1], rubble.damping->frequencies[1], 0.5);
  const Region &caisson = before.regions.at("caisson"), &scaled_caisson = after.regions.at("caisson");
  expect_factor(*scaled_caisson.mass, *caisson.mass, 16.);
  expect_factor(*scaled_caisson.moment_of_inertia, *caisson.moment_of_inertia, 256.);
  expect_factor((*scaled_caisson.centre_of_gravity)[1], (*caisson.centre_of_gravity)[1], 4.);
  const Load &impact = before.loads.at("impact"), &scaled_impact = after.loads.at("impact");
  expect_factor(scaled_impact.shape[1][0], impact.shape[1][0], 4.);
  expect_factor(scaled_impact.shape[1][1], impact.shape[1][1], 1.);
  expect_factor(scaled_impact.direction[1], impact.direction[1], 1.);
  expect_factor(scaled_impact.history(2 * 0.03), impact.history(0.03), 16.);
  expect_factor(after.loads.at("gauge").history(2 * 0.15), before.loads.at("gauge").history(0.15), 16.);
  expect_factor(after.loads.at("gauge").at[0], before.loads.at("gauge").at[0], 4.);
  expect_factor(after.time.end, before.time.end, 2.);
  expect_factor(*after.time.step, *before.time.step, 2.);
  expect_factor(*after.fields_every, *before.fields_every, 2.);
  expect_factor(after.probes.at("A").at[1], before.probes.at("A").at[1], 4.);
  expect_factor(after.sliding->submerged_weight, before.sliding->submerged_weight, 16.);
  expect_factor(after.sliding->drag, before.sliding->drag, 8.);
  expect_factor(after.sliding->friction, before.sliding->friction, 1.);
  expect_factor(*after.sliding->uplift->peak, *before.sliding->uplift->peak, 16.);
  expect_factor(after.sliding->uplift->lag, before.sliding->uplift->lag, 2.);
  expect_factor(after.sliding->wave->period, before.sliding->wave->period, 2.);
}

TEST_F(Scale, WritesTheGeometrysOwnLengthsToo) {
  const auto parameters = scaled("case.toml", by(4.), "out").scene.mesh.parameters;
  EXPECT_EQ(parameters, (std::map<std::string, double>{
                            {"mound_height", 24.}, {"sand_depth", 60.}, {"crest", 64.}, {"celerity", 6.}}));
}

TEST_F(Scale, LeavesTheSameSoilAsItIs) {
  ScaleOptions options = by(4.);
  options.soil = SoilScaling::same;
  options.ratios = {"regions.rubble.shear_modulus=2"};
  const Scene before = read_case("case.toml").scene, after = scaled("case.toml", options, "out").scene;
  EXPECT_EQ(*after.regions.at("rubble").shear_modulus, 2 * *before.regions.at("rubble").shear_modulus);
  EXPECT_EQ(*after.regions.at("block").youngs_modulus, *before.regions.at("block").youngs_modulus);
  EXPECT_EQ(*after.regions.at("rubble").hydraulic_conductivity, *before.regions.at("rubble").hydraulic_conductivity);
  EXPECT_EQ(after.regions.at("rubble").damping->frequencies[0],
            before.regions.at("rubble").damping->frequencies[0] / 2);
  EXPECT_EQ(*after.regions.at("caisson").mass, 16 * *before.regions.at("caisson").mass);
  EXPECT_EQ(scale_case(read_case("case.toml"), options, "out").kept,
            (std::vector<std::string>{"regions.block.youngs_modulus", "regions.rubble.hydraulic_conductivity",
                                      "regions.rubble.grain_bulk_modulus"}));
}

TEST_F(Scale, DecidesAPulsesPeakByTheKindOfItsLoad) {
  std::string text = good_case;
  text.replace(text.find("kind = \"force\"\n"), 14, "kind = \"traction\"");
  write("case.toml", text);
  EXPECT_NE(scale_case(read_case("case.toml"), by(4.), "out").text.find("peak = 8e6"), std::string::npos);
}

/// Numbers of a text, and the text without them.
std::pair<std::vector<double>, std::string> taken_apart(const std::string& text) {
  const std::regex number(R"([-+]?\b\d+\.?\d*(e[-+]?\d+)?\b)");
  std::vector<double> numbers;
  for (std::sregex_iterator match(text.begin(), text.end(), number), end; match != end; ++match)
    numbers.push_back(std::stod(match->str()));
  return {numbers, std::regex_replace(text, number, "#")};
}

TEST_F(Scale, ComesBackByTheInverseFactor) {
  scaled("case.toml", by(20.), "large");
  scaled("large/case.toml", by(1. / 20.), "back");
  scaled("case.toml", by(1.), "once");
  std::ostringstream once, back;
  once << std::ifstream("once/case.toml").rdbuf() << std::ifstream("once/gauge.csv").rdbuf();
  back << std::ifstream("back/case.toml").rdbuf() << std::ifstream("back/gauge.csv").rdbuf();
  const auto body = [](const std::string& text) { return text.substr(text.find("gravity")); };
  const auto [expected, words] = taken_apart(body(once.str()));
  const auto [numbers, same_words] = taken_apart(body(back.str()));
  EXPECT_EQ(same_words, words);
  ASSERT_EQ(numbers.size(), expected.size());
  for (std::size_t i = 0; i < numbers.size(); ++i)
    EXPECT_NEAR(numbers[i], expected[i], 1e-12 * std::abs(expected[i])) << i;
}

TEST_F(Scale, TellsWhatCannotBeScaled) {
  EXPECT_EQ(told("case.toml", by(0.)),
            "--factor 0: the factor is not a positive number; give the new length over the old one, such as 20, or "
            "0.05 for a model");
  ScaleOptions options = by(20.);
  options.ratios = {"regions.rubble.shear_modulos=2"};
  EXPECT_EQ(told("case.toml", options),
            "--ratio regions.rubble.shear_modulos=2: the case has no number 'regions.rubble.shear_modulos'; did you "
            "mean 'regions.rubble.shear_modulus'?");
  options.ratios = {"regions.rubble.porosity=3"};
  EXPECT_EQ(told("case.toml", options),
            "--ratio regions.rubble.porosity=3: regions.rubble.porosity = 1.2000000000000002 is outside (0, 1); give "
            "another ratio");
  options.ratios = {"porosity", "fluid.density=heavy", "gravity=1", "gravity=2"};
  EXPECT_EQ(told("case.toml", options),
            "--ratio porosity: it is not a key and a number; write --ratio KEY=VALUE, such as --ratio "
            "regions.seabed.shear_modulus=4.47\n"
            "--ratio fluid.density=heavy: it is not a key and a number; write --ratio KEY=VALUE, such as --ratio "
            "regions.seabed.shear_modulus=4.47\n"
            "--ratio gravity=2: the key has a ratio already; keep one of them");
}

TEST_F(Scale, TellsWhatIsMissingInAGeometry) {
  write("meshes/composite.geo",
        "DefineConstant[ mound_height = 5, // height of the mound\n sand_depth = 1 + 2 // m: x\n];\n");
  const std::string folder = (folder_ / "meshes/composite.geo").string();
  std::string text = good_case;
  const std::string both = "{ mound_height = 6, sand_depth = 15.0 }";
  write("case.toml", text.replace(text.find(both), both.size(), "{ mound_height = 6 }"));
  const std::string cure =
      "begin the comment behind its number with its unit, such as // m: height of the mound, or // -: for a number "
      "without one";
  EXPECT_EQ(told("case.toml", by(20.)), "case.toml:9:1: the parameter 'mound_height' of " + folder +
                                            " cannot be scaled: its comment names no unit; " + cure +
                                            "\ncase.toml:9:1: the parameter 'sand_depth' of " + folder +
                                            " cannot be scaled: its default '1 + 2' is no number; " + cure);
  write("meshes/composite.geo", "DefineConstant[ mound_height = 5 // -: height\n];\n");
  EXPECT_EQ(told("case.toml", by(20.)),
            "case.toml:9:1: " + folder +
                " cannot be scaled: no parameter of it is a length; make its lengths parameters (DefineConstant) with "
                "// m: comments");
  const std::string shipped = "geometry = \"composite\"\nparameters = { mound_height = 6 }";
  write("case.toml", text.replace(text.find(shipped), shipped.size(), "file = \"my.msh\""));
  EXPECT_EQ(told("case.toml", by(20.)),
            "case.toml:9:1: a finished mesh (.msh) cannot be scaled; name the .geo that made it");
}

}  // namespace scale_test
}  // namespace upbead::test
