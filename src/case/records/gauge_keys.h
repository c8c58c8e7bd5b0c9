// The keys of GaugeSource: declared, checked, followed.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "input/schema.h"
#include "record_clock_keys.h"
#include "upbead/case/case.h"
#include "upbead/input/document.h"

namespace upbead {

/// What the places are called: heights of a wall, positions along a bottom.
struct GaugeWords {
  const char *places, *places_doc, *to_first, *to_last, *ends_doc, *first, *last;
};
extern const GaugeWords wall_words, bottom_words;

extern const std::vector<std::pair<std::string, Beyond>> beyond_words;

/// Declares the keys; they belong where `belongs` holds (see Entry::when).
template <class T>
void add_gauge_keys(TableSchema<T>& table, const GaugeWords& words, const std::function<bool(const T&)>& belongs,
                    const std::string& where) {
  const auto in = [&](Entry<T>& entry) -> Entry<T>& { return entry.when("kind", belongs, where); };
  in(table.key("gauges", &T::gauges))
      .doc(
          "path of the transducers' record; CSV (units in the header, decimal commas, .gz) or HDF5 (/time and others)");
  in(table.key(words.places, &T::place)).unit("m").doc(words.places_doc);
  in(table.key("ends", &T::ends)).unit("m").doc(words.ends_doc);
  in(table.choice(words.to_first, &T::to_first, beyond_words))
      .fallback("required with gauges")
      .doc(
          std::string("pressure from the ") + words.first +
          " transducer outward; constant: the same; none: zero; to_zero: linearly to zero at ends; must be said, as no "
          "rule is right for all walls");
  in(table.choice(words.to_last, &T::to_last, beyond_words))
      .fallback("required with gauges")
      .doc(std::string("pressure from the ") + words.last + " transducer outward");
  in(table.key("gauge_unit", &T::gauge_unit))
      .fallback("that of the header, else Pa")
      .doc("unit of the pressures; such as \"kPa\"");
  add_clock_keys(table, in);
  in(table.key("load_cell", &T::load_cell))
      .fallback("none")
      .doc("name of the column with the force by a load cell (N/m); compared with the transducers, not applied");
}

/// Mistakes in the keys: what is missing or contradicts itself; `path`: of their table.
void check_gauges(const GaugeSource& source, const GaugeWords& words, const std::string& path, const Document& document,
                  InputReport& report);

/// The record, in SI units and the run's time, cut to what comes from t = 0 on. Throws InputError with every mistake,
/// at the file's lines or at the keys of `path`.
Gauges read_gauges(const GaugeSource& source, const std::string& file, const std::string& path,
                   const Document& document);

}  // namespace upbead
