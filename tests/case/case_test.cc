// Claim: every value of a case reaches the scene, defaults fill the rest, overrides take precedence and are named
// when wrong.
#include "upbead/case/case.h"

#include <limits>

#include "case/case_schema.h"
#include "good_case.h"

namespace upbead::test {

namespace case_test {

const std::string small_case = "[mesh]\ngeometry = \"column\"\n[regions.soil]\nkind = \"rigid\"\nmass = 1\n";

std::string refusal(const std::string& path, const std::vector<std::string>& overrides) {
  try {
    read_case(path, overrides);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

class CaseTest : public InFolder {
 protected:
  static Case read(const std::string& text, const std::vector<std::string>& overrides = {}) {
    write("case.toml", text);
    return read_case("case.toml", overrides);
  }
};

TEST_F(CaseTest, TellsTopFluidAndMesh) {
  const Case problem = read(good_case);
  EXPECT_EQ(problem.stem, "case");
  const Scene& scene = problem.scene;
  EXPECT_EQ(scene.title, "prototype");
  EXPECT_EQ(scene.gravity, 9.8);
  EXPECT_EQ(scene.fluid.density, 1025.);
  EXPECT_EQ(scene.fluid.bulk_modulus, std::numeric_limits<double>::infinity());
  EXPECT_EQ(scene.mesh.geometry, "composite");
  EXPECT_FALSE(scene.mesh.file);
  EXPECT_EQ(scene.mesh.parameters, (std::map<std::string, double>{{"mound_height", 6.}, {"sand_depth", 15.}}));
  EXPECT_EQ(scene.mesh.refine, 1);
  EXPECT_EQ(scene.mesh.degree, 3);
}

TEST_F(CaseTest, TellsRegions) {
  const Scene scene = read(good_case).scene;
  ASSERT_EQ(scene.regions.size(), 3u);
  const Region& rubble = scene.regions.at("rubble");
  EXPECT_EQ(rubble.kind, RegionKind::porous);
  EXPECT_EQ(rubble.shear_modulus, 100e6);
  EXPECT_EQ(rubble.poissons_ratio, 0.3);
  EXPECT_EQ(rubble.porosity, 0.4);
  EXPECT_EQ(rubble.grain_density, 2650.);
  EXPECT_EQ(rubble.hydraulic_conductivity, 0.1);
  EXPECT_EQ(rubble.flow, Flow::inertial);
  EXPECT_EQ(rubble.tortuosity, 1.2);
  EXPECT_EQ(rubble.biot, 0.9);
  EXPECT_EQ(rubble.grain_bulk_modulus, 3.6e10);
  ASSERT_TRUE(rubble.damping);
  EXPECT_EQ(rubble.damping->ratio, 0.05);
  EXPECT_EQ(rubble.damping->frequencies, (std::array<double, 2>{1., 8.}));
  const Region& block = scene.regions.at("block");
  EXPECT_EQ(block.kind, RegionKind::solid);
  EXPECT_EQ(block.youngs_modulus, 30e9);
  EXPECT_EQ(block.density, 2400.);
  const Region& caisson = scene.regions.at("caisson");
  EXPECT_EQ(caisson.kind, RegionKind::rigid);
  EXPECT_EQ(caisson.mass, 756e3);
  EXPECT_EQ(caisson.centre_of_gravity, (std::array<double, 2>{0., 16.}));
  EXPECT_EQ(caisson.moment_of_inertia, 45e6);
}

TEST_F(CaseTest, TellsBoundariesAndLoads) {
  const Case problem = read(good_case);
  const Scene& scene = problem.scene;
  EXPECT_EQ(scene.boundaries.at("base").displacement, DisplacementCondition::roller);
  EXPECT_EQ(scene.boundaries.at("base").pressure, PressureCondition::open);
  EXPECT_EQ(scene.boundaries.at("front").displacement, DisplacementCondition::free);
  EXPECT_EQ(scene.boundaries.at("front").pressure, PressureCondition::sealed);
  const Load& impact = scene.loads.at("impact");
  EXPECT_EQ(impact.boundary, "front");
  EXPECT_EQ(impact.kind, LoadKind::force);
  EXPECT_EQ(impact.direction, (std::array<double, 2>{1., 0.5}));
  EXPECT_EQ(impact.shape, (std::vector<std::array<double, 2>>{{6., 1.}, {26., 0.5}}));
  EXPECT_DOUBLE_EQ(impact.history(0.05), 2e6);
  const Pulse& pulse = *problem.tables->load_tables.at("impact").pulse;
  EXPECT_EQ(pulse.shape, PulseShape::church_roof);
  EXPECT_EQ(pulse.plateau, 0.3);
  EXPECT_EQ(pulse.plateau_duration, 3.);
  const Load& gauge = scene.loads.at("gauge");
  EXPECT_EQ(gauge.region, "caisson");
  EXPECT_EQ(gauge.at, (std::array<double, 2>{-9., 16.}));
  EXPECT_DOUBLE_EQ(gauge.history(0.1), 0.5e6);
  EXPECT_DOUBLE_EQ(*gauge.duration, 0.4);
  EXPECT_EQ(problem.tables->load_tables.at("gauge").history_file, "force.csv");
}

TEST_F(CaseTest, TellsTimeProbesAndOutput) {
  const Scene scene = read(good_case).scene;
  EXPECT_EQ(scene.time.end, 2.);
  EXPECT_EQ(scene.time.step, 0.001);
  EXPECT_EQ(scene.time.scheme, TimeScheme::sdirk4);
  EXPECT_TRUE(scene.time.inertia);
  EXPECT_EQ(scene.time.stop_at_energy, 1e-4);
  EXPECT_EQ(scene.tolerance, 0.01);
  EXPECT_EQ(scene.probes.at("A").at, (std::array<double, 2>{0., -5.}));
  EXPECT_EQ(scene.fields_every, 0.02);
}

TEST_F(CaseTest, FillsInDefaults) {
  const Scene scene = read(small_case).scene;
  EXPECT_EQ(scene.gravity, 9.81);
  EXPECT_EQ(scene.fluid.bulk_modulus, 2.2e9);
  EXPECT_EQ(scene.mesh.degree, 2);
  EXPECT_FALSE(scene.time.step);
  EXPECT_EQ(scene.time.scheme, TimeScheme::automatic);
  EXPECT_FALSE(scene.fields_every);
}

TEST_F(CaseTest, KnowsThePlaceOfAKey) {
  const Case problem = read(good_case);
  EXPECT_EQ(to_string({problem.place("regions.rubble.biot"), "here", ""}), "case.toml:23:1: here");
  EXPECT_EQ(to_string({problem.place("loads.impact.pulse.peak"), "here", ""}), "case.toml:54:1: here");
  EXPECT_EQ(to_string({problem.place("regions.block.damping"), "the table", ""}), "case.toml:27:10: the table");
}

TEST_F(CaseTest, TakesOverrides) {
  const Scene scene = read(good_case, {"time.step=auto", "regions.rubble.porosity=0.45", "mesh.geometry=column",
                                       "regions.rubble.damping={ ratio = 0.1 }", "probes.B.at=[1, 2]"})
                          .scene;
  EXPECT_FALSE(scene.time.step);
  EXPECT_EQ(scene.regions.at("rubble").porosity, 0.45);
  EXPECT_EQ(scene.regions.at("rubble").damping->frequencies, (std::array<double, 2>{1., 10.}));
  EXPECT_EQ(scene.mesh.geometry, "column");
  EXPECT_EQ(scene.probes.at("B").at, (std::array<double, 2>{1., 2.}));
}

TEST_F(CaseTest, UnderstandsOlderNames) {
  const Case problem = read(small_case, {"mesh.keep_unreached=true"});
  EXPECT_TRUE(problem.scene.mesh.full_domain);
  ASSERT_EQ(problem.notes.size(), 1U);
  EXPECT_NE(notes_on(problem).find("'keep_unreached' is called 'full_domain' now"), std::string::npos);
  EXPECT_EQ(notes_on(read(small_case, {"mesh.full_domain=true"})), "");
}

TEST_F(CaseTest, TellsStagesOfConstruction) {
  const std::string stages =
      "[construction]\nlast = { order = 3, caisson_share = 1, water_level = 12.5 }\n"
      "first = { order = 1, regions = [\"rubble\", \"block\"] }\n";
  const Scene scene =
      read(good_case + stages, {"construction.caisson={order=2, regions=[\"caisson\"], caisson_share=0.3}"}).scene;
  EXPECT_EQ(stages_in_order(scene), (std::vector<std::string>{"first", "caisson", "last"}));
  const ConstructionStage &first = scene.construction.at("first"), &last = scene.construction.at("last");
  EXPECT_EQ(first.regions, (std::vector<std::string>{"rubble", "block"}));
  EXPECT_FALSE(first.caisson_share || first.water_level);
  EXPECT_EQ(scene.construction.at("caisson").caisson_share, 0.3);
  EXPECT_TRUE(last.regions.empty());
  EXPECT_EQ(last.water_level, 12.5);
  EXPECT_TRUE(read(good_case).scene.construction.empty());
}

TEST_F(CaseTest, NamesAWrongOverride) {
  write("case.toml", good_case);
  EXPECT_EQ(
      refusal("case.toml", {"regions.rubble.porosity=4", "time.edn=1"}),
      "--set regions.rubble.porosity=4: porosity = 4 is outside (0, 1); give the share of the pores in the volume\n"
      "--set time.edn=1: unknown key 'edn' in [time]; did you mean 'end'?");
  EXPECT_EQ(refusal("case.toml", {"time.end"}),
            "--set time.end: no '=' between key and value; write --set KEY=VALUE, such as --set time.end=2.0");
}

TEST_F(CaseTest, NamesAFileThatCannotBeRead) {
  EXPECT_EQ(refusal("none.toml", {}), "cannot read 'none.toml'; check the path and the rights");
  EXPECT_EQ(refusal("meshes", {}), "'meshes' is a folder; name a file in it");
}

TEST_F(CaseTest, NeedsARegion) {
  write("case.toml", "[mesh]\ngeometry = \"column\"\n");
  EXPECT_EQ(refusal("case.toml", {}),
            "case.toml: the case has no region; add a table [regions.NAME] for every physical surface of the mesh");
}

TEST_F(CaseTest, NeedsALoadToRunOnly) {
  const Case problem = read(small_case);
  try {
    require_loads(problem);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "case.toml: the case has no load, so nothing would move; add a table [loads.NAME] with boundary and "
                 "pulse");
  }
  EXPECT_NO_THROW(require_loads(read(good_case)));
}

/// The check before the solver starts says the same as the reader, and reads no record of a case without mistakes.
TEST_F(CaseTest, IsCheckedWithoutItsRecords) {
  const std::string load = "[loads.wave]\nboundary = \"top\"\nkind = \"traction\"\nhistory = \"none.csv\"\n";
  write("case.toml", small_case + "[boundaries]\ntop = { displacement = \"free\" }\n" + load);
  EXPECT_NO_THROW(check_case("case.toml"));
  EXPECT_NE(refusal("case.toml", {}).find("none.csv"), std::string::npos);
  const std::vector<std::string> wrong{"fluid.density=-1"};
  try {
    check_case("case.toml", wrong);
    FAIL() << "the mistake was not seen";
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), refusal("case.toml", wrong));
    EXPECT_NE(std::string(error.what()).find("none.csv"), std::string::npos) << "all mistakes at once";
  }
}

}  // namespace case_test
}  // namespace upbead::test
