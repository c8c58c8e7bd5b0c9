// What a laboratory measured of the response, to be held against the run.
#pragma once

#include <string>

#include "upbead/case/record_clock.h"

namespace upbead {

/// A table [measured.NAME] as written.
struct MeasuredSource : RecordClock {
  std::string file;     ///< as written
  std::string column;   ///< "": the second, or the first where there is no column of times
  std::string reading;  ///< history below /history of results.h5
  std::string unit;     ///< "": as the header says
};

}  // namespace upbead
