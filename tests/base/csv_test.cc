// Claim: a table of numbers is read whatever program wrote it; every kind of damage is reported with line and column.
#include "base/csv.h"

#include <gtest/gtest.h>
#include <unistd.h>
#include <zlib.h>

#include <filesystem>
#include <fstream>

#include "base/header_words.h"
#include "base/text.h"

namespace upbead {
namespace csv_test {

class Csv : public testing::Test {
 protected:
  Csv() : path_((std::filesystem::temp_directory_path() / ("upbead-" + std::to_string(getpid()) + ".csv")).string()) {}
  ~Csv() override { std::filesystem::remove(path_); }

  CsvTable read(const std::string& text) const {
    std::ofstream(path_, std::ios::binary) << text;
    return read_csv(path_, {"case.toml", 3, 1});
  }

  /// The messages without the path of the file.
  std::string refusal(const std::string& text) const {
    Diagnostics mistakes;
    try {
      const CsvTable table = read(text);
      for (std::size_t c = 0; c < table.columns.size(); ++c) try {
          table.numbers(c);
        } catch (const InputError& error) {
          mistakes.add(error.diagnostics());
        }
    } catch (const InputError& error) {
      mistakes.add(error.diagnostics());
    }
    std::string messages;
    for (Diagnostic mistake : mistakes) {
      if (mistake.place.file == path_) mistake.place.file = "f";
      mistake.cure.clear();
      messages += (messages.empty() ? "" : "\n") + to_string(mistake);
    }
    return messages;
  }

