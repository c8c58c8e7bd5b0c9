#include "case/load_source.h"

#include <algorithm>

#include "case/case_schema.h"

namespace upbead {

const std::vector<LoadWay>& load_ways() {
  static const std::vector<LoadWay> ways{by_pulse(), by_history(), by_wave(), by_train(), by_gauges(), by_flow()};
  return ways;
}

const LoadWay& way_of(const LoadTable& table) {
  const auto& ways = load_ways();
  return *std::find_if(ways.rbegin(), ways.rend(), [&](const LoadWay& way) { return way.gives(table); });
}

void begin(const GivenLoad& given, LoadSource& source) {
  source.name = given.name;
  source.title = "loads." + given.name;
  source.load = given.table;
}

Load with_factor(Load load) {
  if (load.factor != 0.) {
    load.history = scaled(load.history, load.factor);
    return load;
  }
  load.history = TimeFunction();
  load.duration.reset();
  return load;
}

std::vector<const LoadSource*> sources_of(const Case& input) {
  std::vector<const LoadSource*> list;
  for (const auto& [name, source] : input.sources) list.push_back(source.get());
  if (input.uplift) list.push_back(input.uplift.get());
  return list;
}

}  // namespace upbead
