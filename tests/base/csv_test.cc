// Claim: a table of numbers is read whatever program wrote it; every kind of damage is reported with line and column.
#include "base/csv.h"

#include <gtest/gtest.h>
#include <unistd.h>
#include <zlib.h>

#include <filesystem>
#include <fstream>

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

TEST_F(Csv, ReadsWhatSpreadsheetsWrite) {
  const CsvTable table = read("\xEF\xBB\xBFtime,force\r\n0,1\r\n1,2");
  EXPECT_EQ(table.names, (std::vector<std::string>{"time", "force"}));
  EXPECT_EQ(table.columns[1], (std::vector<double>{1., 2.}));
}

TEST_F(Csv, TellsDamage) {
  EXPECT_EQ(refusal(""), "f: an empty file");
  EXPECT_EQ(refusal("a,b\n"), "f: no row of numbers below the header");
  EXPECT_EQ(refusal("1,2\n3,4\n"),
            "f:1:1: '1,2' may be columns, or numbers with decimal commas: no line names columns");
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
  const CsvTable table = read("t / s;p1/kPa;F/kN/m;kN/m;F_T/P\n0;1;2;3;4\n");
  EXPECT_EQ(table.names, (std::vector<std::string>{"t", "p1", "F", "kN/m", "F_T/P"}));
  EXPECT_EQ(table.units, (std::vector<std::string>{"s", "kPa", "kN/m", "", ""}));
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