  std::string path_;
};

TEST_F(Csv, ReadsColumns) {
  const CsvTable table = read("time, force,\"p\"\n0,1e6,-2.5\n\n+0.5 ,\t2,3\n");
  EXPECT_EQ(table.names, (std::vector<std::string>{"time", "force", "p"}));
  EXPECT_EQ(table.columns, (std::vector<std::vector<double>>{{0., 0.5}, {1e6, 2.}, {-2.5, 3.}}));
  EXPECT_EQ(table.lines, (std::vector<int>{2, 4}));
  EXPECT_EQ(table.place(1).line, 4);
}

TEST_F(Csv, ReadsUnitsInBracketsOfFullWidth) {
  const CsvTable table = read("時間（秒）,波力（kN/m）,圧力［ｋＰａ］,力kN/m\n0,1,2,3\n1,2,3,4\n");
  EXPECT_EQ(table.names, (std::vector<std::string>{"時間", "波力", "圧力", "力kN/m"}));
  EXPECT_EQ(table.units, (std::vector<std::string>{"秒", "kN/m", "ｋＰａ", ""}));
  EXPECT_EQ(unit_at_end("力kN/m").value().known.si, "N/m");
  EXPECT_FALSE(unit_at_end("µm")) << "no name, but a unit";
}

TEST_F(Csv, ReadsWhatSpreadsheetsWrite) {
  const CsvTable table = read("\xEF\xBB\xBFtime,force\r\n0,1\r\n1,2");
  EXPECT_EQ(table.names, (std::vector<std::string>{"time", "force"}));
  EXPECT_EQ(table.columns[1], (std::vector<double>{1., 2.}));
}

TEST_F(Csv, NamesWhatIsNoText) {
  using namespace std::string_literals;
  const std::pair<std::string, std::string> rows[] = {{"PK\3\4\x14\0"s, "is a workbook of a spreadsheet (.xlsx, .ods)"},
                                                      {"\x89HDF\r\n\x1a\n\0"s, "is an HDF5 file"},
                                                      {"%PDF-1.7\n1 2\n"s, "is a PDF document"},
                                                      {"t,p\n0,1\n\0\0"s, "holds zero bytes: it is no text"}};
  for (const auto& [bytes, message] : rows) {
    EXPECT_NE(refusal(bytes).find(message), std::string::npos) << refusal(bytes);
    EXPECT_EQ(refusal(bytes).find("case.toml:3:1: "), 0U);
  }
}

TEST_F(Csv, MessagesHoldNoRawBytes) {
  EXPECT_EQ(in_quotes("t\xFF\xB0 \xC2\xB0"), "'t?? \u00B0'");
  EXPECT_EQ(refusal("t;\xB0\n0;x\xFC\n1;2\n"), "f:2:3: 'x\u00FC' is not a number (column \u00B0)");
}

TEST_F(Csv, FindsNamesAndUnitsAboveTheNumbers) {
  struct Row {
    std::string text;
    std::vector<std::string> names, units;
  };
  const Row rows[] = {
      {"# time (ms),force (kN/m)\n# filtered at 300 Hz, run 7\n0,0\n50,100\n", {"time", "force"}, {"ms", "kN/m"}},
      {"\t\tRun 7\r\nForce on a wall\r\n\r\nTime     F_KN_M    Eta_M\r\n\r\n0.00  0.0  0.1\r\n0.05 10.0  0.2\r\n",
       {"Time", "F_KN_M", "Eta_M"},
       {"", "", ""}},
      {"      Time     Force\n       (s)    (N/m)\n  0.0  0.0E+00\n  0.5  0.1E+05\n", {"Time", "Force"}, {"s", "N/m"}},
      {"#YY  MM DD hh mm  WVHT   DPD\n#yr  mo dy hr mn     m   sec\n2026 01 01 00 00  2.10  8.30\n",
       {"YY", "MM", "DD", "hh", "mm", "WVHT", "DPD"},
       {"yr", "mo", "dy", "hr", "mn", "m", "sec"}},
      {"%\n%\n% Run:one  Table:wall\n%\n%   Time     hs      tp$\n%   [ ]    [m]   [sec]\n%\n20260111.0  1.71  12.9\n",
       {"Time", "hs", "tp$"},
       {"", "m", "sec"}},
      {"sep=;\n\"time (s)\";\"p \"\"1\"\" (kPa)\"\n\"0\";\"0\"\n", {"time", "p \"1\""}, {"s", "kPa"}},
      {"time;p1;trigger\ns;kPa;V\n0;0;1\n", {"time", "p1", "trigger"}, {"s", "kPa", "V"}},
      {"Time (s)  Force on the wall (kN/m)\n--------  -----\n0.0  1\n0.1  2\n",
       {"Time", "Force on the wall"},
       {"s", "kN/m"}},
      {"0.00 1.5\r0.02 2.5\r", {"column 1", "column 2"}, {"", ""}}};
  for (const Row& row : rows) {
    const CsvTable table = read(row.text);
    EXPECT_EQ(table.names, row.names) << row.text;
    EXPECT_EQ(table.units, row.units) << row.text;
  }
}

TEST_F(Csv, RefusesNamesThatCannotBeTold) {
  EXPECT_EQ(refusal("time (s),F (N/m)\ntime (ms),F (kN/m)\n0,1\n"),
            "f:2:1: lines 1 and 2 both may hold the names of the columns");
  EXPECT_EQ(refusal("# P,F\n# wall,run\n0.5,1.5\n"), "f:2:1: lines 1 and 2 both may hold the names of the columns");
  EXPECT_EQ(refusal("Time (ms) Force on wall (kN/m)\n0.0 1\n"),
            "f:1:1: 'Time (ms) Force on wall (kN/m)' does not name each of 2 columns");
  EXPECT_EQ(refusal("Unit: kPa\ntime,p\n0,1\n"), "f:1:1: 'Unit: kPa' gives a unit, but not by column");
  EXPECT_EQ(refusal("time (s),p\nms,kPa\n0,1\n"),
            "f:2:1: column 'time' has the unit 's' behind its name and 'ms' below it");
  EXPECT_EQ(
      refusal("Run on the plate; number 12\n05/11/2026\t1 187\t0,32\t0\t1,10\t\n"),
      "f:2:1: '05/11/2026 1 187 0,32 0 1,10' may be columns, or numbers with blanks in them: no line names columns");
  EXPECT_EQ(refusal("05/11/2026;0,5;2\n05/11/2026;0,6;3\n"),
            "f:1:1: some columns hold words, and no line above them names the columns");
  EXPECT_EQ(refusal("2 887\t\n"),
            "f:1:1: '2 887' may be columns, or numbers with blanks in them: no line names columns");
  EXPECT_EQ(refusal("0.1,1,250\n0.2,1,480\n"),
            "f:1:1: '0.1,1,250' may be columns, or numbers with commas in them: no line names columns");
}

TEST_F(Csv, AFileHasOneDecimalSign) {
  const CsvTable german = read("Zeit (s);Kraft (kN/m)\n0,15;980\n0,20;1.250\n0,25;1.480.000\n");
  EXPECT_EQ(german.columns, (std::vector<std::vector<double>>{{0.15, 0.2, 0.25}, {980., 1250., 1480000.}}));
  EXPECT_EQ(german.layout, "columns separated by semicolons, decimal commas, names in line 1, points group thousands");
  EXPECT_EQ(read("t;p\n0;1.000,5\n").columns[1][0], 1000.5);
  EXPECT_EQ(read("t\tp\n0.5\t1,250\n").columns[1][0], 1250.);
  EXPECT_EQ(read("t;p\n0;1 250,5\n").columns[1][0], 1250.5);
  EXPECT_EQ(read("t,p\n0,1.250\n").columns[1][0], 1.25);
  EXPECT_EQ(refusal("t;p\n1;1.250\n2;850\n"),
            "f:2:3: '1.250' may be 1.250 or 1250: no cell tells whether a point is the decimal sign or groups "
            "thousands (column p)");
  EXPECT_EQ(refusal("t;p\n0,20;1.25\n"), "f:2:6: '1.25' has a decimal point in a file of decimal commas (column p)");
  EXPECT_NE(refusal("t;p;q\n0.5;1,250;0,5\n").find("(column p)"), std::string::npos);
}

TEST_F(Csv, TellsDamage) {
  EXPECT_EQ(refusal(""), "f: an empty file");
  EXPECT_EQ(refusal("a,b\n"), "f: no row of numbers below the header");
  EXPECT_EQ(refusal("1,2\n3,4\n"),
            "f:1:1: '1,2' may be columns, or numbers with commas in them: no line names columns");
  EXPECT_EQ(refusal("a,b\n1, x\n"), "f:2:4: 'x' is not a number (column b)");
  EXPECT_EQ(refusal("a,b\n1,2.0.0\n"), "f:2:3: '2.0.0' is not a number (column b)");
  EXPECT_EQ(refusal("a,b\n,2\n"), "f:2:1: an empty cell (column a)");
  EXPECT_EQ(refusal("a,b\n1\n"), "f:2:1: cells in this row: 1, in the header: 2");
  EXPECT_EQ(refusal("a,b\n1,2,3\n"), "f:2:1: cells in this row: 3, in the header: 2");
  EXPECT_EQ(refusal("a,b\n1,inf\n"), "f:2:3: 'inf' is not finite (column b)");
  EXPECT_EQ(refusal("a,b\n1,-nan\n"), "f:2:3: '-nan' is not finite (column b)");
  EXPECT_EQ(refusal("a,b\n1,1e999\n"), "f:2:3: '1e999' is beyond the range of a number (column b)");
}

TEST_F(Csv, ALongCellIsNoLongMessage) {
  const std::string cell(5'000'000, 'x');
  EXPECT_LT(refusal("time,force\n0,0\n0.1," + cell + "\n").size(), 150U);
  EXPECT_LT(refusal("time," + cell + "\n0,y\n").size(), 150U);
}

TEST_F(Csv, RefusesWhatWouldFillTheMemory) {
  std::string header = "time", row = "0";
  for (int i = 0; i < 10'000; ++i) {
    header += ",p";
    row += ",1";
  }
  EXPECT_EQ(refusal(header + "\n" + row + "\n"),
            "f:1:1: 10001 columns; at most 10000 are read, more than any record has");
  EXPECT_EQ(refusal("a,b\n" + row + "\n"), "f:2:1: cells in this row: 10001, in the header: 2");
  const CsvTable blank = read("a,b\n1,2\n" + std::string(20'000'000, '\n') + "3,4\n");
  EXPECT_EQ(blank.n_rows(), 2U);
  EXPECT_LT(blank.columns[0].capacity(), 10'000'000U);
}

TEST_F(Csv, UnitsStandBehindASlashToo) {
  const CsvTable table = read("t / s;p1/kPa;F/kN/m;kN/m;F_T/P;G / MN/m\n0;1;2;3;4;5\n");
  EXPECT_EQ(table.names, (std::vector<std::string>{"t", "p1", "F", "kN/m", "F_T/P", "G"}));
  EXPECT_EQ(table.units, (std::vector<std::string>{"s", "kPa", "kN/m", "", "", "MN/m"}));
}

TEST_F(Csv, RefusesWhatNoQuantityCanBe) {
  // found by tests/fuzz: the slope of a history from 0 to 1e308 overflows
  EXPECT_EQ(refusal("time,force\n0,0\n1,1e308\n"),
            "f:3:3: '1e308' is larger than any quantity in SI units (column force)");
  EXPECT_EQ(refusal("time,force\n0,-1.1e50\n"),
            "f:2:3: '-1.1e50' is larger than any quantity in SI units (column force)");
  EXPECT_EQ(refusal("time,force\n0,1e50\n"), "");
}

TEST_F(Csv, ReadsWhatIsLeftOfADecayAsZero) {
  EXPECT_EQ(read("t,p\n1e-320,-4.9e-324\n").columns, (std::vector<std::vector<double>>{{0.}, {0.}}));
  EXPECT_EQ(read("t,p\n1e-49,0\n").columns[0][0], 1e-49);
}

TEST_F(Csv, ReadsWhatLaboratoriesWrite) {
  const std::vector<std::vector<double>> columns{{0., 0.5}, {1.25, -2e3}};
  const std::vector<std::string> names{"time", "p1"}, units{"s", "kPa"};
  for (const std::string text :
       {"time (s),p1 (kPa)\n0,1.25\n0.5,-2e3\n", "time [s];p1 [kPa]\n0;1,25\n0,5;-2e3\n",
        "time (s)\tp1 (kPa)\n0\t1,25\n,5\t-2e3\n", "\"time (s)\",\"p1 (kPa)\"\r\n0,1.25\r\n0.5,-2e3\r\n",
        "time;p1\n[s];[kPa]\n0,0;1,25\n0,50;-2,0e3\n", "time;p1\ns;kPa\n0.0;1.25\n0.50;-2.0e3\n",
        "# run 7\n% of 9\n\ntime (s),p1 (kPa)\n0,1.25\n0.5,-2000",
        "# run 7\n# time (s),p1 (kPa)\n0,1.25\n0.5,-2000\n"}) {
    const CsvTable table = read(text);
    EXPECT_EQ(table.names, names) << text;
    EXPECT_EQ(table.units, units) << text;
    EXPECT_EQ(table.columns, columns) << text;
  }
  EXPECT_EQ(read("a,b\n1,2\n").units, (std::vector<std::string>{"", ""}));
  EXPECT_EQ(read("load (slow) (N),b\n1,2\n").names[0], "load (slow)");
  EXPECT_EQ(read("# 1,2\nt,p\n1,2\n").lines, (std::vector<int>{3}));
}

TEST_F(Csv, TellsWhereOtherDialectsAreDamaged) {
  EXPECT_EQ(refusal("t;p\n0;1\n0,1,2;2\n"), "f:3:1: '0,1,2' is not a number (column t)");
  EXPECT_EQ(refusal("t,p\n1,5\n0,1,2\n"), "f:3:1: cells in this row: 3, in the header: 2");
  EXPECT_EQ(refusal("t;p\n0;1\ns;kPa\n"),
            "f:3:1: 's' is not a number (column t)\nf:3:3: 'kPa' is not a number (column p)");
}

TEST_F(Csv, ReadsPackedTables) {
  const std::string text = "t,p\n0,1\n0.5,2\n";
  const gzFile file = gzopen(path_.c_str(), "wb");
  gzwrite(file, text.data(), static_cast<unsigned>(text.size()));
  gzclose(file);
  EXPECT_EQ(read_csv(path_, {}).columns, (std::vector<std::vector<double>>{{0., 0.5}, {1., 2.}}));
  std::ifstream packed(path_, std::ios::binary);
  std::string bytes((std::istreambuf_iterator<char>(packed)), {});
  EXPECT_NE(refusal(bytes.substr(0, bytes.size() - 9)).find("is damaged where it is packed by gzip"),
            std::string::npos);
  bytes[bytes.size() - 6] ^= 1;
  EXPECT_NE(refusal(bytes).find("is damaged where it is packed by gzip"), std::string::npos);
}

TEST_F(Csv, TellsAColumnOnce) {
  std::string text = "t,a\n1,1\n";
  for (int i = 0; i < 1000; ++i) text += "2,x\n";
  EXPECT_EQ(refusal("a\nx\n1\ny\n"), "f:2:1: 'x' is not a number (column a), one of 2 such cells");
  EXPECT_EQ(refusal(text + "y,0\n"),
            "f:1003:1: 'y' is not a number (column t)\nf:3:3: 'x' is not a number (column a), one of 1000 such cells");
}

TEST_F(Csv, TellsAMissingFileWhereItWasNamed) {
  const std::pair<std::string, std::string> rows[] = {
      {"/nowhere/f.csv", "cannot read '/nowhere/f.csv'; check the path and the rights"},
      {"/tmp", "'/tmp' is a folder; name a file in it"}};
  for (const auto& [path, message] : rows) try {
      read_csv(path, {"case.toml", 3, 1});
      FAIL() << path;
    } catch (const InputError& error) {
      EXPECT_EQ(error.what(), "case.toml:3:1: " + message);
    }
}

}  // namespace csv_test
}  // namespace upbead
