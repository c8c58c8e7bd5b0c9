// Claims: ground that yields is marched wherever it is moved from, also by its base alone, without damping, and before
// anything acts: no step is cut for want of a scale, and a load that is next to nothing changes next to nothing. Ground
// that cannot bear its own weight is told: a check of its own fails, the others are void, a warning names the place.

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "good_case.h"
#include "upbead/algebra/petsc_session.h"
#include "upbead/case/case_run.h"

namespace upbead::test {
namespace rest_run_test {

/// A column 10 m high, and a slope of 45 degrees on ground.
const char* const column_geo = R"(
Point(1) = {0, 0, 0}; Point(2) = {1, 0, 0}; Point(3) = {1, 10, 0}; Point(4) = {0, 10, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Transfinite Curve {1, 3} = 2; Transfinite Curve {2, 4} = 5; Transfinite Surface {1}; Recombine Surface {1};
Physical Surface("soil") = {1};
Physical Curve("base") = {1}; Physical Curve("sides") = {2, 4}; Physical Curve("top") = {3};
)";
const char* const slope_geo = R"(
Point(1) = {-15, -5, 0}; Point(2) = {25, -5, 0}; Point(3) = {25, 0, 0}; Point(4) = {10, 0, 0}; Point(5) = {0, 10, 0};
Point(6) = {-15, 10, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 5}; Line(5) = {5, 6}; Line(6) = {6, 1};
Curve Loop(1) = {1, 2, 3, 4, 5, 6}; Plane Surface(1) = {1};
Mesh.MeshSizeMax = 3; Mesh.MeshSizeMin = 3; Mesh.SubdivisionAlgorithm = 1;
Physical Surface("soil") = {1};
Physical Curve("base") = {1}; Physical Curve("sides") = {2, 6}; Physical Curve("top") = {3, 4, 5};
)";

std::string moved_column(const std::string& law, const std::string& motion, const std::string& more = "") {
  return R"([mesh]
file = "mesh.geo"
[regions.soil]
kind = "porous"
shear_modulus = 2e7
poissons_ratio = 0.3
porosity = 0.4
grain_density = 2650
hydraulic_conductivity = 1e-4
law = ")" +
         law + R"("
strength = { friction_angle = 35 }
[initial]
water_level = 10
bounds = false
[boundaries]
base = { displacement = "fixed", pressure = "sealed" }
sides = { displacement = "level", pressure = "sealed" }
top = { displacement = "free", pressure = "open" }
[probes.p]
at = [0.5, 9.0]
[time]
end = 0.6
step = 0.01
)" + motion +
         more;
}

class RestRun : public InFolder {
 protected:
  Summary run(const std::string& text, const char* mesh) {
    static const PetscSession petsc;  // MPI starts once in a process
    write("mesh.geo", mesh);
    write("case.toml", text);
    const Case input = read_case("case.toml");
    const Simulation scene = simulation_of(input);
    return solve(input, scene).summary;
  }
};

TEST_F(RestRun, GroundMovedByItsBaseAloneNeedsNoOtherLoad) {
  write("quiet.csv", "t,a\n0,0\n0.1,0\n0.2,0\n0.21,0.01\n0.3,0.8\n0.4,0\n0.6,0\n");
  const std::string tiny =
      "[loads.tiny]\nboundary = \"top\"\nkind = \"traction\"\npulse = { shape = \"step\", peak = 0.001 }\n";
  for (const std::string law : {"mohr_coulomb", "hysteretic"})
    for (const std::string motion :
         {"kind = \"acceleration\"\npulse = { shape = \"half_sine\", peak = 0.5, duration = 0.4 }\n",
          "kind = \"acceleration\"\nhistory = \"quiet.csv\"\n",
          "kind = \"velocity\"\npulse = { shape = \"triangle\", peak = 0.05, duration = 0.4 }\n",
          "kind = \"displacement\"\npulse = { shape = \"half_sine\", peak = 0.005, duration = 0.4 }\n"}) {
      const std::string load = "[loads.quake]\nboundary = \"base\"\ndirection = [1, 0]\n" + motion;
      const Summary alone = run(moved_column(law, load), column_geo);
      const Summary with = run(moved_column(law, load, tiny), column_geo);
      EXPECT_EQ(alone.nonlinear->cut_steps, 0) << law << " " << motion;
      EXPECT_GT(alone.nonlinear->peak_strain.value, 0.);
      // a second load, however small, has kinks of its own, and so other steps
      EXPECT_NEAR(alone.energy->work / with.energy->work, 1., 0.005) << law << motion;
    }
}

