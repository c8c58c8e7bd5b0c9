// Claim: the effective case spells every default out and, read from its own folder, is the same case again; paths and
// the mesh request are relative to the right folder; the reference lists every key.
#include "case/case_schema.h"
#include "good_case.h"
#include "upbead/case/case.h"
#include "upbead/mesh/mesh.h"

namespace upbead::test {
namespace effective_case_test {

class EffectiveCase : public InFolder {};

TEST_F(EffectiveCase, ReadsBackAsTheSame) {
  write("case.toml", good_case);
  std::filesystem::create_directories("results/run");
  const std::string text = effective_case(read_case("case.toml"), "results/run");
  EXPECT_NE(text.find("history = \"../../force.csv\""), std::string::npos) << text;
  write("results/run/case.toml", text);
  const Case again = read_case("results/run/case.toml");
  EXPECT_EQ(effective_case(again, "results/run"), text);
  EXPECT_DOUBLE_EQ(again.scene.loads.at("gauge").history(0.2), 1e6);
}

TEST_F(EffectiveCase, KeepsTheRecordOfAnUplift) {
  std::string text = good_case;
  const std::string prescribed = "peak = 5e5\nshape = \"held\"\nlag = 0.02";
  write("uplift.csv", "time,U\n0,0\n0.1,3e5\n0.3,0\n");
  write("case.toml", text.replace(text.find(prescribed), prescribed.size(), "history = \"uplift.csv\""));
  std::filesystem::create_directories("results/run");
  write("results/run/case.toml", effective_case(read_case("case.toml"), "results/run"));
  const Case again = read_case("results/run/case.toml");
  ASSERT_TRUE(again.scene.sliding && again.scene.sliding->uplift);
  EXPECT_EQ(again.tables->sliding_table->uplift_table->history_file, "../../uplift.csv");
  EXPECT_DOUBLE_EQ(again.scene.sliding->uplift->history(0.05), 1.5e5);
  EXPECT_DOUBLE_EQ(again.scene.sliding->friction, 0.55);
  EXPECT_DOUBLE_EQ(again.scene.sliding->wave->period, 13.6);
}

TEST_F(EffectiveCase, SpellsOutDefaults) {
  write("case.toml",
        "[mesh]\nfile = \"sub/my.msh\"\n[regions.soil]\nkind = \"porous\"\nshear_modulus = 1e7\npoissons_ratio = 0.3\n"
        "porosity = 0.4\ngrain_density = 2650\nhydraulic_conductivity = 1e-4\n[boundaries.top]\n"
        "[loads.step]\nboundary = \"top\"\npulse = { shape = \"step\", peak = 3 }\n");
  EXPECT_EQ(effective_case(read_case("case.toml"), "out"),
            R"(gravity = 9.81  # m/s2

[fluid]
density = 1030.0  # kg/m3
bulk_modulus = 2.2e9  # Pa
viscosity = 0.00107  # Pa s
atmospheric_pressure = 101325.0  # Pa

[mesh]
file = "../sub/my.msh"
refine = 0
degree = 2
full_domain = false

[regions.soil]
kind = "porous"
shear_modulus = 1e7  # Pa
law = "elastic"
poissons_ratio = 0.3
porosity = 0.4
grain_density = 2650.0  # kg/m3
hydraulic_conductivity = 1e-4  # m/s
conductivity_ratio = 1.0
saturation = 1.0
air_by_depth = false
flow = "auto"
tortuosity = 1.0
biot = 1.0
grain_bulk_modulus = inf  # Pa

[boundaries.top]
displacement = "free"
# spring: none
# dashpot: none

[loads.step]
boundary = "top"
kind = "force"
direction = [1.0, 0.0]
# shape: uniform
over_x = false
along_curve = false
measured_on_wall = false
factor = 1.0

[loads.step.pulse]
shape = "step"
peak = 3.0  # N/m or Pa
# rise: half the duration; of a step 0
start = 0.0  # s
number = 1
# period: none: there is one pulse

[time]
end = 1.0  # s
step = "auto"
scheme = "auto"
inertia = true
growth = 2.0
# stop_at_energy: never before end

[accuracy]
tolerance = 0.005
of = "history"
estimate = false

[output]
base = false
periods = false
# times: none
# every: only the steps' own times
)");
}

TEST_F(EffectiveCase, AsksForTheMesh) {
  write("case.toml", good_case);
  const MeshRequest shipped = mesh_request(read_case("case.toml"));
  EXPECT_EQ(shipped.file, (folder_ / "meshes" / "composite.geo").string());
  EXPECT_EQ(shipped.place.line, 9);
  EXPECT_EQ(shipped.parameters.at("sand_depth"), 15.);
  EXPECT_EQ(shipped.parameter_places.at("sand_depth").column, 34);
  EXPECT_EQ(shipped.refine, 1);
  std::filesystem::create_directory("sub");
  write("sub/case.toml", "[mesh]\nfile = \"my.msh\"\n[regions.soil]\nkind = \"rigid\"\nmass = 1\n");
  EXPECT_EQ(mesh_request(read_case("sub/case.toml")).file, "sub/my.msh");
}

TEST(CaseReference, TellsEveryKey) {
  const std::string text = case_reference();
  for (const std::string table : {"[fluid]", "[mesh]", "[regions.NAME]", "[regions.NAME.damping]", "[boundaries.NAME]",
                                  "[loads.NAME]", "[loads.NAME.pulse]", "[time]", "[accuracy]", "[probes.NAME]",
                                  "[output.fields]", "[sliding]", "[sliding.uplift]", "[sliding.wave]"})
    EXPECT_NE(text.find("## `" + table + "`"), std::string::npos) << table;
  std::istringstream lines(test::good_case);
  for (std::string line; std::getline(lines, line);) {
    const std::string key = line.substr(0, line.find(" = "));
    if (line.empty() || line[0] == '[' || key == "fields" || key == "damping" || key == "pulse" || key == "wave")
      continue;
    EXPECT_NE(text.find("| `" + key + "` |"), std::string::npos) << key;
  }
  EXPECT_NE(text.find("| `porosity` | a number | (0, 1) |   | share of the pores in the volume; needed (only in porous "
                      "regions) |"),
            std::string::npos);
  EXPECT_NE(text.find("| `step` | a number (s) or \"auto\" | (0, inf) | `\"auto\"` |"), std::string::npos);
}

}  // namespace effective_case_test
}  // namespace upbead::test
