// Records as laboratories supply them, and their columns in SI units and the run's time.
#pragma once

#include <string>
#include <vector>

#include "base/csv.h"
#include "case/records/record_layout.h"
#include "upbead/case/case.h"

namespace upbead {

struct RecordTimes {
  std::vector<double> time;  ///< of the run (s)
  std::size_t at_rest = 0;   ///< number of samples at rest, at the beginning
};

/// The times of a record. Throws InputError where no column is the time, where times do not ascend, at their row, and
/// where a sampling rate and a column of times contradict each other.
RecordTimes record_times(const CsvTable& table, const RecordLayout& layout, const RecordClock& clock);

/// The column of that name, written without its unit or as "p1/kPa". Throws InputError at `place`, with the names
/// that exist.
std::size_t column_of(const CsvTable& table, const std::string& name, const Place& place);

/// Subtracts the mean of the samples at rest from all samples.
void take_off_rest(const RecordTimes& times, std::vector<double>& values);

/// A table from CSV (base/csv.h) or, where the file ends in .h5 or .hdf5, from the one-dimensional datasets below the
/// root of an HDF5 file, all of one length, with their attributes `unit`; `time` comes first. Throws InputError.
CsvTable read_record_table(const std::string& path, const Place& place);

/// The first rows of such a table, as many as one megabyte holds; of HDF5 all rows. Throws InputError as above.
CsvTable read_record_head(const std::string& path);

/// Whether this row and the one before are both sides of a jump: two samples at one time. Not where there are three, or
/// where a tenth of the rows repeat a time, as of times that were rounded.
bool is_jump(const std::vector<double>& time, std::size_t row);

/// A column in SI units: by `unit` where it is given, else by the header's unit, else unchanged. Throws InputError
/// where the unit is not known, or not one of the quantity whose SI unit is `si`.
std::vector<double> in_si(const CsvTable& table, std::size_t column, const std::string& si,
                          const std::string& unit = "");

}  // namespace upbead
