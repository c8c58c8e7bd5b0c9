#include <set>

#include "../case_checks.h"
#include "gauge_keys.h"

namespace upbead {

void check_gauges(const GaugeSource& source, const GaugeWords& words, const std::string& path, const Document& document,
                  InputReport& report) {
  const Objections objections(path, document, report);
  const auto given = [&](const std::string& key) { return document.find(path + "." + key) != nullptr; };
  if (source.gauges.empty())
    objections.add({"gauges", "there is no record of the pressures", "add gauges = the path of their record"});
  if (source.place.empty())
    objections.add({words.places, std::string("it is not said where the transducers are"),
                    std::string("add ") + words.places + " = { COLUMN = ..., ... } (m)"});
  for (const char* key : {words.to_first, words.to_last})
    if (!given(key))
      objections.add({key,
                      std::string("it is not said how the pressure goes on beyond the transducers: no '") + key + "'",
                      std::string("add ") + key + " = \"constant\", \"none\" or \"to_zero\""});
  std::set<double> seen;
  for (const auto& [name, at] : source.place)
    if (!seen.insert(at).second)
      objections.add(
          {words.places, "two transducers are at " + number_text(at) + " m", "give each a place of its own"});
  if ((source.to_first == Beyond::to_zero || source.to_last == Beyond::to_zero) && !source.ends)
    objections.add({"ends", "'to_zero' needs the places where the pressure is zero", "add ends = [..., ...] (m)"});
  if (!source.ends || seen.empty()) return;
  if (!((*source.ends)[0] < *seen.begin() && *seen.rbegin() < (*source.ends)[1]))
    objections.add(
        {"ends", "a transducer is not between the ends", "give the ends of the whole row, the lower one first"});
}

}  // namespace upbead
