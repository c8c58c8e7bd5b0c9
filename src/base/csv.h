// Tables of numbers as text, whatever program wrote them: histories, transducers, uplift, measured records, waves, sea
// states. Bytes become text (table_text.h), text a dialect of the whole file (dialect.h), the lines above the numbers
// names and units (table_head.h).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "upbead/base/error.h"

namespace upbead {

/// What is wrong in a column, first of all; it matters only where the column is used.
struct ColumnFault {
  std::size_t cells = 0;  ///< that are no numbers
  Diagnostic first;
};

struct CsvTable {
  std::string path;
  std::vector<std::string> names;            ///< of the columns, without units and quotes
  std::vector<std::string> units;            ///< of the columns, as written; "" where none is
  std::vector<std::vector<double>> columns;  ///< columns[c][row]; no number where the cell is none
  std::vector<int> lines;                    ///< line number of each row in the file
  std::vector<ColumnFault> faults = {};      ///< of each column
  std::string layout = {};                   ///< how it was read: "columns separated by commas, names in line 1"

  std::size_t n_rows() const { return lines.size(); }
  /// Where a row stands.
  Place place(std::size_t row) const { return {path, lines[row], 1}; }
  /// The numbers of a column. Throws InputError where one of its cells is none.
  const std::vector<double>& numbers(std::size_t column) const;
  /// Whether no cell of a column is a number, as of dates.
  bool is_text(std::size_t column) const;
};

/// Reads a table with at least one row of numbers. The whole file has one separator (comma, semicolon, tab or blanks),
/// one decimal sign, and perhaps a sign that groups thousands; what cannot be told is refused. Names stand above the
/// numbers, in a comment or not; units behind them ("p1 (kPa)", "p1 / kPa") or in a row below. Without names, columns
/// are called "column 1" and so on. Titles, comments (# or %), blank lines, rulers, `sep=;`, quotes and separators at
/// the ends of lines do not matter; gzip and UTF-16 neither. Records of strong motion in the format of PEER (AT2, VT2,
/// DT2) are read as columns of time and motion. Throws InputError with file:line:column: a file that cannot be read, is
/// no text (at `place`, the key that names it) or larger than 1 GB, more than 10,000 columns or 1e8 numbers, no row of
/// numbers, names that cannot be told, a row with another number of cells. Cells that are no finite number of a
/// magnitude up to largest_magnitude are faults of their column. A magnitude below smallest_magnitude is read as zero.
CsvTable read_csv(const std::string& path, const Place& place);

}  // namespace upbead
