// Tables of numbers as text: a header line with names, then rows of numbers.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "upbead/base/error.h"

namespace upbead {

struct CsvTable {
  std::string path;
  std::vector<std::string> names;            ///< of the columns, without units and quotes
  std::vector<std::string> units;            ///< of the columns, as written; "" where none is
  std::vector<std::vector<double>> columns;  ///< columns[c][row]
  std::vector<int> lines;                    ///< line number of each row in the file

  std::size_t n_rows() const { return lines.size(); }
  /// Where a row stands.
  Place place(std::size_t row) const { return {path, lines[row], 1}; }
};

/// Reads a table of numbers with at least one row, as laboratories and spreadsheets write it: separated by commas, or
/// by semicolons or tabs, where decimal commas are read too; units behind the names, "p1 (kPa)", "p1 [kPa]", "p1 /
/// kPa", or in a row below the names; packed by gzip or not. Lines above the header that begin with # or % are
/// comments; without a header, the last of them is the header. Blank lines are skipped. Throws InputError with
/// file:line:column: a file that cannot be read or is larger than 1 GB (at `place`, the key that names it), more than
/// 10,000 columns or 1e8 numbers, an empty file, no header, a cell that is no finite number of a magnitude up to
/// largest_magnitude, a row with another number of cells than the header. A magnitude below smallest_magnitude is
/// read as zero.
CsvTable read_csv(const std::string& path, const Place& place);

/// The rows that stand complete in the first `bytes` of such a table, at least one. Throws InputError as above.
CsvTable read_csv_head(const std::string& path, std::size_t bytes);

}  // namespace upbead
