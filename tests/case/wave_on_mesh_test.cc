// Claims: a load by a wave is refused where the wall is not one upright plane from the caisson's bottom to its top; on
// mound and bed it presses, where that is asked for, as the user could write it, and no uplift counts twice.
#include <cmath>

#include "base/numbers.h"
#include "case/wave_load.h"
#include "meshed_wave.h"
#include "wave_case.h"

namespace upbead::test {
namespace wave_on_mesh_test {

/// A caisson whose wall of 16 m is upright up to `upright` (m), and stands `back` (m) farther landward at its top: with
/// a step, or on a slope. `whole`: the curve front is all of it, else its upright part.
std::string own_section(double upright, double back, bool step, bool whole = true) {
  std::string text;
  int points = 0, lines = 0;
  const auto point = [&](double x, double y) {
    text += "Point(" + std::to_string(++points) + ") = {" + std::to_string(x) + ", " + std::to_string(y) + ", 0};\n";
  };
  const auto line = [&](int from, int to) {
    text += "Line(" + std::to_string(++lines) + ") = {" + std::to_string(from) + ", " + std::to_string(to) + "};\n";
  };
  for (const auto& [x, y] : std::vector<std::pair<double, double>>{{-60, -15},
                                                                   {60, -15},
                                                                   {60, 0},
                                                                   {28, 0},
                                                                   {16, 6},
                                                                   {9, 6},
                                                                   {-9, 6},
                                                                   {-16, 6},
                                                                   {-28, 0},
                                                                   {-60, 0},
                                                                   {back - 9., 22},
                                                                   {9, 22},
                                                                   {-9, 6 + upright},
                                                                   {back - 9., 6 + upright}})
    point(x, y);
  for (const auto& [from, to] : std::vector<std::pair<int, int>>{
           {1, 2}, {2, 3}, {3, 4}, {4, 9}, {9, 10}, {10, 1}, {4, 5}, {5, 6}, {6, 7}, {7, 8}, {8, 9}, {6, 12}, {12, 11}})
    line(from, to);
  line(7, upright < 16. ? 13 : 11);
  std::string upper;
  if (upright < 16.) {
    line(step ? 14 : 13, 11);
    if (step) line(13, 14);
    upper = step ? ", 15, 16" : ", 15";
  }
  return text + R"(
Curve Loop(1) = {1, 2, 3, 4, 5, 6}; Plane Surface(1) = {1};
Curve Loop(2) = {-4, 7, 8, 9, 10, 11}; Plane Surface(2) = {2};
Mesh.MeshSizeMax = 8; Mesh.MeshSizeMin = 4; Mesh.SubdivisionAlgorithm = 1;
Physical Surface("seabed") = {1}; Physical Surface("mound") = {2}; Physical Surface("caisson") = {3};
Physical Curve("base") = {1}; Physical Curve("right") = {2}; Physical Curve("left") = {6};
Physical Curve("bed") = {3, 5}; Physical Curve("mound_surface") = {7, 8, 10, 11}; Physical Curve("back") = {12};
Physical Curve("top") = {13};
)" + "Curve Loop(3) = {-9, 12, 13" +
         (step && upright < 16. ? ", -15, -16"
          : upright < 16.       ? ", -15"
                                : "") +
         ", -14}; Plane Surface(3) = {3};\nPhysical Curve(\"front\") = {14" + (whole ? upper : "") + "};\n" +
         (whole ? "" : "Physical Curve(\"slope\") = {" + upper.substr(2) + "};\n");
}

using WaveOnMesh = MeshedWave;

// Goda's formulas are those of one upright plane; what reaches farther back has factors of its own, which are not here.
TEST_F(WaveOnMesh, WallThatIsSetBackOrSlopesIsRefused) {
  const std::string text = wave_case("{ height = 8.0, period = 12.0, course = \"sine\" }");
  const std::vector<std::string> own{"mesh={file=\"own.geo\"}"};
  write("own.geo", own_section(16., 0., false));
  EXPECT_EQ(objections(text, own), "");
  for (const bool step : {true, false}) {
    write("own.geo", own_section(10., 4., step));
    EXPECT_NE(objections(text, own).find("'front' is not upright: it reaches from x = -9 to -5 m"), std::string::npos);
  }
  write("own.geo", own_section(10., 4., false, false));  // the upright part alone, and its height as the crest
  const std::string answer = objections(text, {own[0], "section.crest=1", "boundaries.slope={}"});
  EXPECT_NE(answer.find("the caisson goes on above 'front', up to y = 22 m"), std::string::npos) << answer;
}

/// Mound and bed are pressed as the user could write it: by the pressure at the wall's foot, times cos(2 pi x/L).
TEST_F(WaveOnMesh, PressesOnMoundAndBedAsAtTheFoot) {
  const std::string wave =
      "{ height = 8.0, period = 12.0, course = \"church_roof\", mound = [\"mound_surface\", "
      "\"bed\"] }";
  std::string text = wave_case(wave);
  const std::vector<std::string> computed{"sliding.uplift={ kind = \"computed\" }"};
  const Case problem = read(text, computed);
  const Simulation simulation = simulation_of(problem);
  const WaveLoad& load = *sources_of_type<WaveLoad>(problem).front();
  const auto& loads = simulation.scene().loads;
  for (const char* curve : {"mound_surface", "bed"}) {
    const Load& one = loads.at(std::string("storm.") + curve);
    EXPECT_EQ(one.kind, LoadKind::pressure);
    for (const double t : {0.1, 0.9, 3., 5.5})
      EXPECT_NEAR(one.history(t), loads.at("storm").history(t) * load.pressure.p3 / load.pressure.force, 1e-9);
    EXPECT_NEAR(intensity(one, -9. - 1e-7, 6.), 1., 1e-9);
    EXPECT_EQ(intensity(one, -9. + 1e-7, 6.), 0.);
    for (const double x : {-9.7, -16., -28.})
      EXPECT_NEAR(intensity(one, x, 0.), std::cos(two_pi * (x + 9.) / load.wavelength), 4e-4);
  }
  // the pressure there is that on the wall's foot
  const Load& wall = loads.at("storm");
  double total = 0.;
  for (int i = 0; i < 16000; ++i) total += 1e-3 * intensity(wall, 6. + 1e-3 * (i + 0.5));
  EXPECT_NEAR(wall.history(3.) * intensity(wall, 6.) / total, loads.at("storm.bed").history(3.),
              1e-5 * wall.history(3.));
  EXPECT_NE(objections(text).find("so that a given uplift would count twice"), std::string::npos);
  EXPECT_NE(objections(text, {computed[0], "boundaries.bed.pressure=\"sealed\""}).find("no water passes through 'bed'"),
            std::string::npos);
  EXPECT_NE(objections(text, {computed[0], "regions.caisson.interface={ kind = \"friction\", gap = \"sea\" }"})
                .find("the sea in gaps would count it twice"),
            std::string::npos);
  text.replace(text.find(sliding_table), sliding_table.size(), "[sliding]\n");
  EXPECT_NE(objections(text).find("counts in no S of the caisson as a whole"), std::string::npos);
}

}  // namespace wave_on_mesh_test
}  // namespace upbead::test
