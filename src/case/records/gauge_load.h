// Loads by transducers: their keys, declared and checked, and the loads made of them.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "case/load_source.h"
#include "case/records/record_keys.h"
#include "upbead/input/document.h"
#include "upbead/model/scene.h"

namespace upbead {

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
  const auto of_clock = [&](const Entry<T>& entry) {
    return entry.when("kind", has_clock, where + ", or of a history");
  };
  add_clock_keys(table, in, of_clock);
  in(table.key("load_cell", &T::load_cell))
      .fallback("none")
      .doc("name of the column with the force by a load cell (N/m); compared with the transducers, not applied");
}

/// Reports keys that are missing or contradict each other; `path`: of their table.
void check_gauges(const GaugeKeys& keys, const GaugeWords& words, const std::string& path, const Document& document,
                  Diagnostics& report);

struct GaugeRecord {
  Gauges gauges;      ///< in SI units and in the run's time, from t = 0 on
  RecordNotes notes;  ///< how they were read
};

/// Throws InputError with every mistake, at the file's lines or at the keys of `path`.
GaugeRecord read_gauges(const GaugeKeys& keys, const std::string& file, const std::string& path,
                        const Document& document);

/// Makes a pressure NAME.TRANSDUCER for each transducer with a pressure other than zero, spread over the wall as
/// `share` says, with what they have in common from `load`, in a run until `end` (s).
std::map<std::string, Load> gauge_loads(const std::string& name, const Load& load, const Gauges& gauges, double end);

/// An uplift by transducers along the bottom between its ends, at the keys of [sliding.uplift].
std::shared_ptr<LoadSource> read_uplift_gauges(const GaugeKeys& keys, const Case& problem);

/// U(t) of such an uplift (N/m); zero where it would be negative. Throws InputError where it is never positive.
TimeFunction uplift_of(const LoadSource& by_gauges);

/// The pressure of each transducer over the bottom, without suction.
std::vector<UpliftPart> uplift_parts_of(const Gauges& gauges);

}  // namespace upbead
