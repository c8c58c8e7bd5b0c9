// The numbers within one value of a key, by its type in C++.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "input/values.h"

namespace upbead {

/// Sees one number with the declaration of its key (the unit is that of this number) and its dotted path, and may
/// change it.
using NumberVisitor = std::function<void(const KeyInfo& key, const std::string& path, double& number)>;

void visit_value(const KeyInfo& key, const std::string& path, double& value, const NumberVisitor& visitor);
void visit_value(const KeyInfo& key, const std::string& path, Pair& value, const NumberVisitor& visitor);
void visit_value(const KeyInfo& key, const std::string& path, std::vector<Pair>& value, const NumberVisitor& visitor);
/// Each at the path of its name below `path`.
void visit_value(const KeyInfo& key, const std::string& path, std::map<std::string, double>& value,
                 const NumberVisitor& visitor);
/// What holds no number with a unit: whole numbers count things.
inline void visit_value(const KeyInfo&, const std::string&, int&, const NumberVisitor&) {}
inline void visit_value(const KeyInfo&, const std::string&, bool&, const NumberVisitor&) {}
inline void visit_value(const KeyInfo&, const std::string&, std::string&, const NumberVisitor&) {}

template <class V>
void visit_value(const KeyInfo& key, const std::string& path, std::optional<V>& value, const NumberVisitor& visitor) {
  if (value) visit_value(key, path, *value, visitor);
}

}  // namespace upbead
