// Claim: of a thousand files with the changes that files suffer when they are passed on (a column lost, a unit
// changed, the head cut, rows doubled, CRLF, decimal commas, cut anywhere), each is read correctly or refused with
// its place.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <random>
#include <sstream>

#include "case/cfd/flow_record.h"
#include "upbead/base/error.h"

namespace upbead::test {

namespace flow_mutations_test {

namespace fs = std::filesystem;

using Lines = std::vector<std::string>;

Lines lines_of(const std::string& path) {
  std::ifstream file(path);
  Lines lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

std::string text_of(const Lines& lines, const std::string& end = "\n") {
  std::string text;
  for (const std::string& line : lines) text += line + end;
  return text;
}

/// A sample file, and the name of its changed copy.
struct Sample {
  std::string path, copy;
  char separator;  ///< between cells; ' ': any number of blanks
  std::string unit, other_unit;
  double factor;  ///< of the numbers where the other unit is written
  bool moments;   ///< whether forces and moments are in one file
};

std::vector<Sample> all_samples() {
  const std::string flows = UPBEAD_FLOWS, bore = UPBEAD_BORE;
  return {{flows + "/foundation/0/forces.dat", "forces.dat", ' ', "", "", 1., true},
          {flows + "/foundation_porous/0.8/forces.dat", "forces.dat", ' ', "", "", 1., true},
          {flows + "/esi_plain/0/force.dat", "force.dat", ' ', "", "", 1., false},
          {flows + "/esi_parentheses/0.8/force.dat", "force.dat", ' ', "", "", 1., false},
          {bore + "/probes/0/p", "p", ' ', "", "", 1., false},
          {flows + "/dualsphysics/GaugesForce_Wall.csv", "force.csv", ';', "[N]", "[kN]", 1e3, false},
          {flows + "/dualsphysics/PointsPress_semicolon.csv", "press.csv", ';', "[Pa]", "[kPa]", 1e3, false},
          {flows + "/dualsphysics/PointsPress_comma.csv", "press.csv", ',', "[Pa]", "[hPa]", 1e2, false}};
}

/// All numbers of a record, row by row, with its times first.
struct Numbers {
  std::vector<double> time;
  std::vector<std::vector<double>> row;
};

Numbers numbers_of(const FlowRecord& record, const Sample& sample) {
  Numbers numbers{record.time(), {}};
  for (std::size_t t = 0; t < numbers.time.size(); ++t) {
    std::vector<double>& row = numbers.row.emplace_back();
    if (record.forces) {
      row.insert(row.end(), record.forces->force[t].begin(), record.forces->force[t].end());
      if (sample.moments) row.insert(row.end(), record.forces->moment[t].begin(), record.forces->moment[t].end());
      continue;
    }
    for (std::size_t p = 0; p < record.points->at.size(); ++p) row.push_back(record.points->rows.at(t, p));
  }
  return numbers;
}

bool is_head(const Sample& sample, const std::string& line) {
  return line.find('#') != std::string::npos || line.find('[') != std::string::npos ||
         (sample.separator != ' ' && line.find("Pos") != std::string::npos);
}

enum class Change {
  column_lost,
  cell_lost,
  unit_changed,
  head_line_cut,
  head_cut_within,
  rows_doubled,
  row_lost,
  crlf,
  decimal_commas,
  truncated,
  swapped_rows,
  n_changes
};

/// The line without its n-th cell; brackets of that cell stay.
std::string without_cell(const Sample& sample, const std::string& line, std::size_t n) {
  if (sample.separator != ' ') {
    std::stringstream stream(line);
    std::string out, cell;
    for (std::size_t c = 0; std::getline(stream, cell, sample.separator); ++c)
      if (c != n)
        out += (out.empty() && c == 0 ? "" : (c == 1 && n == 0 ? "" : std::string(1, sample.separator))) + cell;
    return out;
  }
  std::stringstream stream(line);
  std::string out, word;
  for (std::size_t c = 0; stream >> word; ++c) {
    if (c != n) {
      out += word + " ";
      continue;
    }
    for (const char bracket : word)
      if (bracket == '(' || bracket == ')') out += bracket;
    out += " ";
  }
  return out;
}

class Mutator {
 public:
  explicit Mutator(unsigned seed) : generator_(seed) {}
  std::size_t below(std::size_t n) { return n == 0 ? 0 : generator_() % n; }

  /// The changed text. `factor`: of the numbers other than times, to be expected if the text is read.
  std::string apply(Change change, const Sample& sample, Lines lines, double& factor) {
    std::size_t first = 0;
    while (is_head(sample, lines[first])) ++first;
    const std::size_t row = first + below(lines.size() - first);
    factor = 1.;
    switch (change) {
      case Change::column_lost: {
        const std::size_t n = 1 + below(5);
        for (std::size_t i = first; i < lines.size(); ++i) lines[i] = without_cell(sample, lines[i], n);
        break;
      }
      case Change::cell_lost:
        lines[row] = without_cell(sample, lines[row], 1 + below(4));
        break;
      case Change::unit_changed:
        for (std::size_t i = 0; i < first && !sample.unit.empty(); ++i)
          for (std::size_t at = 0; (at = lines[i].find(sample.unit, at)) != std::string::npos;)
            lines[i].replace(at, sample.unit.size(), sample.other_unit), at += sample.other_unit.size();
        factor = sample.unit.empty() ? 1. : sample.factor;
        break;
      case Change::head_line_cut:
        lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(below(first)));
        break;
      case Change::head_cut_within: {
        std::string& line = lines[below(first)];
        line.resize(below(line.size()));
        break;
      }
      case Change::rows_doubled:
        lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(row), lines[row]);
        break;
      case Change::row_lost:
        lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(row));
        break;
      case Change::swapped_rows:
        if (row > first) std::swap(lines[row], lines[row - 1]);
        break;
      case Change::decimal_commas:
        for (std::size_t i = first; i < lines.size(); ++i)
          for (char& c : lines[i]) c = c == '.' ? ',' : c;
        break;
      case Change::crlf:
        return text_of(lines, "\r\n");
      case Change::truncated: {
        std::string text = text_of(lines);
        text.resize(below(text.size()));
        return text;
      }
      case Change::n_changes:
        break;
    }
    return text_of(lines);
  }

