// Lines of text with numbers in them, from files that CFD programs write.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "case/cfd/flow_rows.h"
#include "upbead/base/error.h"

namespace upbead {

/// The lines of a file, without their line ends.
class FlowLines {
 public:
  /// Reads the file, compressed or not. Throws InputError at `place` where it cannot be read.
  FlowLines(std::string path, const Place& place);
  /// The next line that is not blank; false at the end. A last line without a line end was cut while being written,
  /// perhaps within a number: it is left out, and a note says so.
  bool next(FlowNotes& notes);
  std::string_view line() const { return line_; }
  /// Makes next() give the same line once more.
  void back() { again_ = true; }
  Place place(int column = 1) const { return {path_, number_, column}; }
  const std::string& path() const { return path_; }
  /// What is not read yet.
  std::string_view rest() const { return rest_; }
  /// About how many rows are left.
  std::size_t rows_left() const;

 private:
  std::string path_, text_;
  std::string_view line_, rest_;
  int number_ = 0;
  bool again_ = false;
};

/// A line as numbers and brackets: "1 (2 3)" has the shape "n(nn)".
struct FlowLine {
  std::string shape;
  std::vector<double> numbers;
};

/// Splits at blanks and brackets. Throws InputError at a word that is no number. Numbers of any size are accepted.
void read_line(const FlowLines& lines, FlowLine& line);

/// Reads a word as a number; false where it is none.
bool read_number(std::string_view word, double& number);

/// Throws InputError where a number is not finite, or larger than any physical quantity can be.
void require_quantities(const FlowLines& lines, const FlowLine& line);

/// Words between blanks and other marks.
std::vector<std::string> words_of(std::string_view text, std::string_view marks = " \t");

std::string lower_case(std::string_view text);

}  // namespace upbead
