// What the header of a column says of it, in the words of laboratories.
#pragma once

#include <string>

namespace upbead {

/// How surely a column is the time, least first.
enum class HeaderSays {
  nothing,
  counter,        ///< Part, Step, No., #, Index, Sample, Zeitschritt
  another_clock,  ///< Real time, CPU time, Timestamp
  unit_of_time,   ///< a unit of time behind some name, or [s] alone
  capital,        ///< T
  letter,         ///< t
  kind_of_time,   ///< Elapsed time, Time 1 - default sample rate
  time            ///< Time, Zeit, Temps, Tiempo, time_ms
};

/// `name` and `unit` as base/csv.h has them. A column with a unit of another quantity is no time, whatever its name.
HeaderSays header_says(const std::string& name, const std::string& unit);

/// The unit of time that a header gives, as base/units.h knows it: "ms" of "Time [MS]", of "t_ms", of "[ms]"; "" of
/// "Time".
std::string unit_of_time(const std::string& name, const std::string& unit);

}  // namespace upbead
