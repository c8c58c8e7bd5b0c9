// Claim: a table of numbers is read whatever program wrote it; every kind of damage is told by line and column.
#include "upbead/base/csv.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace upbead {

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
    try {
      read(text);
    } catch (const InputError& error) {
      std::string messages;
      for (Mistake mistake : error.mistakes()) {
        if (mistake.place.file == path_) mistake.place.file = "f";
        mistake.cure.clear();
        messages += (messages.empty() ? "" : "\n") + to_string(mistake);
      }
      return messages;
    }
    return "";
  }

  std::string path_;
};

TEST_F(Csv, ReadsColumns) {
  const CsvTable table = read("time, force,\"p\"\n0,1e6,-2.5\n\n+0.5 ,\t2,3\n");
  EXPECT_EQ(table.names, (std::vector<std::string>{"time", "force", "\"p\""}));
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
  EXPECT_EQ(refusal("1,2\n3,4\n"), "f:1:1: the first line holds numbers, not the names of the columns");
  EXPECT_EQ(refusal("a,b\n1, x\n"), "f:2:4: 'x' is not a number (column b)");
  EXPECT_EQ(refusal("a,b\n1,2.0.0\n"), "f:2:3: '2.0.0' is not a number (column b)");
  EXPECT_EQ(refusal("a,b\n,2\n"), "f:2:1: an empty cell (column a)");
  EXPECT_EQ(refusal("a,b\n1\n"), "f:2:1: cells in this row: 1, in the header: 2");
  EXPECT_EQ(refusal("a,b\n1,2,3\n"), "f:2:1: cells in this row: 3, in the header: 2");
  EXPECT_EQ(refusal("a,b\n1,inf\n"), "f:2:3: 'inf' is not finite (column b)");
  EXPECT_EQ(refusal("a,b\n1,-nan\n"), "f:2:3: '-nan' is not finite (column b)");
  EXPECT_EQ(refusal("a,b\n1,1e999\n"), "f:2:3: '1e999' is beyond the range of a number (column b)");
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

TEST_F(Csv, NamesOtherDialects) {
  EXPECT_EQ(refusal("\n# measured\ntime,p\n0,1\n"),
            "f:2:1: a comment ('#') stands where the names of the columns belong");
  EXPECT_EQ(refusal("time;p\n0;1\n"), "f:1:1: the columns are separated by semicolons");
  EXPECT_EQ(refusal("0,5;1,2\n"), "f:1:1: the columns are separated by semicolons");
  EXPECT_EQ(refusal("time\tp\n0\t1\n"), "f:1:1: the columns are separated by tabs");
}

TEST_F(Csv, TellsSeveralButNotThousands) {
  EXPECT_EQ(refusal("a\nx\n1\ny\n"), "f:2:1: 'x' is not a number (column a)\nf:4:1: 'y' is not a number (column a)");
  std::string text = "a\n";
  for (int i = 0; i < 1000; ++i) text += "x\n";
  try {
    read(text);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.mistakes().size(), 10u);
    EXPECT_EQ(error.mistakes().back().cure, "give a finite number such as 1.5e6; further rows were not read");
  }
}

TEST_F(Csv, TellsAMissingFileWhereItWasNamed) {
  for (const std::string path : {"/nowhere/f.csv", "/tmp"}) try {
      read_csv(path, {"case.toml", 3, 1});
      FAIL() << path;
    } catch (const InputError& error) {
      EXPECT_EQ(error.what(), "case.toml:3:1: cannot read '" + path + "'; check the path and the rights");
    }
}

}  // namespace upbead