 private:
  std::mt19937 generator_;
};

/// Every row that was read is the sample's row of the same time, times the factor.
void expect_right(const Numbers& whole, const Numbers& read, double factor, const std::string& what) {
  for (std::size_t t = 0; t < read.time.size(); ++t) {
    const auto at = std::lower_bound(whole.time.begin(), whole.time.end(), read.time[t]);
    ASSERT_TRUE(at != whole.time.end() && *at == read.time[t])
        << what << ": no row of the sample is of t = " << read.time[t];
    const std::vector<double>& row = whole.row[static_cast<std::size_t>(at - whole.time.begin())];
    ASSERT_EQ(read.row[t].size(), row.size()) << what;
    for (std::size_t c = 0; c < row.size(); ++c)
      ASSERT_NEAR(read.row[t][c], factor * row[c], 1e-12 * std::abs(factor * row[c]))
          << what << ", t = " << read.time[t];
  }
}

TEST(FlowMutations, EachIsReadRightOrRefusedWithItsPlace) {
  fs::create_directories("mutated");
  Mutator mutator(25);
  int read = 0, refused = 0;
  const std::vector<Sample> samples = all_samples();
  std::map<std::string, FlowRecord> originals;
  std::map<std::string, Numbers> numbers;
  for (const Sample& sample : samples) {
    originals[sample.path] = read_flow(sample.path, "", {});
    numbers[sample.path] = numbers_of(originals[sample.path], sample);
  }
  constexpr int n_files = 1100;
  for (int n = 0; n < n_files; ++n) {
    const Sample& sample = samples[static_cast<std::size_t>(n) % samples.size()];
    const auto change =
        static_cast<Change>((n / static_cast<int>(samples.size())) % static_cast<int>(Change::n_changes));
    const std::string path = "mutated/" + sample.copy, what = sample.path + ", change " +
                                                              std::to_string(static_cast<int>(change)) + ", file " +
                                                              std::to_string(n);
    const FlowRecord& original = originals.at(sample.path);
    const Numbers& whole = numbers.at(sample.path);
    double factor = 1.;
    std::ofstream(path, std::ios::binary) << mutator.apply(change, sample, lines_of(sample.path), factor);
    try {
      const FlowRecord record = read_flow(path, "", {"case.toml", 1, 1});
      expect_right(whole, numbers_of(record, sample), factor, what);
      if (record.points) {
        EXPECT_EQ(record.points->at, original.points->at) << what;
      }
      if (record.forces && record.forces->centre) {
        EXPECT_EQ(record.forces->centre, original.forces->centre) << what;
      }
      if (HasFatalFailure()) return;
      ++read;
    } catch (const InputError& error) {
      for (const Diagnostic& mistake : error.diagnostics()) {
        EXPECT_FALSE(mistake.place.file.empty()) << what;
        EXPECT_FALSE(mistake.what.empty()) << what;
      }
      ++refused;
      EXPECT_TRUE(change != Change::crlf && change != Change::row_lost && change != Change::rows_doubled)
          << what << " should be read: " << error.what();
    }
    fs::remove(path);
  }
  fs::remove_all("mutated");
  EXPECT_GT(read, n_files / 4);
  EXPECT_GT(refused, n_files / 4);
  std::cout << read << " read right, " << refused << " refused\n";
}

}  // namespace flow_mutations_test
}  // namespace upbead::test
