// Claim: the time is the column whose header says so, wherever it stands and in whatever language; a counter is
// neither a time nor a value; an ambiguous layout is refused, never guessed.
#include "case/records/record_layout.h"

#include "base/csv.h"
#include "good_case.h"

namespace upbead::test {

namespace record_layout_test {

struct Row {
  std::string header, rows;
  int time;                     ///< column; -1: none
  std::vector<double> seconds;  ///< first two
  std::vector<std::size_t> values;
};

std::string refusal(const std::string& text) {
  std::ofstream("t.csv") << text;
  try {
    const CsvTable table = read_csv("t.csv", {});
    times_of(table, layout_of(table));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

class RecordLayouts : public InFolder {};

TEST_F(RecordLayouts, FindTheTime) {
  const std::vector<Row> rows{
      {"Part;Time [s];Press_0 [Pa];Press_1 [Pa]", "0;0;1;2\n1;0,01;3;4\n", 1, {0., 0.01}, {2, 3}},
      {"Time [s];Part;Press_0 [Pa]", "0;0;1\n0,01;1;3\n", 0, {0., 0.01}, {2}},
      {"Step,t,P", "100,0,1\n200,0.5,3\n", 1, {0., 0.5}, {2}},
      {"#;Zeit / ms;p1 / kPa", "1;0;1\n2;10;3\n", 1, {0., 0.01}, {2}},
      {"Index\tTemps (s)\tForce (kN/m)", "1000\t0\t1\n1001\t0,5\t2\n", 1, {0., 0.5}, {2}},
      {"Lfd. Nr.;Messzeit [ms];Kraft [kN/m]", "1;0;1\n2;10;3\n", 1, {0., 0.01}, {2}},
      {"No.,TIME (SEC),P", "1,0,1\n2,0.5,3\n", 1, {0., 0.5}, {2}},
      {",time_ms,P", "0,0,1\n1,10,3\n", 1, {0., 0.01}, {2}},
      {"P,Elapsed Time (s)", "1,0\n3,0.5\n", 1, {0., 0.5}, {0}},
      {"Time [s];Real time [s];P", "0;77;1\n0,5;78,5;3\n", 0, {0., 0.5}, {2}},
      {"CPU time (s),Simulation time (s),P", "3,0,1\n9,0.5,3\n", 1, {0., 0.5}, {2}},
      {"t,Time (s),P", "0,0,1\n1,0.5,3\n", 1, {0., 0.5}, {2}},
      {"Time;T;P", "0;280;1\n0,5;281,5;3\n", 0, {0., 0.5}, {1, 2}},
      {"Time step;Time;P", "0;0;1\n1;0,5;3\n", 1, {0., 0.5}, {2}},
      {"Time  1 - default sample rate [s];p1;Time  2 - fast [s];p2", "0;1;0;2\n0,5;3;0,5;4\n", 0, {0., 0.5}, {1, 3}},
      {"Sample time,P", "0,1\n0.5,3\n", 0, {0., 0.5}, {1}},
      {"N,P (kN/m),[ms]", "1,1,0\n2,3,10\n", 2, {0., 0.01}, {1}},
      {"msec,P", "0,1\n10,3\n", 0, {0., 0.01}, {1}},
      {"時間 (s),P", "0,1\n0.5,3\n", 0, {0., 0.5}, {1}},
      {"whatever,P", "0,1\n0.5,3\n", 0, {0., 0.5}, {1}},
      {"step,P", "0,1\n0.5,3\n", 0, {0., 0.5}, {1}}};  // no counter, as its values are not consecutive
  for (const Row& row : rows) {
    SCOPED_TRACE(row.header);
    std::ofstream("t.csv") << "\xEF\xBB\xBF" << row.header << "\r\n" << row.rows;
    const CsvTable table = read_csv("t.csv", {});
    const RecordLayout layout = layout_of(table);
    ASSERT_TRUE(layout.time);
    EXPECT_EQ(static_cast<int>(*layout.time), row.time);
    const std::vector<double> time = times_of(table, layout);
    for (std::size_t i = 0; i < 2; ++i) EXPECT_DOUBLE_EQ(time[i], row.seconds[i]);
    EXPECT_EQ(layout.values, row.values);
  }
}

TEST_F(RecordLayouts, RefuseWhatMayBeEither) {
  EXPECT_EQ(
      refusal("Part,P\n0,1\n1,2\n"),
      "t.csv:1:1: no column says that it is the time, and the first one, 'Part', is a counter; call the column of "
      "times 'time (s)'; a load by transducers may have sampling_rate in its place");
  EXPECT_EQ(refusal("Time,Time,P\n0,0,1\n1,2,2\n"),
            "t.csv:3:1: the columns 'Time' and 'Time' both are times, and differ: 1 s and 2 s; keep the time that is "
            "meant, or call it 'time' and the other one otherwise");
  EXPECT_EQ(refusal("Time,Time,P\n0,0,1\n1,1,2\n"), "");
  EXPECT_EQ(refusal("X,Y (s),P\n0,0,1\n1,2,2\n"),
            "t.csv:1:1: is the time the first column, 'X', or 'Y', which has a unit of time?; call it 'time (s)'");
  EXPECT_NE(refusal("time (parsec),P\n0,0\n1,2\n").find("the unit 'parsec' of column 'time' is none of a time"),
            std::string::npos);
}

TEST_F(RecordLayouts, TellWhatIsLeftOut) {
  std::ofstream("t.csv") << "Part;Time [s];Real time [s];P\n0;0;7;1\n1;0,5;8,5;3\n";
  const CsvTable table = read_csv("t.csv", {});
  RecordNotes notes;
  note_layout(table, layout_of(table), notes);
  ASSERT_EQ(notes.left_out.size(), 2U);
  EXPECT_EQ(notes.left_out[0].what + ": " + notes.left_out[0].why,
            "column 'Part' of t.csv: a counter; the time is 'Time'");
  EXPECT_EQ(notes.left_out[1].what + ": " + notes.left_out[1].why,
            "column 'Real time' of t.csv: another time; the time is 'Time'");
  EXPECT_TRUE(notes.warnings.empty());
}

TEST_F(RecordLayouts, TimesThatCountWithoutAUnitAreDoubted) {
  for (const std::string header : {"t", "t (s)"}) {
    std::ofstream file("t.csv");
    file << header << ",P\n";
    for (int i = 0; i < 20; ++i) file << i << ",1\n";
    file.close();
    const CsvTable table = read_csv("t.csv", {});
    RecordNotes notes;
    note_layout(table, layout_of(table), notes);
    ASSERT_EQ(notes.warnings.size(), header == "t" ? 1U : 0U);
    if (header == "t") {
      EXPECT_EQ(notes.warnings[0].name, "time_counts");
    }
  }
}

TEST(HeaderWords, SayWhatAColumnIs) {
  EXPECT_EQ(header_says("F_T", "kN/m"), HeaderSays::nothing);
  EXPECT_EQ(header_says("time", "kN/m"), HeaderSays::nothing);
  EXPECT_EQ(header_says("dt", "s"), HeaderSays::nothing);
  EXPECT_EQ(header_says("Rise time", "s"), HeaderSays::nothing);
  EXPECT_EQ(header_says("TimeStep", ""), HeaderSays::counter);
  EXPECT_EQ(header_says("Timestamp", ""), HeaderSays::another_clock);
  EXPECT_EQ(header_says("s", ""), HeaderSays::nothing);
  EXPECT_EQ(header_says(std::string(1'000'000, 't'), ""), HeaderSays::nothing);
}

}  // namespace record_layout_test
}  // namespace upbead::test
