// What a header says of its column, in the words that laboratories use: a time, a counter, a unit.
#pragma once

#include <optional>
#include <string>

#include "base/units.h"

namespace upbead {

/// How surely the header says that a column is the time, in ascending order.
enum class HeaderSays {
  nothing,
  counter,        ///< Part, Step, No., #, Index, Sample, Zeitschritt
  another_clock,  ///< Real time, CPU time, Timestamp
  unit_of_time,   ///< a unit of time after some other name, or [s] alone
  capital,        ///< T
  letter,         ///< t
  kind_of_time,   ///< Elapsed time, Time 1 - default sample rate
  time            ///< Time, Zeit, Temps, Tiempo, time_ms
};

/// Judges a header; `name` and `unit` are as base/csv.h splits them. A column with a unit of another quantity is no
/// time, whatever its name.
HeaderSays header_says(const std::string& name, const std::string& unit);

/// The unit of time that a header gives, as base/units.h knows it: "ms" of "Time [MS]", of "t_ms", of "[ms]"; "" of
/// "Time".
std::string unit_of_time(const std::string& name, const std::string& unit);

/// A unit at the end of a name, as in "p1_kPa", "P1 kPa", "F_KN_M" (kN/m), "acc_g".
struct UnitAtEnd {
  std::string name, unit;  ///< "p1", "kPa"
  Unit known;
};

/// Such a unit, if any; the longest that is known.
std::optional<UnitAtEnd> unit_at_end(const std::string& name);

/// A unit of force or pressure that stands in a name in a form that is not read, as in "U kN m-1", "{kPa}", "p1kPa",
/// "ForceKN", "in MN per metre"; "" without one.
std::string unread_unit(const std::string& name);

/// Whether the end of a name may as well be a part of it: "x_s", "p_min", "u_m", where these are no units of the
/// quantity.
bool may_be_a_name(const std::string& unit);

}  // namespace upbead
