#include "measured_schema.h"

#include "record_clock_keys.h"

namespace upbead {

TableSchema<MeasuredSource> measured_schema() {
  TableSchema<MeasuredSource> table;
  table.key("file", &MeasuredSource::file).required().doc("path of the record; CSV (docs/records.md) or HDF5");
  table.key("reading", &MeasuredSource::reading)
      .required()
      .doc(
          "history of the results that it is held against; \"shear_force\", \"caisson/displacement_x\", "
          "\"probes/A/pressure\"");
  table.key("column", &MeasuredSource::column).fallback("the one after the time").doc("name of its column");
  table.key("unit", &MeasuredSource::unit).fallback("that of the header, else SI").doc("unit of the values");
  add_clock_keys(
      table, [](auto& entry) -> auto& { return entry; });
  return table;
}

}  // namespace upbead
