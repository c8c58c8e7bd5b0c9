// Records of loads, as histories and by transducers: their keys, declared and checked, and the loads made of them.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "case/case_schema.h"
#include "case/records/record_layout.h"
#include "input/schema.h"
#include "model/record.h"
#include "upbead/case/case.h"
#include "upbead/input/document.h"
#include "upbead/model/scene.h"

namespace upbead {

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

/// Names of the places: heights of a wall, or positions along a bottom.
struct GaugeWords {
  const char *places, *places_doc, *to_first, *to_last, *ends_doc, *first, *last;
};
extern const GaugeWords wall_words, bottom_words;

extern const std::vector<std::pair<std::string, Beyond>> beyond_words;

/// Declares the keys; they belong where `belongs` holds (see Entry::when). The keys of the pressure beyond the row
/// belong where `beyond_belongs` holds.
template <class T>
void add_gauge_keys(TableSchema<T>& table, const GaugeWords& words, const std::function<bool(const T&)>& belongs,
                    const std::string& where, const std::function<bool(const T&)>& beyond_belongs) {
  const auto in = [&](const Entry<T>& entry) { return entry.when("kind", belongs, where); };
  const auto beyond = [&](const Entry<T>& entry) { return entry.when("kind", beyond_belongs, where); };
  in(table.key("gauges", &T::gauges))
      .doc(
          "path of the transducers' record; a table as text (units in the header, any separator and decimal sign, .gz) "
          "or HDF5 (/time and others)");
  in(table.key(words.places, &T::place)).unit("m").doc(words.places_doc);
  in(table.key("ends", &T::ends)).unit("m").doc(words.ends_doc);
  beyond(table.choice(words.to_first, &T::to_first, beyond_words))
      .fallback("required with gauges")
      .doc(
          std::string("pressure from the ") + words.first +
          " transducer outward; constant: the same; none: zero; to_zero: linearly to zero at ends; must be said, as no "
          "rule is right for all walls");
  beyond(table.choice(words.to_last, &T::to_last, beyond_words))
      .fallback("required with gauges")
      .doc(std::string("pressure from the ") + words.last + " transducer outward");
  in(table.key("gauge_unit", &T::gauge_unit))
      .fallback("that of the header, else Pa")
      .doc("unit of the pressures; such as \"kPa\"");
  const auto has_clock = [belongs](const T& source) { return belongs(source) || !source.history_file.empty(); };
  add_clock_keys(table, in,
                 [&](const Entry<T>& entry) { return entry.when("kind", has_clock, where + ", or of a history"); });
  in(table.key("load_cell", &T::load_cell))
      .fallback("none")
      .doc("name of the column with the force by a load cell (N/m); compared with the transducers, not applied");
}

/// Reports keys that are missing or contradict each other; `path`: of their table.
void check_gauges(const GaugeSource& source, const GaugeWords& words, const std::string& path, const Document& document,
                  Diagnostics& report);

/// The record in SI units and in the run's time, from t = 0 on; `notes` gets how it was read. Throws InputError with
/// every mistake, at the file's lines or at the keys of `path`.
Gauges read_gauges(const GaugeSource& source, const std::string& file, const std::string& path,
                   const Document& document, RecordNotes& notes);

/// Adds a pressure NAME.TRANSDUCER for each transducer with a pressure other than zero, spread over the wall as
/// `share` says, in a run until `end` (s).
void add_gauge_loads(const std::string& name, const GaugeLoad& by_gauges, double end, Scene& scene);

/// U(t) of transducers along a bottom between its ends (N/m); zero where it would be negative. Throws InputError
/// where it is never positive.
TimeFunction uplift_of(const GaugeLoad& by_gauges);

/// The pressure of each transducer over the bottom, without suction.
std::vector<UpliftPart> uplift_parts_of(const Gauges& gauges);

TableSchema<MeasuredSource> measured_schema();

/// Fills `load` from the file `path` (CSV or HDF5), in a run until `end` (s): the time is the column whose header
/// says so, the value the first other column that is no counter. Throws InputError where the file cannot be read, has
/// fewer than two columns or rows, has times that do not ascend from 0, or only zeros. Two samples at one time are a
/// jump. `place`: the key that names the file; `start`: the record's time at t = 0 of the run (s); `notes` gets how it
/// was read.
void read_history(const std::string& path, const Place& place, double end, Load& load, double start,
                  RecordNotes& notes);

/// The samples of such a file, as written.
Record written_history(const std::string& name, const std::string& path, const Place& place, LoadKind kind,
                       double start);

/// U(t) of a prescribed uplift from such a file; it may be zero, but not negative. Throws InputError as above.
TimeFunction read_uplift(const std::string& path, const Place& place, double start, RecordNotes& notes);

}  // namespace upbead
