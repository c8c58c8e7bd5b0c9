// Claim: files of OpenFOAM as they lie about are read right or refused by name: a second head anywhere in a file, runs
// beside each other in one folder, sampled surfaces in .xy, outputs that are no load, vertical forces left out.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "case/cfd/flow_keys.h"
#include "case/cfd/flow_record.h"
#include "upbead/base/error.h"

namespace upbead::test {

namespace flow_files_test {

namespace fs = std::filesystem;

/// A folder of its own for each test.
class FlowFiles : public testing::Test {
 protected:
  void SetUp() override { fs::remove_all(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  std::string write(const std::string& name, const std::string& text) const {
    fs::create_directories((fs::path(folder_) / name).parent_path());
    std::ofstream(fs::path(folder_) / name, std::ios::binary) << text;
    return (fs::path(folder_) / name).string();
  }
  FlowRecord read(const std::string& name = "", const std::string& file = "") const {
    return read_flow((fs::path(folder_) / name).string(), file, {"case.toml", 1, 1});
  }
  std::string refusal(const std::string& name = "", const std::string& file = "") const {
    try {
      read(name, file);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  const std::string folder_ = "flow_files";
};

#define EXPECT_HAS(text, part) EXPECT_NE(std::string(text).find(part), std::string::npos) << (text)

std::string head(const std::string& centre = "(0 0 0)", const std::string& parts = "pressure viscous") {
  return "# Forces\n# CofR       : " + centre + "\n# Time       forces(" + parts + ") moment(" + parts + ")\n";
}

std::string row(double t, double f, double m, bool porous = false) {
  const auto vector = [](double x, double y) { return "(" + std::to_string(x) + " 0 " + std::to_string(y) + ")"; };
  const std::string more = porous ? " " + vector(0.25 * f, 0.) : "", more_m = porous ? " " + vector(0., 0.5 * m) : "";
  return std::to_string(t) + " (" + vector(f, 1.) + " " + vector(0.5 * f, 2.) + more + ") (" + vector(3., m) + " " +
         vector(4., 0.25 * m) + more_m + ")\n";
}

void expect_row(const FlowForces& forces, std::size_t i, double t, double f, double m, bool porous = false) {
  ASSERT_LT(i, forces.time.size());
  ASSERT_EQ(forces.moment.size(), forces.time.size());
  EXPECT_DOUBLE_EQ(forces.time[i], t);
  EXPECT_EQ(forces.force[i], (Triple{(porous ? 1.75 : 1.5) * f, 0., 3.}));
  EXPECT_EQ(forces.moment[i], (Triple{7., 0., (porous ? 1.75 : 1.25) * m}));
}

TEST_F(FlowFiles, SecondHeadBeginsAnotherRun) {
  for (const bool porous : {false, true}) {
    const std::string again = head("(1 2 3)", porous ? "pressure viscous porous" : "pressure viscous");
    write("0/forces.dat", again + row(0.125, 8, 2, porous) + row(0.25, 16, 4, porous) + again +
                              row(0.5, 32, 8, porous) + row(0.75, 64, 16, porous));
    const FlowRecord record = read();
    ASSERT_TRUE(record.forces);
    ASSERT_EQ(record.forces->time.size(), 4U);
    EXPECT_EQ(record.forces->centre, (Triple{1, 2, 3}));
    expect_row(*record.forces, 1, 0.25, 16, 4, porous);
    expect_row(*record.forces, 2, 0.5, 32, 8, porous);
    expect_row(*record.forces, 3, 0.75, 64, 16, porous);
    EXPECT_HAS(text_of(record), "the run from line 9 on goes on from t = 0.5 s");
  }
}

TEST_F(FlowFiles, OfRunsInOneFileTheLaterStartWins) {
  write("0/forces.dat", head() + head() + row(0.125, 8, 2) + row(0.25, 16, 4) + row(0.5, 1, 1) + head() +
                            row(0.25, 24, 6) + row(0.375, 40, 10));
  const FlowRecord record = read();
  ASSERT_EQ(record.forces->time.size(), 3U);
  expect_row(*record.forces, 0, 0.125, 8, 2);
  expect_row(*record.forces, 1, 0.25, 24, 6);
  expect_row(*record.forces, 2, 0.375, 40, 10);
  EXPECT_HAS(text_of(record), "in place of 2 rows");
}

TEST_F(FlowFiles, SecondHeadThatSaysSomethingElseIsRefused) {
  const std::string first = head() + row(0.125, 8, 2) + row(0.25, 16, 4);
  for (const std::string& other : {head("(0 0 1)"), head("(0 0 0)", "pressure viscous porous"),
                                   std::string("# Time forces(pressure viscous) moment(pressure viscous)\n")}) {
    write("0/forces.dat", first + other + row(0.5, 32, 8, other.find("porous") != std::string::npos));
    const std::string said = refusal();
    EXPECT_HAS(said, "a second head, which differs from that of line 3 in its columns or its CofR");
    EXPECT_HAS(said, "forces.dat:" + std::string(other.front() == '#' && other[2] == 'T' ? "6" : "8"));
  }
  write("0/forces.dat", first + "# CofR : (0 0 0)\n" + row(0.5, 32, 8));
  EXPECT_HAS(refusal(), "there is no header '# Time ...'");
  write("0/forces.dat", first + head() + row(0.0625, 8, 2));
  EXPECT_HAS(refusal(), "a second head: the run from line 9 on begins at t = 0.0625 s, before the run above it");
  write("0/forces.dat", first + head() + row(0.125, 8, 3));
  EXPECT_HAS(refusal(), "have the same start, and differ");
}

TEST_F(FlowFiles, SecondHeadOfOtherLayouts) {
  const std::string names =
      "(total_x total_y total_z) (pressure_x pressure_y pressure_z) (viscous_x viscous_y viscous_z)\n";
  const auto text = [&](const std::string& what) {
    std::string lines;
    for (const char* t : {"1", "2"})
      lines += "# " + what + "\n# CofR : (0 0 0)\n# Time " + names + t + " (3 2 1) (2 2 1) (1 0 0)\n" + t + ".5 (" + t +
               " 0 0) (" + t + " 0 0) (0 0 0)\n";
    return lines;
  };
  write("0/force.dat", text("Force"));
  write("0/moment.dat", text("Moment"));
  const FlowRecord record = read();
  EXPECT_EQ(record.forces->time, (std::vector<double>{1, 1.5, 2, 2.5}));
  EXPECT_EQ(record.forces->force[2], (Triple{3, 2, 1}));
  EXPECT_EQ(record.forces->force[3], (Triple{2, 0, 0}));
  EXPECT_EQ(record.forces->moment[3], (Triple{2, 0, 0}));
  write("p/0/p",
        "# Probe 0 (0 0 1)\n# Probe 1 (0 0 2)\n# Time 0 1\n0.1 10 20\n# Probe 0 (0 0 1)\n# Probe 1 (0 0 2)\n# Time\n"
        "0.2 30 40\n");
  EXPECT_EQ(read("p").points->rows.value, (std::vector<double>{10, 20, 30, 40}));
  // found by search: an older head set the number of probes anew below rows of another number
  write("p/0/p", "# x 0 0 0\n# y 0 0 0\n# z 1 2 3\n# Time\n0.1 10 20 30\n# x 0\n# y 0\n# z 1\n# Time\n0.2 30\n");
  EXPECT_HAS(refusal("p"), "a second head above this row, with other probes");
  write("p/0/p", "# Probe 0 (0 0 1)\n# Time 0\n0.1 10\n# Probe 1 (0 0 2)\n0.2 30 40\n");
  EXPECT_HAS(refusal("p"), "this is no head line");
}

TEST_F(FlowFiles, SecondHeadOfTablesIsNamed) {
  const std::string gauge = "time [s];force [N];forcex [N];forcey [N];forcez [N]\n";
  EXPECT_HAS(refusal((write("gauge.csv", gauge + "0;1;1;0;0\n0.1;2;2;0;0\n" + gauge + "0.2;3;3;0;0\n"), "gauge.csv")),
             "a second head: 'time [s]'");
  const std::string proteus = "time, p [ 0.5 0.2 0], p [ 0.5 0.4 0]\n";
  EXPECT_HAS(refusal((write("p.csv", proteus + "0, 1, 2\n" + proteus + "0.1, 1, 2\n"), "p.csv")), "a second head");
  write("INPUT", "TABLE 'WG01' HEADER 'wall.tbl' WATL DEP OUTPUT 000000.000 0.5 SEC\n&\n");
  write("wall.tbl", "% Watl Dep\n0.1 1.1\n0.2 1.2\n% Watl Dep\n0.1 1.1\n");
  EXPECT_HAS(refusal("wall.tbl"), "a second head");
}

TEST_F(FlowFiles, RunsBesideEachOtherAreJoinedByTheirStart) {
  write("0/forces.dat", head() + row(0.125, 8, 2) + row(0.25, 16, 4) + row(0.5, 1, 1));
  write("0/forces_0.25.dat", head() + row(0.375, 24, 6) + row(0.5, 40, 10));
  for (const char* name : {"", "0/forces.dat"}) {
    const FlowRecord record = read(name);
    ASSERT_EQ(record.forces->time.size(), 4U) << name;
    expect_row(*record.forces, 3, 0.5, 40, 10);
    EXPECT_EQ(record.files.size(), 2U);
    EXPECT_HAS(text_of(record), "forces_0.25.dat' goes on from t = 0.375 s, in place of 1 rows");
  }
  EXPECT_EQ(read("", "forces_0.25.dat").time().size(), 2U) << "named alone";
  fs::rename(folder_ + "/0/forces_0.25.dat", folder_ + "/0/forces_0.1.dat");
  EXPECT_HAS(refusal(), "have the same start, and differ");
  fs::remove(folder_ + "/0/forces.dat");  // the newer run alone
  EXPECT_EQ(read().time().size(), 2U);
  write("0.5/forces_0.5.dat", head() + row(0.5, 48, 12) + row(0.625, 64, 16));
  const FlowRecord record = read();
  ASSERT_EQ(record.forces->time.size(), 3U);
  expect_row(*record.forces, 1, 0.5, 48, 12);
}

TEST_F(FlowFiles, LaterRunsInFoldersBesideAreTold) {
  write("wall/0/forces.dat", head() + row(0.125, 8, 2) + row(0.25, 16, 4));
  write("wall/0.25/forces.dat", head() + row(0.375, 24, 6));
  write("wall/0.5/p", "# Probe 0 (0 0 0)\n# Time 0\n0.1 1\n");
  for (const char* name : {"wall/0", "wall/0/", "wall/0/forces.dat"})
    EXPECT_HAS(text_of(read(name)), "of the runs beside it, from 0.25 s, nothing is read") << name;
  for (const char* name : {"wall/0.25", "wall"})
    EXPECT_EQ(text_of(read(name, "forces.dat")).find("nothing is read"), std::string::npos) << name;
}

TEST_F(FlowFiles, MomentsOfRunsBesideAreTheirOwn) {
  const auto text = [](const std::string& what, double t, double f) {
    return "# " + what +
           "\n# CofR : (0 0 0)\n# Time total_x total_y total_z pressure_x pressure_y pressure_z viscous_x "
           "viscous_y viscous_z\n" +
           std::to_string(t) + " " + std::to_string(f) + " 0 0 " + std::to_string(f) + " 0 0 0 0 0\n";
  };
  write("0.5/force.dat", text("Force", 0.625, 1));
  write("0.5/moment.dat", text("Moment", 0.625, 10));
  write("0.5/force_0.75.dat", text("Force", 0.875, 2));
  write("0.5/moment_0.75.dat", text("Moment", 0.875, 20));
  const FlowRecord record = read();
  EXPECT_EQ(record.forces->force[1], (Triple{2, 0, 0}));
  EXPECT_EQ(record.forces->moment[1], (Triple{20, 0, 0}));
  EXPECT_EQ(record.files.size(), 4U);
}

TEST_F(FlowFiles, OutputsThatAreNoLoadAreNamedWithWhatToWrite) {
  const std::vector<std::array<std::string, 4>> outputs{
      {"a/0/surfaceFieldValue.dat",
       "# Region type : patch front\n# Faces : 12\n# Area : 4e-2\n# Time areaAverage(p)\n0 1200\n",
       "one number for a whole region", "function object forces"},
      {"b/0/faceSource.dat", "# Source : patch front\n# Faces : 12\n# Time\tareaAverage(p)\n0\t1200\n",
       "one number for a whole region", "surfaceFormat raw"},
      {"c/0/coefficient.dat", "# Force coefficients\n# dragDir : (1 0 0)\n# Time Cd Cl CmPitch\n0 1.1 0.2 0\n",
       "coefficients of the forces, without unit", "function object forces of the same patches"},
      {"d/0/forceCoeffs.dat", "# Force coefficients\n# Time Cm Cd Cl\n0 1.1 0.2 0\n", "coefficients of the forces",
       "function object forces of the same patches"},
      {"e/0/height.dat", "# Location 0 : (2 0 0.05)\n# Time hB hL\n0 0.4 0.4\n", "heights of the water's surface",
       "probes of p"},
      {"f/0/fieldMinMax.dat", "# Field minima and maxima\n# Time field min max\n0 p -1 2\n",
       "a table of OpenFOAM that is neither of forces nor of probes: 'Time field min max'", "surfaceFormat raw"},
      {"g/0.1/p_front.vtk", "# vtk DataFile Version 2.0\n", "in a format that is not read", "surfaceFormat raw"},
      {"h/0.1/wall_p.xy", "0.1 1200\n0.3 700\n", "a sampled set of OpenFOAM with 2 columns and no head",
       "with axis xyz"},
      {"i/0.1/wall.xy", "# distance p\n 0.1 1200\n", "a sampled set of OpenFOAM with the columns distance, p",
       "with axis xyz"},
      {"j/0.1/front.xy", "# x y z U_x U_y U_z\n 1 0.1 0 1 2 3\n", "none of the fields U_x, U_y, U_z is a pressure",
       "fields (p)"}};
  for (const auto& [name, text, what, instead] : outputs) {
    write(name, text);
    for (const std::string& path : {name.substr(0, 1), name}) {
      if (path == name && fs::path(name).extension() != ".dat") continue;
      const std::string said = refusal(path);
      EXPECT_HAS(said, what) << path;
      EXPECT_HAS(said, instead) << path;
    }
  }
  write("e/0/position.dat", "# Location 0 : (2 0 0.05)\n# Time p\n0 (0.4 0 0)\n");
  EXPECT_HAS(refusal("e"), "heights of the water's surface") << "not which of the two files";
  write("c/0/forces.dat", head() + row(0.1, 8, 2));
  EXPECT_EQ(read("c").time().size(), 1U) << "forces beside coefficients";
}

/// The load of faces along y at x = 1, of the files below a folder.
FlowLoad load_of(const FlowRecord& record, FlowQuantity quantity, const std::vector<std::string>& keys = {}) {
  FlowKeys source;
  source.landward = FlowAxis::plus_x;
  source.up = FlowAxis::plus_y;
  source.origin = {0., 0.};
  source.quantity = quantity;
  source.flow_density = 1000.;
  source.still_level = -1.;
  const Document document(keys);
  FlowContext context{"", &document};
  return understand(record, source, context);
}

TEST_F(FlowFiles, SurfacesInXyAreReadAsRawOnes) {
  const std::string rows = " 1 0.1 0.05 1200\n 1 0.3 0.05 700\n 1 0.5 0.05 150\n";
  for (const char* t : {"0.1", "0.2"}) {
    write(std::string("raw/") + t + "/p_front.raw", "# p FACE_DATA 3\n# x y z p\n" + rows);
    write(std::string("face/") + t + "/front.xy", "#      face_x  face_y  face_z  p\n" + rows + "\n\n");
    write(std::string("point/") + t + "/front.xy", "# point_x point_y point_z p\n" + rows);
    write(std::string("plain/") + t + "/front.xy", "#  x  y  z  p\n" + rows);
    write(std::string("set/") + t + "/wall_p.xy", rows);
    write(std::string("more/") + t + "/front.xy",
          "# distance x y z U_x p_rgh p\n0 1 0.1 0.05 9 8 1200\n1 1 0.3 0.05 9 8 700\n2 1 0.5 0.05 9 8 150\n");
  }
  const FlowRecord raw = read("raw"), face = read("face");
  EXPECT_TRUE(face.points->are_faces);
  EXPECT_EQ(face.points->at, raw.points->at);
  EXPECT_EQ(face.points->rows.value, raw.points->rows.value);
  EXPECT_EQ(face.time(), raw.time());
  EXPECT_NEAR(load_of(face, FlowQuantity::pressure).peak_force, load_of(raw, FlowQuantity::pressure).peak_force, 1e-9);
  EXPECT_NEAR(load_of(face, FlowQuantity::pressure).peak_force, 0.2 * (1200 + 700 + 150), 1e-9) << "midpoint rule";
  EXPECT_TRUE(read("point").points->are_vertices);
  for (const char* name : {"plain", "set", "more"}) {
    const FlowRecord record = read(name);
    EXPECT_EQ(record.points->at, raw.points->at) << name;
    EXPECT_EQ(record.points->rows.value, raw.points->rows.value) << name;
    EXPECT_FALSE(record.points->are_faces || record.points->are_vertices) << name << " does not say what they are";
    EXPECT_THROW(load_of(record, FlowQuantity::pressure), InputError) << "so it is asked for";
  }
  EXPECT_HAS(text_of(read("more")), "U_x is left out");
  write("set/0.2/wall_p.xy", rows + " 1 0.7 0.05\n");
  EXPECT_HAS(refusal("set"), "this row has 3 numbers in place of x, y, z, p");
  write("raw/0.2/p_front.raw", "# p FACE_DATA 3\n# x y z p\n" + rows + "# p FACE_DATA 6\n# x y z p\n" + rows);
  EXPECT_HAS(refusal("raw"), "a second head");
}

TEST_F(FlowFiles, FieldsThatAreNoPressureAreRefused) {
  write("0/alpha.water", "# Probe 0 (1 0 1)\n# Probe 1 (1 0 2)\n# Time 0 1\n0.1 1 0.5\n0.2 1 0.5\n");
  try {
    load_of(read(), FlowQuantity::pressure, {"to_base=\"none\""});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_HAS(std::string(error.what()), "the record's field is called 'alpha.water', which is no pressure");
  }
}

/// Forces of 1000 N landward at 0.2 m, and of `up` N at `behind` m behind the centre.
FlowLoad left_out(const std::string& text) {
  std::ofstream("forces.dat") << text;
  FlowKeys source;
  source.landward = FlowAxis::plus_x;
  source.up = FlowAxis::plus_y;
  source.origin = {0., 0.};
  source.thickness = 2.;
  source.still_force = 0.;
  source.vertical = FlowVertical::leave_out;
  const Document document;
  FlowContext context{"loads.wall", &document};
  const FlowLoad load = understand(read_flow("forces.dat", "", {}), source, context);
  fs::remove("forces.dat");
  return load;
}

TEST_F(FlowFiles, MomentOfAVerticalForceThatIsLeftOutIsWarnedOf) {
  const auto rows = [](double up, double behind) {
    const double moment = -1000. * 0.2 + up * behind;  // z of (r x F), which turns seaward
    return head() + "0 ((0 0 0) (0 0 0)) ((0 0 0) (0 0 0))\n1 ((1000 " + std::to_string(up) + " 0) (0 0 0)) ((0 0 " +
           std::to_string(moment) + ") (0 0 0))\n";
  };
  const FlowLoad front = left_out(rows(500., 0.)), base = left_out(rows(500., 0.13)), friction = left_out(rows(9., 0.));
  EXPECT_NEAR(*front.peak_arm, 0.2, 1e-12);
  EXPECT_NEAR(*base.peak_arm, 0.135, 1e-12);
  EXPECT_TRUE(friction.warnings.empty());
  for (const FlowLoad* load : {&front, &base}) {
    ASSERT_EQ(load->warnings.size(), 1U);
    EXPECT_EQ(load->warnings[0].name, "flow_vertical_moment");
    EXPECT_NEAR(load->warnings[0].value, 0.5, 1e-12);
    EXPECT_HAS(load->warnings[0].text(), "wrong by 0.5 m for each metre");  // 0.2 - 0.135 = 0.5 * 0.13
  }
  EXPECT_HAS(base.warnings[0].text(), "0.135 m");
}

TEST(FlowRows, HasNoCellBeyondItsOwn) {
  const FlowRows rows{2, {0., 1.}, {1., 2., 3., 4.}};
  EXPECT_EQ(rows.at(1, 1), 4.);
  EXPECT_THROW(rows.at(0, 2), std::out_of_range);
  EXPECT_THROW(rows.at(2, 0), std::out_of_range);
}

}  // namespace flow_files_test
}  // namespace upbead::test
