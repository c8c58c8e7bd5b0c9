#include "case_warnings.h"
#include "model/record.h"

namespace upbead {

namespace {

Record record_of(const std::string& name, const TimeFunction& f) {
  Record record{name, f.samples(), {}};
  for (const double t : record.time) record.value.push_back(f(t, t == record.time.back() ? t - 1e-12 * t : t));
  return record;
}

}  // namespace

NumberedWarnings history_warnings(const Case& input) {
  NumberedWarnings all;
  const auto add = [&all](const std::string& name, const TimeFunction& f) {
    if (f.samples().size() < 2) return;
    const NumberedWarnings found = record_warnings(record_of(name, f));
    all.insert(all.end(), found.begin(), found.end());
  };
  for (const auto& [name, source] : input.sources)
    if (const Load& load = input.scene.loads.at(name); !source.history.empty() && load.factor != 0.)
      add("loads." + name, load.history);
  if (!input.uplift_history.empty()) add("sliding.uplift", input.scene.sliding->uplift->history);
  return all;
}

}  // namespace upbead
