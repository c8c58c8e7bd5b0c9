#include "literal.h"

#include <cmath>

#include "base/text.h"

namespace upbead {

namespace {

constexpr double largest_exact = 9007199254740992.;  // 2^53

Diagnostics refuse(const Node& node, const KeyInfo& key, const std::string& expected) {
  return {{node.place, key.name + ": expected " + expected + ", found " + found(node), "give the " + key.meaning()}};
}

Diagnostics read_settings(const Node& node, const KeyInfo& key, const std::string& path,
                          std::map<std::string, Literal>& value) {
  Diagnostics all;
  for (const auto& [name, entry] : *node.table()) {
    const std::string below = path.empty() ? name : path + "." + name;
    if (entry.table())
      all.add(read_settings(entry, key, below, value));
    else
      all.add(read_value(entry, key, value[below]));
  }
  return all;
}

}  // namespace

Literal literal(double number) {
  const bool whole = std::trunc(number) == number && std::abs(number) < largest_exact;
  return {whole ? std::to_string(static_cast<std::int64_t>(number)) : to_toml(number), true, number};
}

Diagnostics read_value(const Node& node, const KeyInfo& key, Literal& value) {
  if (const auto* truth = std::get_if<bool>(&node.value)) {
    value = {to_toml(*truth)};
  } else if (const auto* whole = std::get_if<std::int64_t>(&node.value)) {
    value = literal(static_cast<double>(*whole));
  } else if (const auto* number = std::get_if<double>(&node.value)) {
    value = literal(*number);
  } else if (node.text()) {
    value = {to_toml(*node.text())};
  } else if (node.array()) {
    std::vector<Literal> items;
    Diagnostics wrong = read_value(node, key, items);
    if (!wrong.empty()) return wrong;
    value = {print_value(key, items)};
  } else {
    return refuse(node, key, "a number, a word, true, false or a list");
  }
  return {};
}

Diagnostics read_value(const Node& node, const KeyInfo& key, std::vector<Literal>& value) {
  if (!node.array()) return refuse(node, key, type_text(key, &value));
  value.clear();
  Diagnostics all;
  for (const Node& item : *node.array()) all.add(read_value(item, key, value.emplace_back()));
  return all;
}

Diagnostics read_value(const Node& node, const KeyInfo& key, std::vector<std::string>& value) {
  if (!node.array()) return refuse(node, key, type_text(key, &value));
  value.clear();
  Diagnostics all;
  for (const Node& item : *node.array()) all.add(read_value(item, key, value.emplace_back()));
  return all;
}

Diagnostics read_value(const Node& node, const KeyInfo& key, std::map<std::string, Literal>& value) {
  if (!node.table()) return refuse(node, key, type_text(key, &value));
  return read_settings(node, key, "", value);
}

std::string type_text(const KeyInfo&, const Literal*) {
  return "a value";
}
std::string type_text(const KeyInfo&, const std::vector<Literal>*) {
  return "a list of values";
}
std::string type_text(const KeyInfo&, const std::vector<std::string>*) {
  return "a list of strings";
}
std::string type_text(const KeyInfo&, const std::map<std::string, Literal>*) {
  return "a table of values";
}

std::string print_value(const KeyInfo&, const Literal& value) {
  return value.toml;
}

std::string print_value(const KeyInfo&, const std::vector<Literal>& value) {
  std::vector<std::string> items;
  for (const Literal& item : value) items.push_back(item.toml);
  return items.empty() ? "" : "[" + join(items) + "]";
}

std::string print_value(const KeyInfo&, const std::vector<std::string>& value) {
  std::vector<std::string> items;
  for (const std::string& item : value) items.push_back(to_toml(item));
  return items.empty() ? "" : "[" + join(items) + "]";
}

std::string print_value(const KeyInfo&, const std::map<std::string, Literal>& value) {
  std::vector<std::string> items;
  for (const auto& [name, item] : value) items.push_back(to_toml(name) + " = " + item.toml);
  return items.empty() ? "" : "{ " + join(items) + " }";
}

}  // namespace upbead
