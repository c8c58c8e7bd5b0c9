// Which column of a record is its time, which hold values, and which are neither; judged by their headers, in the
// words that laboratories use.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/csv.h"
#include "upbead/base/numbered_warning.h"

namespace upbead {

/// How surely the header says that a column is the time, in ascending order.
enum class HeaderSays {
  nothing,
  counter,        ///< Part, Step, No., #, Index, Sample, Zeitschritt
  another_clock,  ///< Real time, CPU time, Timestamp
  unit_of_time,   ///< a unit of time after some other name, or [s] alone
  capital,        ///< T
  letter,         ///< t
  kind_of_time,   ///< Elapsed time, Time 1 - default sample rate
  time            ///< Time, Zeit, Temps, Tiempo, time_ms
};

/// Judges a header; `name` and `unit` are as base/csv.h splits them. A column with a unit of another quantity is no
/// time, whatever its name.
HeaderSays header_says(const std::string& name, const std::string& unit);

/// The unit of time that a header gives, as base/units.h knows it: "ms" of "Time [MS]", of "t_ms", of "[ms]"; "" of
/// "Time".
std::string unit_of_time(const std::string& name, const std::string& unit);

/// A part of a file that is not used, and why.
struct LeftOut {
  std::string what, why;
};

struct RecordNotes {
  std::vector<LeftOut> left_out;
  NumberedWarnings warnings;
};

struct RecordLayout {
  std::optional<std::size_t> time;    ///< none: no column can be the time
  std::vector<std::size_t> counters;  ///< named as such, of whole numbers that ascend
  std::vector<std::size_t> clocks;    ///< further columns of times
  std::vector<std::size_t> values;    ///< all others, in their order
};

/// The time is the column whose header says so most clearly; where none does, it is the first column, unless that is
/// a counter. Throws InputError where two columns say so equally clearly and differ, or where the first column says
/// nothing and a later one has only a unit of time.
RecordLayout layout_of(const CsvTable& table);

/// Notes what is left out of the table, and warns of times without a unit that are whole numbers ascending by one.
/// The first rows of a table are enough.
void note_layout(const CsvTable& table, const RecordLayout& layout, RecordNotes& notes);

/// The times in s, by the unit of their header. Throws InputError where no column is the time.
std::vector<double> times_of(const CsvTable& table, const RecordLayout& layout);

/// "column 'Part' of press.csv".
std::string column_text(const CsvTable& table, std::size_t column);

}  // namespace upbead