TEST_F(RestRun, NothingActsForAWhileOrAtAll) {
  const std::string late =
      "[loads.late]\nboundary = \"top\"\nkind = \"traction\"\ndirection = [1, 0]\n"
      "pulse = { shape = \"half_sine\", peak = 5e3, duration = 0.2, start = 0.3 }\n";
  const std::string water =
      "[loads.late]\nboundary = \"top\"\nkind = \"pressure\"\npulse = { shape = \"half_sine\", peak = 5e3, duration = "
      "0.4 }\n";
  for (const std::string law : {"mohr_coulomb", "hysteretic"})
    for (const std::string& load : {late, water}) {
      const Summary found = run(moved_column(law, load), column_geo);
      EXPECT_EQ(found.nonlinear->cut_steps, 0) << law << load;
    }
}

/// A slope of 45 degrees, which stands with gamma H / c of 5.6 at most (Taylor 1937, ground half of H below the toe):
/// 35 kN/m2.
std::string clay_slope(double cohesion, const std::string& more) {
  return R"([mesh]
file = "mesh.geo"
[regions.soil]
kind = "solid"
deformation = "elastic"
youngs_modulus = 1e8
poissons_ratio = 0.3
density = 2000
law = "mohr_coulomb"
strength = { friction_angle = 0, cohesion = )" +
         std::to_string(cohesion) + R"( }
[boundaries]
base = { displacement = "fixed" }
sides = { displacement = "roller" }
top = {}
[loads.push]
boundary = "top"
kind = "traction"
pulse = { shape = "half_sine", peak = 1e3, duration = 0.05 }
[time]
end = 0.01
step = 0.005
[initial]
water_level = -100
)" + more;
}

TEST_F(RestRun, GroundThatFailsUnderItsOwnWeightIsToldAndVoidsTheRest) {
  const Summary weak = run(clay_slope(28e3, ""), slope_geo);
  ASSERT_TRUE(weak.nonlinear);
  EXPECT_FALSE(weak.nonlinear->rest);
  EXPECT_NE(weak.nonlinear->why_no_rest.find("region 'soil' at ("), std::string::npos) << weak.nonlinear->why_no_rest;
  ASSERT_TRUE(weak.safety && weak.safety->upper) << "sought though nobody asked";
  EXPECT_LT(*weak.safety->upper, 0.9);
  EXPECT_GT(*weak.safety->lower, 0.7);
  EXPECT_NE(weak.why_void, "");
  ASSERT_FALSE(weak.checks.empty());
  EXPECT_EQ(weak.checks.front().name, "strength at rest");
  EXPECT_EQ(weak.checks.front().holds, false);
  EXPECT_EQ(weak.checks.front().demand, weak.safety->lower);
  const auto named = [](const Summary& s, const std::string& name) {
    return std::count_if(s.warnings.begin(), s.warnings.end(), [&](const auto& w) { return w.name == name; });
  };
  EXPECT_EQ(named(weak, "no_rest"), 1);

  const Summary sound = run(clay_slope(40e3, ""), slope_geo);
  EXPECT_TRUE(sound.nonlinear->rest);
  EXPECT_EQ(sound.nonlinear->why_no_rest + sound.why_void, "");
  EXPECT_FALSE(sound.safety);
  EXPECT_EQ(sound.checks.front().holds, true);
  EXPECT_EQ(named(sound, "no_rest"), 0);

  const Summary scant = run(clay_slope(40e3, "[limits]\nsafety = 1.8\n"), slope_geo);
  ASSERT_TRUE(scant.safety);
  EXPECT_EQ(scant.checks.front().holds, false) << "it stands, with less than is asked for";
  EXPECT_EQ(scant.why_void, "");
}

TEST_F(RestRun, AllOtherChecksOfASectionOnFailingGroundAreVoid) {
  std::ifstream file(UPBEAD_SECTION_CASE);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  const auto replace = [&](const std::string& a, const std::string& b) { text.replace(text.find(a), a.size(), b); };
  replace("[regions.seabed]", "[initial]\nwater_level = 8\n[regions.seabed]");
  replace("[regions.mound]",
          "[regions.mound]\nlaw = \"mohr_coulomb\"\nstrength = { friction_angle = 15, cohesion = 100 }");
  text += "[sliding]\nsubmerged_weight = 1e6\n[limits]\nsliding = 10\n";
  static const PetscSession petsc;
  unsetenv("UPBEAD_MESHES");
  write("case.toml", text);
  const Case input = read_case("case.toml");
  const Summary found = solve(input, simulation_of(input)).summary;
  EXPECT_NE(found.why_void, "");
  EXPECT_EQ(found.checks.front().holds, false);
  ASSERT_GT(found.checks.size(), 3u);
  for (auto check = found.checks.begin() + 1; check != found.checks.end(); ++check) {
    EXPECT_FALSE(check->holds.has_value()) << check->name;
    EXPECT_FALSE(check->margin.has_value()) << check->name;
    EXPECT_EQ(check->why_not.rfind("void: ", 0), 0u) << check->name;
  }
  EXPECT_EQ(found.sliding->design.why.rfind("void: ", 0), 0u);
}

}  // namespace rest_run_test
}  // namespace upbead::test
