// The keys of records: of transducers, and of what a run is compared with.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>

#include "input/schema.h"
#include "upbead/model/gauges.h"

namespace upbead {

struct RecordClock {
  double zero = 0.;          ///< s from the record's beginning; its mean over this time of rest is subtracted
  double record_start = 0.;  ///< the record's time at t = 0 of the run (s)
  std::optional<double> sampling_rate;  ///< Hz; none: the first column is the time
};

/// The keys of a load of kind "pressures", or of a prescribed uplift.
struct GaugeKeys : RecordClock {
  std::string gauges;                   ///< file; "" where there are none
  std::map<std::string, double> place;  ///< of each transducer, by the name of its column (m)
  std::optional<std::array<double, 2>> ends;
  Beyond to_first = Beyond::constant, to_last = Beyond::constant;
  std::string gauge_unit;  ///< "": as the headers say
  std::string load_cell;   ///< name of a column; "" where there is none
};

/// A table [measured.NAME] as written.
struct MeasuredKeys : RecordClock {
  std::string file;     ///< as written
  std::string column;   ///< "": the second, or the first where there is no column of times
  std::string reading;  ///< history below /history of results.h5
  std::string unit;     ///< "": as the header says
};

/// Declares the keys of the record's clock; `in` and `start_in` may say where each entry belongs.
template <class T, class In, class StartIn>
void add_clock_keys(TableSchema<T>& table, const In& in, const StartIn& start_in) {
  in(table.key("zero", &T::zero))
      .unit("s")
      .range(at_least(0.))
      .doc("how much of the record's beginning is at rest; its mean is taken off each column; 0: nothing is taken off");
  start_in(table.key("record_start", &T::record_start)).unit("s").doc("time of the record that is t = 0 of the run");
  in(table.key("sampling_rate", &T::sampling_rate))
      .unit("Hz")
      .range(above(0.))
      .fallback("the first column is the time")
      .doc("samples a second of a record without a column of times");
}

}  // namespace upbead
