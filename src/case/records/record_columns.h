// Columns of a record in SI units and the run's time.
#pragma once

#include <string>
#include <vector>

#include "record_layout.h"
#include "record_table.h"
#include "upbead/case/case.h"

namespace upbead {

struct RecordTimes {
  std::vector<double> time;  ///< of the run (s)
  std::size_t at_rest = 0;   ///< samples of the beginning
};

/// Throws InputError where no column is the time, where times do not ascend, at their row, and where a sampling rate
/// and a column of times contradict each other.
RecordTimes record_times(const CsvTable& table, const RecordLayout& layout, const RecordClock& clock);

/// The column of that name, as it is without its unit or as "p1/kPa". Throws InputError at `place` with what there is.
std::size_t column_of(const CsvTable& table, const std::string& name, const Place& place);

/// Takes the mean of the samples at rest off all.
void take_off_rest(const RecordTimes& times, std::vector<double>& values);

}  // namespace upbead
