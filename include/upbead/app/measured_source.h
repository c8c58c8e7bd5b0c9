// What a laboratory measured of the response, to be held against the run.
#pragma once

#include <optional>
#include <string>

namespace upbead {

/// A table [measured.NAME] as written.
struct MeasuredSource {
  std::string file;     ///< as written
  std::string column;   ///< "": the second, or the first where there is no column of times
  std::string reading;  ///< history below /history of results.h5
  std::string unit;     ///< "": as the header says
  double zero = 0.;     ///< s of the record whose mean is taken off
  double record_start = 0.;
  std::optional<double> sampling_rate;
};

}  // namespace upbead
