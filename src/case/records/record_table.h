// Records as laboratories supply them, and their columns in SI units and the run's time.
#pragma once

#include <string>
#include <vector>

#include "base/csv.h"
#include "case/records/record_keys.h"
#include "case/records/record_layout.h"

namespace upbead {

struct RecordTimes {
  std::vector<double> time;  ///< of the run (s)
  std::size_t at_rest = 0;   ///< number of samples at rest, at the beginning
};

/// The times of a record. Throws InputError where no column is the time, where times do not ascend, at their row, and
/// where a sampling rate and a column of times contradict each other.
RecordTimes record_times(const CsvTable& table, const RecordLayout& layout, const RecordClock& clock);

/// The column of that name, written as in the file, without its unit, or as "p1/kPa". Throws InputError at `place`,
/// with the names that exist, and where two columns have that name.
std::size_t column_of(const CsvTable& table, const std::string& name, const Place& place);

/// Subtracts the mean of the samples at rest from all samples.
void take_off_rest(const RecordTimes& times, std::vector<double>& values);

/// Warning record_zero: from the first to the last third of the samples at rest their mean changes by more than a
/// twentieth of the record's range.
NumberedWarnings zero_warnings(const std::string& name, const RecordTimes& times, const std::vector<double>& values);

/// A table from text (base/csv.h) or, of HDF5 (see is_hdf5), from the one-dimensional datasets below the
/// root of an HDF5 file, all of one length, with their attributes `unit`; `time` comes first. Throws InputError.
CsvTable read_record_table(const std::string& path, const Place& place);

/// Whether a file ends in .h5 or .hdf5, or begins as HDF5 does.
bool is_hdf5(const std::string& path);

/// Whether this row and the one before are both sides of a jump: two samples at one time. Not where there are three, or
/// where a tenth of the rows repeat a time, as of times that were rounded.
bool is_jump(const std::vector<double>& time, std::size_t row);

/// The unit of a column, and how that is known.
struct ColumnUnit {
  std::string text;    ///< "kPa"
  double factor = 1.;  ///< to SI units
  std::string by;      ///< "by the end of its name", "as none is given"; "" by its header
  bool given() const { return by != none; }
  static constexpr const char* none = "as none is given";
};

/// Throws InputError where the name of a column without a unit holds one in a form that is not read; `si`: what it
/// should hold.
void refuse_unread_unit(const std::string& path, const std::string& name, const std::string& si);

/// The unit of a column that holds a quantity whose SI unit is `si`: `given`, else that of the header, else one at the
/// end of the name ("p1_kPa"), else `si`. Throws InputError where the unit is not known, or is one of another quantity.
ColumnUnit unit_of_column(const CsvTable& table, std::size_t column, const std::string& si,
                          const std::string& given = "");

/// The numbers of a column times the factor. Throws InputError where a cell is no number.
std::vector<double> converted(const CsvTable& table, std::size_t column, const ColumnUnit& unit);

/// A column in SI units. Throws InputError as above, and where a number stands for a missing value (99.00, -9999 ...)
/// among numbers a third as large at most.
std::vector<double> in_si(const CsvTable& table, std::size_t column, const std::string& si,
                          const std::string& unit = "");

/// Throws InputError where numbers of a column stand for missing values.
void refuse_missing_marks(const CsvTable& table, std::size_t column);

/// How a column was read; `time`, `values`: in SI units, in the run's time.
RecordSummary summary_of(const CsvTable& table, std::size_t column, const std::string& si, const std::string& given,
                         const std::vector<double>& time, const std::vector<double>& values);

}  // namespace upbead
