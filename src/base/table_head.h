// The lines above a table's numbers: which of them holds the names, which the units, which are titles.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/dialect.h"

namespace upbead {

struct TableLine {
  std::string_view text;
  int number = 0;
};

struct TableHead {
  std::vector<std::string> names, units;
  bool certain = false;         ///< the names are no mere comment or title
  int line = 0, unit_line = 0;  ///< where they stand; 0: nowhere
  std::size_t last = 0;         ///< how many lines it takes, to the last one of names and units; 0 without names
};

/// Whether the first sign of a line makes it a comment, # or %.
bool is_comment(std::string_view line);

/// Whether a line is drawn of - = _ + | and the like.
bool is_ruler(std::string_view line);

/// Judges the lines above the first row of numbers. Throws InputError where several may be the names, or where names or
/// units cannot be told by column.
TableHead head_of(const std::vector<TableLine>& lines, const TableShape& shape, int first_row, const std::string& path);

}  // namespace upbead
