// Numbers of a key: a list, or a range of which a person gives both ends.
#pragma once

#include <string>
#include <vector>

#include "input/values.h"

namespace upbead {

/// `[0.2, 0.4, 0.8]`, or `{ from = 0.2, to = 0.8, n = 4 }` at equal distances.
struct NumberList {
  std::vector<double> values;
};

Diagnostics read_value(const Node& node, const KeyInfo& key, NumberList& value);
std::string type_text(const KeyInfo& key, const NumberList*);
/// Always as a list.
std::string print_value(const KeyInfo& key, const NumberList& value);
void visit_value(const KeyInfo& key, const std::string& path, NumberList& value, const NumberVisitor& visitor);

}  // namespace upbead
