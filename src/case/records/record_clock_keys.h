// The keys of RecordClock.
#pragma once

#include "input/schema.h"
#include "upbead/case/case.h"

namespace upbead {

/// Declares them; `in` may tell each entry where it belongs.
template <class T, class In>
void add_clock_keys(TableSchema<T>& table, const In& in) {
  in(table.key("zero", &T::zero))
      .unit("s")
      .range(at_least(0.))
      .doc("how much of the record's beginning is at rest; its mean is taken off each column; 0: nothing is taken off");
  in(table.key("record_start", &T::record_start)).unit("s").doc("time of the record that is t = 0 of the run");
  in(table.key("sampling_rate", &T::sampling_rate))
      .unit("Hz")
      .range(above(0.))
      .fallback("the first column is the time")
      .doc("samples a second of a record without a column of times");
}

}  // namespace upbead
