#include "input/numbers.h"

namespace upbead {

void visit_value(const KeyInfo& key, const std::string& path, double& value, const NumberVisitor& visitor) {
  visitor(key, path, value);
}

void visit_value(const KeyInfo& key, const std::string& path, Pair& value, const NumberVisitor& visitor) {
  for (double& number : value) visitor(key, path, number);
}

void visit_value(const KeyInfo& key, const std::string& path, std::vector<Pair>& value, const NumberVisitor& visitor) {
  KeyInfo first = key;
  if (!key.unit_of_first.empty()) first.unit = key.unit_of_first;
  for (Pair& pair : value) {
    visitor(first, path, pair[0]);
    visitor(key, path, pair[1]);
  }
}

void visit_value(const KeyInfo& key, const std::string& path, std::map<std::string, double>& value,
                 const NumberVisitor& visitor) {
  for (auto& [name, number] : value) visitor(key, dotted(path, name), number);
}

}  // namespace upbead
