// Claim: a record is read by its own names, units and times, or refused; no unit, name or mark for a missing value
// changes a number silently.
#include "case/records/record_table.h"

#include <cmath>

#include "case/cfd/flow_tables.h"
#include "case/records/gauge_load.h"
#include "case/records/history_load.h"
#include "good_case.h"

namespace upbead::test {

namespace record_table_test {

constexpr double g = 9.80665;  // m/s2, standard gravity

class Records : public InFolder {
 protected:
  /// Largest value of a history, in SI units, and what was noted.
  static double peak(const std::string& text, RecordNotes& notes, LoadKind kind = LoadKind::force,
                     const std::string& name = "f.csv") {
    std::ofstream(name, std::ios::binary) << text;
    notes = read_history(name, {"case.toml", 1, 1}, kind, 1., {}).notes;
    return notes.read.at(0).extreme;
  }
  static double peak(const std::string& text, LoadKind kind = LoadKind::force) {
    RecordNotes notes;
    return peak(text, notes, kind);
  }

  static std::string refusal(const std::string& text, LoadKind kind = LoadKind::force) {
    try {
      peak(text, kind);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  static Gauges gauges(const std::string& text, const std::map<std::string, double>& place,
                       std::optional<double> rate = std::nullopt) {
    std::ofstream("g.csv", std::ios::binary) << text;
    GaugeKeys source;
    source.place = place;
    source.sampling_rate = rate;
    return read_gauges(source, "g.csv", "loads.wall", Document()).gauges;
  }
};

TEST_F(Records, TakeTheUnitAtTheEndOfAName) {
  for (const std::string name :
       {"force_kN/m", "F_KN_M", "F kN/m", "F.kN_per_m", "U kN m-1", "波力kN/m", "波力（ｋＮ／ｍ）"})
    EXPECT_EQ(peak("time_ms," + name + "\n0,0\n50,100\n100,0\n"), 1e5) << name;
  EXPECT_DOUBLE_EQ(peak("time_s,acc_g\n0,0\n0.05,0.1\n0.1,0\n", LoadKind::acceleration), 0.1 * g);
  EXPECT_DOUBLE_EQ(peak("time_s,acc_gal\n0,0\n0.05,10\n0.1,0\n", LoadKind::acceleration), 0.1);
  RecordNotes notes;
  peak("time_ms,F_KN_M,Eta_M\n0,0,1\n50,100,2\n100,0,3\n", notes);
  EXPECT_EQ(notes.read[0].unit, "kN/m, by the end of its name");
  EXPECT_EQ(notes.read[0].extreme_time, 0.05);
  EXPECT_EQ(notes.read[0].samples, 3);
  for (const std::string name : {"p1_kPa", "P1 kPa", "p1_KPA", "p1 (kPa)", "p1 / kPa"}) {
    const std::string text = "time_ms," + name + ",x\n0,0,0\n20,5,1\n40,10,2\n100,0,0\n";
    EXPECT_EQ(gauges(text, {{name, 0.2}}).pressure[0][2], 1e4) << name;
    EXPECT_EQ(gauges(text, {{name.substr(0, 2), 0.2}}).pressure[0][2], 1e4) << name;
  }
}

TEST_F(Records, RefuseAUnitThatStandsWhereItIsNotRead) {
  for (const std::string name : {"{kN/m}", "<kN/m>", "kN/m F", "ForceKN", "in MN per metre", "F_kNm", "kPa p1",
                                 "p1:kPa", "p1kPa", "kiloPascal", "mWS"})
    EXPECT_NE(refusal("t (s)," + name + "\n0,0\n1,4\n2,0\n").find("a unit that is not read there"), std::string::npos)
        << name;
  for (const std::string name :
       {"F", "impact", "Knee", "PMN1x", "wkNx", "force_total", "MNx", "MN1", "KN-2", "F at 50 kPa"})
    EXPECT_EQ(peak("t (s)," + name + "\n0,0\n1,4\n2,0\n"), 4.) << name;
}

TEST_F(Records, AskForAUnitThatIsNoneOfTheQuantity) {
  EXPECT_EQ(
      refusal("time_s,force_kN\n0,0\n0.05,100\n0.1,0\n"),
      "f.csv: the name 'force_kN' ends in the unit 'kN', which is none of what it should hold, N/m; write one of " +
          units_like("N/m") + ", in brackets behind the name");
  EXPECT_NE(
      refusal("time_s,acc_G\n0,0\n0.05,1\n0.1,0\n", LoadKind::acceleration).find("may be the unit g or a point G"),
      std::string::npos);
  for (const std::string name : {"F_T", "x_s", "F_min", "F_m", "probe.2", "row_1"})  // parts of names
    EXPECT_EQ(peak("time_s," + name + "\n0,0\n0.05,100\n0.1,0\n"), 100.) << name;
}

TEST_F(Records, RefuseANameOfTwoColumns) {
  const std::string text = "t (s),ch (kPa),ch (kPa),F\n0,0,0,1\n0.02,10,80,2\n0.1,0,0,3\n";
  try {
    gauges(text, {{"ch", 0.2}});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("'g.csv' has 2 columns 'ch'"), std::string::npos) << error.what();
  }
  EXPECT_EQ(refusal("t,F,F\n0,1,2\n1,3,4\n"),
            "f.csv:1:1: two columns are called 'F'; keep the one that is meant, or give each a name of its own");
  EXPECT_EQ(gauges(text, {{"F", 0.2}}).pressure[0][2], 3.);
}

TEST_F(Records, RefuseMarksForMissingValues) {
  for (const std::string mark : {"99.00", "999", "-9999", "9999.9", "-999.25", "1e30", "-99", "9.969e36"})
    EXPECT_NE(refusal("t,F\n0,0\n0.1,7.5\n0.2," + mark + "\n0.3,4\n0.4," + mark + "\n").find("f.csv:4:1: "),
              std::string::npos)
        << mark;
  EXPECT_NE(refusal("t,F\n0,0\n0.1,7.5\n0.2,99\n0.3,4\n0.4,99\n")
                .find("99 stands for a missing value (column F, one of 2 such cells)"),
            std::string::npos);
  EXPECT_EQ(peak("t,F\n0,0\n0.1,99\n0.2,0\n"), 99.);  // a triangle
  EXPECT_EQ(peak("t,F\n0,0\n0.1,60\n0.2,99\n0.3,50\n"), 99.);
  EXPECT_EQ(peak("t,F\n0,0\n98,1\n99,2\n999,1\n"), 2.);  // times
}

TEST_F(Records, NeedNumbersOnlyInColumnsThatAreUsed) {
  const std::string text =
      "Date,Time,t (s),p1 (kPa),p2 (kPa),p3 (kPa)\n05/11/2026,10:30:00,0,0,0,\n05/11/2026,10:30:00,0.02,5,3,-\n"
      "05/11/2026,10:30:00,0.1,0,0,0\n";
  EXPECT_EQ(gauges(text, {{"p1", 0.2}, {"p2", 0.3}}).pressure[1], (std::vector<double>{0., 3e3, 0.}));
  try {
    gauges(text, {{"p1", 0.2}, {"p3", 0.3}});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("g.csv:2:27: an empty cell (column p3), one of 2 such cells"),
              std::string::npos);
  }
  EXPECT_NE(refusal("Time,F\n10:30:00,0\n10:30:01,1\n").find("'10:30:00' is not a number (column Time)"),
            std::string::npos);
}

TEST_F(Records, KeepTheirOwnTimesBesideASamplingRate) {
  const Gauges own = gauges("t (s),p (Pa)\n5,1\n5.011,2\n5.02,3\n", {{"p", 0.}}, 100.);
  EXPECT_EQ(own.time, (std::vector<double>{5., 5.011, 5.02}));
  std::string text = "t (s),p (Pa)\n";
  for (int i = 0; i < 1000; ++i)
    text += "5." + std::to_string(100 + i / 10).substr(1) + "," + std::to_string(i % 7) + "\n";
  const Gauges rounded = gauges(text, {{"p", 0.}}, 1000.);
  EXPECT_DOUBLE_EQ(rounded.time[17], 5.017);
  const Gauges none = gauges("p (Pa),q\n1,2\n2,3\n", {{"p", 0.}}, 100.);
  EXPECT_EQ(none.time, (std::vector<double>{0., 0.01}));
}

TEST_F(Records, OfStrongMotionAreRead) {
  const std::string head = "SOME RECORD\nPLACE 01/02/03, STATION, 090\nACCELERATION IN UNITS OF G\n";
  const std::string rows = "   0.1E-01   0.2E-01   0.3E-01   0.1E-01   0.0E+00\n  -0.1E-01  -0.2E-01  -0.1E-01\n";
  for (const std::string line :
       {"8    0.0100    NPTS, DT\n", "NPTS=    8, DT=   .0100 SEC,\n", "8  1.0E-02  NPTS, DT\n"}) {
    RecordNotes notes;
    EXPECT_DOUBLE_EQ(peak(head + line + rows, notes, LoadKind::acceleration), 0.03 * g);
    EXPECT_DOUBLE_EQ(notes.read[0].extreme_time, 0.02);
    EXPECT_EQ(notes.read[0].samples, 8);
  }
  EXPECT_NE(refusal(head + "9    0.0100    NPTS, DT\n" + rows, LoadKind::acceleration)
                .find("NPTS tells of 9 samples, the record has 8"),
            std::string::npos);
  EXPECT_NE(refusal("a\nb\nc\n8 0.01 NPTS, DT\n" + rows, LoadKind::acceleration).find("does not tell its unit"),
            std::string::npos);
  EXPECT_NE(refusal(head + "8    0.0100    NPTS, DT\n" + rows).find("none of what it should hold, N/m"),
            std::string::npos);
}

TEST_F(Records, OfDualSphysicsHaveOneDecimalSign) {
  const auto force = [](const std::string& second) {
    std::ofstream("d.csv") << "time [s];force [N];forcex [N];forcey [N];forcez [N]\n0,10;100,5;100,5;0;0\n0,20;"
                           << second << ";" << second << ";0;0\n";
    FlowRecord record;
    read_dualsphysics("d.csv", {"case.toml", 1, 1}, record);
    return record.forces->force.at(1)[0];
  };
  EXPECT_EQ(force("1.250"), 1250.);
  EXPECT_EQ(force("1250,25"), 1250.25);
  EXPECT_THROW(force("1.25"), InputError);
}

}  // namespace record_table_test
}  // namespace upbead::test
