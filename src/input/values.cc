#include "input/values.h"

#include <cmath>
#include <cstdlib>
#include <type_traits>

#include "base/numbers.h"
#include "base/text.h"

namespace upbead {

bool Range::contains(double value) const {
  return (value > low_ || (low_belongs_ && value == low_)) && (value < high_ || (high_belongs_ && value == high_));
}

std::string Range::text() const {
  if (low_ == -infinity && high_ == infinity && !high_belongs_) return "any finite number";
  return (low_belongs_ ? "[" : "(") + number_text(low_) + ", " + number_text(high_) + (high_belongs_ ? "]" : ")");
}

Range above(double low) {
  return {low, false, infinity, false};
}
Range at_least(double low) {
  return {low, true, infinity, false};
}
Range between(double low, double high) {
  return {low, false, high, false};
}
Range from_to(double low, double high) {
  return {low, true, high, true};
}
Range from_to_below(double low, double high) {
  return {low, true, high, false};
}

std::string KeyInfo::meaning() const {
  return doc.substr(0, doc.find(';')) + (unit.empty() ? "" : " (" + unit + ")");
}

namespace {

bool reads_as_number(const std::string& text) {
  char* end = nullptr;
  std::strtod(text.c_str(), &end);
  return !text.empty() && end == text.c_str() + text.size();
}

template <class V>
Diagnostics wrong_type(const Node& node, const KeyInfo& key, const V* type) {
  const std::string expected =
      key.word.empty() ? type_text(key, type) : type_text(key, type) + " or " + to_toml(key.word);
  std::string cure = "give the " + key.meaning();
  if (node.text() && reads_as_number(*node.text())) cure = "write the number without quotes";
  if (std::is_same_v<V, bool>) cure = "write true or false";
  return {{node.place, key.name + ": expected " + expected + ", found " + found(node), cure}};
}

std::optional<double> number_of(const Node& node) {
  if (const auto* value = std::get_if<double>(&node.value)) return *value;
  if (const auto* value = std::get_if<std::int64_t>(&node.value)) return static_cast<double>(*value);
  return {};
}

Diagnostics check_range(const Node& node, const KeyInfo& key, double value) {
  if (std::isfinite(value) && (is_too_large(value) || is_too_small(value)))
    return {{node.place,
             key.name + " = " + number_text(value) + " is " + (is_too_large(value) ? "larger" : "smaller") +
                 " than any quantity in SI units",
             "give the " + key.meaning()}};
  if (key.range.contains(value)) return {};
  return {{node.place, key.name + " = " + number_text(value) + " is outside " + key.range.text(),
           "give the " + key.meaning()}};
}

std::string with_unit(const std::string& what, const KeyInfo& key) {
  return key.unit.empty() ? what : what + " (" + key.unit + ")";
}

}  // namespace

Diagnostics read_value(const Node& node, const KeyInfo& key, double& value) {
  const std::optional<double> number = number_of(node);
  if (!number) return wrong_type(node, key, &value);
  value = *number;
  return check_range(node, key, value);
}

Diagnostics read_value(const Node& node, const KeyInfo& key, int& value) {
  const auto* number = std::get_if<std::int64_t>(&node.value);
  if (!number) return wrong_type(node, key, &value);
  Diagnostics wrong = check_range(node, key, static_cast<double>(*number));
  if (wrong.empty() && *number != static_cast<int>(*number))
    return {{node.place, key.name + " = " + std::to_string(*number) + " is beyond the range of whole numbers here",
             "give the " + key.meaning()}};
  if (wrong.empty()) value = static_cast<int>(*number);
  return wrong;
}

Diagnostics read_value(const Node& node, const KeyInfo& key, bool& value) {
  const auto* truth = std::get_if<bool>(&node.value);
  if (!truth) return wrong_type(node, key, &value);
  value = *truth;
  return {};
}

Diagnostics read_value(const Node& node, const KeyInfo& key, std::string& value) {
  if (!node.text()) return wrong_type(node, key, &value);
  value = *node.text();
  return {};
}

Diagnostics read_value(const Node& node, const KeyInfo& key, Pair& value) {
  const NodeArray* list = node.array();
  if (!list || list->size() != 2) return wrong_type(node, key, &value);
  for (std::size_t i = 0; i < 2; ++i) {
    const std::optional<double> number = number_of((*list)[i]);
    if (!number) return wrong_type((*list)[i], key, &value);
    value[i] = *number;
    Diagnostics wrong = check_range((*list)[i], key, value[i]);
    if (!wrong.empty()) return wrong;
  }
  return {};
}

namespace {

template <class Item>
Diagnostics read_items(const Node& node, const KeyInfo& key, std::vector<Item>& value) {
  const NodeArray* list = node.array();
  if (!list) return wrong_type(node, key, &value);
  value.clear();
  Diagnostics all;
  for (const Node& item : *list) all.add(read_value(item, key, value.emplace_back()));
  return all;
}

}  // namespace

Diagnostics read_value(const Node& node, const KeyInfo& key, std::vector<Pair>& value) {
  return read_items(node, key, value);
}

Diagnostics read_value(const Node& node, const KeyInfo& key, std::vector<double>& value) {
  return read_items(node, key, value);
}

Diagnostics read_value(const Node& node, const KeyInfo& key, std::vector<std::string>& value) {
  return read_items(node, key, value);
}

Diagnostics read_value(const Node& node, const KeyInfo& key, std::map<std::string, double>& value) {
  if (!node.table()) return wrong_type(node, key, &value);
  Diagnostics all;
  for (const auto& [name, entry] : *node.table()) {
    KeyInfo inner = key;
    inner.name = name;
    all.add(read_value(entry, inner, value[name]));
  }
  return all;
}

Diagnostics read_word(const Node& node, const KeyInfo& key, std::size_t& index) {
  const std::string list = join(key.words);
  if (!node.text())
    return {{node.place, key.name + ": expected one of " + list + ", found " + found(node),
             "write " + key.name + " = " + to_toml(key.words.front())}};
  const auto former = key.former_words.find(*node.text());
  const std::string& word = former == key.former_words.end() ? *node.text() : former->second;
  Diagnostics found_word;
  if (word != *node.text())
    found_word.note(node.place, in_quotes(former->first) + " is called " + in_quotes(word) + " now");
  for (index = 0; index < key.words.size(); ++index)
    if (key.words[index] == word) return found_word;
  const std::string near = nearest(*node.text(), key.words);
  return {{node.place, key.name + " = " + to_toml(excerpt(*node.text())) + " is none of " + list,
           near.empty() ? "choose one of them" : "did you mean " + in_quotes(near) + "?"}};
}

std::string type_text(const KeyInfo& key, const double*) {
  return with_unit("a number", key);
}
std::string type_text(const KeyInfo& key, const int*) {
  return with_unit("a whole number", key);
}
std::string type_text(const KeyInfo&, const bool*) {
  return "true or false";
}
std::string type_text(const KeyInfo&, const std::string*) {
  return "a string";
}
std::string type_text(const KeyInfo& key, const Pair*) {
  return with_unit("a pair of numbers", key);
}
std::string type_text(const KeyInfo& key, const std::vector<Pair>*) {
  return with_unit("a list of pairs", key);
}
std::string type_text(const KeyInfo& key, const std::vector<double>*) {
  return with_unit("a list of numbers", key);
}
std::string type_text(const KeyInfo& key, const std::map<std::string, double>*) {
  return with_unit("a table of numbers", key);
}

std::string type_text(const KeyInfo&, const std::vector<std::string>*) {
  return "a list of strings";
}

std::string print_value(const KeyInfo&, double value) {
  return to_toml(value);
}
std::string print_value(const KeyInfo&, int value) {
  return to_toml(value);
}
std::string print_value(const KeyInfo&, bool value) {
  return to_toml(value);
}
std::string print_value(const KeyInfo&, const std::string& value) {
  return value.empty() ? "" : to_toml(value);
}
std::string print_value(const KeyInfo&, const Pair& value) {
  return "[" + to_toml(value[0]) + ", " + to_toml(value[1]) + "]";
}

std::string print_value(const KeyInfo& key, const std::vector<Pair>& value) {
  std::vector<std::string> pairs;
  for (const Pair& pair : value) pairs.push_back(print_value(key, pair));
  return pairs.empty() ? "" : "[" + join(pairs) + "]";
}

std::string print_value(const KeyInfo&, const std::vector<double>& value) {
  std::vector<std::string> numbers;
  for (const double number : value) numbers.push_back(to_toml(number));
  return numbers.empty() ? "" : "[" + join(numbers) + "]";
}

std::string print_value(const KeyInfo&, const std::map<std::string, double>& value) {
  std::vector<std::string> entries;
  for (const auto& [name, number] : value) entries.push_back(dotted("", name) + " = " + to_toml(number));
  return entries.empty() ? "" : "{ " + join(entries) + " }";
}

std::string print_value(const KeyInfo&, const std::vector<std::string>& value) {
  std::vector<std::string> items;
  for (const std::string& item : value) items.push_back(to_toml(item));
  return items.empty() ? "" : "[" + join(items) + "]";
}

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

void visit_value(const KeyInfo& key, const std::string& path, std::vector<double>& value,
                 const NumberVisitor& visitor) {
  for (double& number : value) visitor(key, path, number);
}

void visit_value(const KeyInfo& key, const std::string& path, std::map<std::string, double>& value,
                 const NumberVisitor& visitor) {
  for (auto& [name, number] : value) visitor(key, dotted(path, name), number);
}

}  // namespace upbead
