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

/// The keys of a history of one value.
struct HistoryKeys {
  std::string history_file;
  std::string column;  ///< "": the first that is neither a time nor a counter
};

/// A table [measured.NAME] as written.
struct MeasuredKeys : RecordClock {
  std::string file;     ///< as written
  std::string column;   ///< "": the second, or the first where there is no column of times
  std::string reading;  ///< history below /history of results.h5
  std::string unit;     ///< "": as the header says
};

/// Declares which column of a history is its value; behind the key of its file.
template <class T>
void add_column_key(TableSchema<T>& table) {
  table.key("column", &T::column, "", "name of the column of the history that is the value")
      .fallback("the one beside the time")
      .when(
          "kind", [](const T& source) { return !source.history_file.empty(); }, "of a history");
}

/// Declares the keys of the record's clock; `clock_in` may say where the entries belong, `in` where the sampling rate
/// does.
template <class T, class In, class ClockIn>
void add_clock_keys(TableSchema<T>& table, const In& in, const ClockIn& clock_in) {
  clock_in(table.key("zero", &T::zero))
      .unit("s")
      .range(at_least(0.))
      .doc("how much of the record's beginning is at rest; its mean is taken off each column; 0: nothing is taken off");
  clock_in(table.key("record_start", &T::record_start)).unit("s").doc("time of the record that is t = 0 of the run");
  in(table.key("sampling_rate", &T::sampling_rate))
      .unit("Hz")
      .range(above(0.))
      .fallback("the first column is the time")
      .doc("samples a second of a record without a column of times");
}

}  // namespace upbead
