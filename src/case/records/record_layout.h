// Which column of a record is its time, which hold values, and which are neither; judged by their headers, in the
// words that laboratories use.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/csv.h"
#include "base/header_words.h"
#include "upbead/output/summary.h"

namespace upbead {

/// How a column of a file was read.
struct RecordSummary {
  std::string of;                              ///< "loads.wall", "measured.F_T"
  std::string file, column, unit, si, layout;  ///< unit as taken, and how it is known; SI unit; of the whole file
  int samples = 0;
  double begin = 0., interval = 0.;        ///< first time, mean interval (s)
  double extreme = 0., extreme_time = 0.;  ///< largest by magnitude (SI unit), and when (s), in the run's time
};

/// How a file was read.
struct RecordNotes {
  std::vector<RecordSummary> read;  ///< each column that is used
  std::vector<Skipped> left_out;    ///< parts of the file
  NumberedWarnings warnings;
};

void append(RecordNotes& notes, const RecordNotes& more);
/// A line "note: ..." for each part that was left out.
std::string note_lines(const RecordNotes& notes);

struct RecordLayout {
  std::optional<std::size_t> time;    ///< none: no column can be the time
  std::vector<std::size_t> counters;  ///< named as such, of whole numbers that ascend
  std::vector<std::size_t> clocks;    ///< further columns of times
  std::vector<std::size_t> words;     ///< columns without any number, as of dates
  std::vector<std::size_t> values;    ///< all others, in their order
};

/// The time is the column of numbers whose header says so most clearly; where none does, it is the first column, unless
/// that is a counter. Throws InputError where two columns say so equally clearly and differ, or where the first column
/// says nothing and a later one has only a unit of time.
RecordLayout layout_of(const CsvTable& table);

/// Notes what is left out of the table, and warns of times without a unit that are whole numbers ascending by one.
void note_layout(const CsvTable& table, const RecordLayout& layout, RecordNotes& notes);

/// The times in s, by the unit of their header, as the file has them. Throws InputError where no column is the time.
std::vector<double> times_of(const CsvTable& table, const RecordLayout& layout);

/// "column 'Part' of press.csv".
std::string column_text(const CsvTable& table, std::size_t column);

}  // namespace upbead
