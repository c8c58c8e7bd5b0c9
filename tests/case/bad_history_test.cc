// Claim: mistakes in a history file are reported with the file's line and column, the file as a whole by the key that
// names it.
#include <vector>

#include "good_case.h"
#include "upbead/case/case.h"

namespace upbead::test {
namespace bad_history_test {

struct BadHistory {
  std::string name;
  std::string text;
  std::string messages;
};

void PrintTo(const BadHistory& row, std::ostream* stream) {
  *stream << row.name;
}

class BadHistories : public InFolder, public testing::WithParamInterface<BadHistory> {};

TEST_P(BadHistories, IsExplained) {
  write("case.toml", good_case);
  write("force.csv", GetParam().text);
  try {
    read_case("case.toml");
    FAIL() << "read without a message";
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), GetParam().messages);
  }
}

const std::vector<BadHistory> rows{
    BadHistory{"Empty", "", "force.csv: an empty file; write a header line and rows of numbers"},
    BadHistory{"HeaderOnly", "time,force\n", "force.csv: no row of numbers below the header; write at least one row"},
    BadHistory{
        "NoHeader", "0,0\n1,1\n",
        "force.csv:1:1: '0,0' may be columns, or numbers with commas in them: no line names columns; write a header "
        "above it, such as time,force"},
    BadHistory{"OneColumn", "time\n0\n1\n",
               "force.csv:1:1: a history of one column; give two columns, time (s) and value"},
    BadHistory{"OneRow", "time,force\n0,1\n", "force.csv: a history of one row; give two rows or more"},
    BadHistory{"Word", "time,force\n0,0\n0.1, high\n",
               "force.csv:3:6: 'high' is not a number (column force); give a finite number such as 1.5e6"},
    BadHistory{
        "UnitInEachCell", "time,force\n0,0 kN/m\n0.1,5 kN/m\n",
        "force.csv:2:3: '0 kN/m' is not a number (column force), one of 2 such cells; give a finite number such as "
        "1.5e6"},
    BadHistory{"EmptyCell", "time,force\n0,0\n0.1,\n",
               "force.csv:3:5: an empty cell (column force); give a finite number such as 1.5e6"},
    BadHistory{"TooFewCells", "time,force\n0,0\n0.1\n",
               "force.csv:3:1: cells in this row: 1, in the header: 2; give every row one number per column, separated "
               "by commas"},
    BadHistory{"TooManyCells", "time,force\n0,0\n0.1,1,2\n",
               "force.csv:3:1: cells in this row: 3, in the header: 2; give every row one number per column, separated "
               "by commas"},
    BadHistory{"NotFinite", "time,force\n0,0\n0.1,nan\n",
               "force.csv:3:5: 'nan' is not finite (column force); give a finite number such as 1.5e6"},
    BadHistory{
        "TooLarge", "time,force\n0,0\n0.1,1e999\n",
        "force.csv:3:5: '1e999' is beyond the range of a number (column force); give a finite number such as 1.5e6"},
    BadHistory{"TimesDescend", "time,force\n0,0\n\n0.2,1\n0.1,2\n",
               "force.csv:5:1: t = 0.1 s does not follow t = 0.2 s; let the times ascend strictly"},
    BadHistory{"TimeRepeats", "time,force\n0,0\n0,1\n",
               "force.csv:3:1: t = 0 s does not follow t = 0 s; let the times ascend strictly"},
    BadHistory{"ThreeAtOneTime", "time,force\n0,0\n1,1\n1,2\n1,3\n2,0\n",
               "force.csv:4:1: t = 1 s does not follow t = 1 s; let the times ascend strictly"},
    BadHistory{"TimesOfARoundedClock", "time,force\n0,0\n0,1\n1,1\n1,2\n2,2\n2,3\n3,3\n3,4\n4,4\n4,5\n",
               "force.csv:3:1: t = 0 s does not follow t = 0 s; let the times ascend strictly"},
    BadHistory{"StartsBeforeTheRun", "time,force\n-0.1,0\n0.1,1\n",
               "force.csv:2:1: the history starts at t = -0.1 s, before the run; let it start at 0 or later, or give "
               "record_start"},
    BadHistory{"OnlyACounter", "Part,force\n0,0\n1,1\n",
               "force.csv:1:1: no column says that it is the time, and the first one, 'Part', is a counter; call the "
               "column of times 'time (s)'; a load by transducers may have sampling_rate in its place"},
    BadHistory{"NoValue", "Part;Time [s]\n0;0\n1;1\n",
               "force.csv:1:1: beside the time no column holds values, but counters or other times; give two columns, "
               "time (s) and value"},
    BadHistory{"AllZero", "time,force\n0,0\n1,0\n",
               "force.csv: every value of the history is zero; give a history with a load"},
};

INSTANTIATE_TEST_SUITE_P(, BadHistories, testing::ValuesIn(rows), [](const auto& test) { return test.param.name; });

}  // namespace bad_history_test
}  // namespace upbead::test
