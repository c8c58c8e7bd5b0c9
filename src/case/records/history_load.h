// Loads and uplifts by a history from a file: time and value.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "case/load_source.h"
#include "model/record.h"

namespace upbead {

struct UpliftTable;

/// A history in the run's time.
struct FileHistory {
  Record record;                   ///< SI units, as the file has it
  TimeFunction function;           ///< of a motion its velocity
  std::optional<double> duration;  ///< Load::duration
  RecordNotes notes;               ///< how it was read
};

/// How a file is read.
struct HistoryChoice {
  std::string column;  ///< of the value; "": the first that is neither a time nor a counter, told where there are more
  double zero = 0.;    ///< s from its beginning at rest, whose mean is taken off
  double start = 0.;   ///< the record's time at t = 0 of the run (s)
};

/// Reads the file `path` (CSV or HDF5), of a load of some kind in a run until `end` (s): the time is the column whose
/// header says so. Throws InputError where the file cannot be read, has fewer than two columns or rows, has times that
/// do not ascend from 0, or only zeros. Two samples at one time are a jump. `place`: the key that names the file.
FileHistory read_history(const std::string& path, const Place& place, LoadKind kind, double end,
                         const HistoryChoice& choice);

/// U(t) of a prescribed uplift from such a file; it may be zero, but not negative, but for the noise of a rest that is
/// taken off. Throws InputError as above.
FileHistory read_uplift(const std::string& path, const Place& place, const HistoryChoice& choice);

/// The uplift of [sliding.uplift] by `history`.
std::shared_ptr<LoadSource> read_uplift_history(const UpliftTable& uplift, const Case& problem);

}  // namespace upbead
