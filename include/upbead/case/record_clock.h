// How a record's own time becomes the run's.
#pragma once

#include <optional>

namespace upbead {

struct RecordClock {
  double zero = 0.;                     ///< s from the record's beginning that it rests; its mean there is taken off
  double record_start = 0.;             ///< its time that is t = 0 of the run (s)
  std::optional<double> sampling_rate;  ///< Hz; none: the first column is the time
};

}  // namespace upbead
