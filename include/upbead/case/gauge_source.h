// Where pressures measured along a wall or a bottom are to be found, as a case says it.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>

#include "upbead/case/record_clock.h"
#include "upbead/model/gauges.h"

namespace upbead {

/// The keys of a load of kind "pressures", or of a prescribed uplift.
struct GaugeSource : RecordClock {
  std::string gauges;                   ///< file; "" where there are none
  std::map<std::string, double> place;  ///< of each transducer, by the name of its column (m)
  std::optional<std::array<double, 2>> ends;
  Beyond to_first = Beyond::constant, to_last = Beyond::constant;
  std::string gauge_unit;  ///< "": as the headers say
  std::string load_cell;   ///< name of a column; "" where there is none
};

/// A load by transducers, which become a load each in the scene.
struct GaugeLoad {
  Load load;           ///< what the transducers have in common, as written
  GaugeSource source;  ///< paths as written
  Gauges gauges;       ///< read
};

}  // namespace upbead
