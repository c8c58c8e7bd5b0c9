#include "case/load_source.h"

#include <algorithm>

#include "case/load_table.h"

namespace upbead {

const LoadWay& way_of(const LoadTable& table) {
  const auto& ways = load_ways();
  return *std::find_if(ways.rbegin(), ways.rend(), [&](const LoadWay& way) { return way.gives(table); });
}

void begin(const GivenLoad& given, LoadSource& source) {
  source.name = given.name;
  source.title = "loads." + given.name;
  source.load = given.table;
}

std::shared_ptr<LoadSource> begun(const GivenLoad& given) {
  auto source = std::make_shared<LoadSource>();
  begin(given, *source);
  return source;
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
