// Which column of a record is its time, which hold values, which are neither: by their headers.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/csv.h"
#include "case/record_notes.h"

namespace upbead {

struct RecordLayout {
  std::optional<std::size_t> time;    ///< none: no column can be it
  std::vector<std::size_t> counters;  ///< named as such, of whole numbers that ascend
  std::vector<std::size_t> clocks;    ///< further columns of times
  std::vector<std::size_t> values;    ///< all others, in their order
};

/// The time is the column whose header says so most clearly (header_words.h); where none does it is the first one that
/// is no counter's. Throws InputError where two say so alike and differ, or where a first column without a word stands
/// before one that has but a unit of time.
RecordLayout layout_of(const CsvTable& table);

/// Adds what is left out of the table, and warnings: whole numbers that ascend by one as times without a unit. The
/// first rows of a table tell as much.
void note_layout(const CsvTable& table, const RecordLayout& layout, RecordNotes& notes);

/// The times in s, by the unit of their header. Throws InputError where no column is the time.
std::vector<double> times_of(const CsvTable& table, const RecordLayout& layout);

/// "column 'Part' of press.csv".
std::string column_text(const CsvTable& table, std::size_t column);

}  // namespace upbead
