// Measured histories, compared with computed ones.
#pragma once

#include <string>
#include <vector>

#include "case/records/record_keys.h"
#include "case/records/record_layout.h"
#include "output/result_file.h"
#include "upbead/case/case.h"
#include "upbead/output/summary.h"

namespace upbead {

TableSchema<MeasuredKeys> measured_schema();

/// The column to compare: the named one, else the first that is neither a time nor a counter. Throws InputError at
/// `place` where there is none.
std::size_t measured_column(const MeasuredKeys& source, const CsvTable& table, const RecordLayout& layout,
                            const Place& place);

/// A record in SI units and the run's time.
struct MeasuredRecord {
  std::string name, reading, unit;
  std::vector<double> time, value;
  RecordNotes notes;
};

/// Reads all records of a case. `computed`: every history that the run will have (their values are not used). Throws
/// InputError with every mistake: a reading that does not exist, and whatever is wrong with a file.
std::vector<MeasuredRecord> read_measured(const Case& input, const std::vector<Dataset>& computed);

/// Compares each record with its history; `computed` has "time". Throws InputError where they have no time in common.
std::vector<MeasuredSummary> compare_measured(const Case& input, const std::vector<MeasuredRecord>& records,
                                              const std::vector<Dataset>& computed);

/// measured/NAME/time and measured/NAME/value.
std::vector<Dataset> measured_tables(const std::vector<MeasuredRecord>& records);

std::string text_of(const std::vector<MeasuredSummary>& measured);

}  // namespace upbead
