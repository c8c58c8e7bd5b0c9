// How a value is read, described, written and changed, by its type in C++.
#pragma once

#include <array>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "upbead/input/node.h"

namespace upbead {

/// An interval; infinity belongs to it only where or_infinite() says so, nan never does.
class Range {
 public:
  /// Every finite number.
  Range() = default;
  Range(double low, bool low_belongs, double high, bool high_belongs)
      : low_(low), high_(high), low_belongs_(low_belongs), high_belongs_(high_belongs) {}

  Range or_infinite() const { return {low_, low_belongs_, high_, true}; }
  bool contains(double value) const;
  double low() const { return low_; }
  double high() const { return high_; }
  bool low_belongs() const { return low_belongs_; }
  bool high_belongs() const { return high_belongs_; }
  /// "[0, 0.5)", "any finite number".
  std::string text() const;

 private:
  double low_ = -std::numeric_limits<double>::infinity();
  double high_ = std::numeric_limits<double>::infinity();
  bool low_belongs_ = false;
  bool high_belongs_ = false;
};

Range above(double low);                       ///< (low, inf)
Range at_least(double low);                    ///< [low, inf)
Range between(double low, double high);        ///< (low, high)
Range from_to(double low, double high);        ///< [low, high]
Range from_to_below(double low, double high);  ///< [low, high)

/// What is declared about a key, apart from its type.
struct KeyInfo {
  std::string name;
  std::string former;              ///< an older name, still accepted; "" where there is none
  std::string unit;                ///< "" for a number without one
  std::string doc;                 ///< a noun phrase after "the"; what follows a ";" is for the reference only
  std::string fallback;            ///< the default in words, where it follows from other keys
  std::string unit_of_first;       ///< in a list of pairs, where the first number has another unit than the second
  std::string word;                ///< stands for "not given", such as "auto"; "" where there is none
  std::string condition;           ///< where the key belongs, in words; "" for everywhere
  std::vector<std::string> words;  ///< allowed words of a choice
  std::map<std::string, std::string> former_words;  ///< older words, still accepted, and the present words
  Range range;
  bool required = false;

  /// What to give: the doc up to its ";" and the unit.
  std::string meaning() const;
};

using Pair = std::array<double, 2>;

/// Reads a value; returns what is wrong with it, if anything.
Diagnostics read_value(const Node& node, const KeyInfo& key, double& value);
Diagnostics read_value(const Node& node, const KeyInfo& key, int& value);
Diagnostics read_value(const Node& node, const KeyInfo& key, bool& value);
Diagnostics read_value(const Node& node, const KeyInfo& key, std::string& value);
Diagnostics read_value(const Node& node, const KeyInfo& key, Pair& value);
Diagnostics read_value(const Node& node, const KeyInfo& key, std::vector<Pair>& value);
Diagnostics read_value(const Node& node, const KeyInfo& key, std::vector<double>& value);
Diagnostics read_value(const Node& node, const KeyInfo& key, std::map<std::string, double>& value);
Diagnostics read_value(const Node& node, const KeyInfo& key, std::vector<std::string>& value);
/// Reads one of key.words; `index` is its place in that list.
Diagnostics read_word(const Node& node, const KeyInfo& key, std::size_t& index);

template <class V>
Diagnostics read_value(const Node& node, const KeyInfo& key, std::optional<V>& value) {
  if (node.text() && !key.word.empty() && *node.text() == key.word) {
    value.reset();
    return {};
  }
  return read_value(node, key, value.emplace());
}

/// The type as a message asks for it: "a number (Pa)".
std::string type_text(const KeyInfo& key, const double*);
std::string type_text(const KeyInfo& key, const int*);
std::string type_text(const KeyInfo& key, const bool*);
std::string type_text(const KeyInfo& key, const std::string*);
std::string type_text(const KeyInfo& key, const Pair*);
std::string type_text(const KeyInfo& key, const std::vector<Pair>*);
std::string type_text(const KeyInfo& key, const std::vector<double>*);
std::string type_text(const KeyInfo& key, const std::map<std::string, double>*);
std::string type_text(const KeyInfo& key, const std::vector<std::string>*);

template <class V>
std::string type_text(const KeyInfo& key, const std::optional<V>*) {
  const std::string text = type_text(key, static_cast<const V*>(nullptr));
  return key.word.empty() ? text : text + " or " + to_toml(key.word);
}

/// The value as TOML; "" where it is not given: an empty optional without a word, an empty string or list.
std::string print_value(const KeyInfo& key, double value);
std::string print_value(const KeyInfo& key, int value);
std::string print_value(const KeyInfo& key, bool value);
std::string print_value(const KeyInfo& key, const std::string& value);
std::string print_value(const KeyInfo& key, const Pair& value);
std::string print_value(const KeyInfo& key, const std::vector<Pair>& value);
std::string print_value(const KeyInfo& key, const std::vector<double>& value);
std::string print_value(const KeyInfo& key, const std::map<std::string, double>& value);
std::string print_value(const KeyInfo& key, const std::vector<std::string>& value);

template <class V>
std::string print_value(const KeyInfo& key, const std::optional<V>& value) {
  if (value) return print_value(key, *value);
  return key.word.empty() ? "" : to_toml(key.word);
}

/// Sees one number with the declaration of its key (the unit is that of this number) and its dotted path, and may
/// change it.
using NumberVisitor = std::function<void(const KeyInfo& key, const std::string& path, double& number)>;

void visit_value(const KeyInfo& key, const std::string& path, double& value, const NumberVisitor& visitor);
void visit_value(const KeyInfo& key, const std::string& path, Pair& value, const NumberVisitor& visitor);
void visit_value(const KeyInfo& key, const std::string& path, std::vector<Pair>& value, const NumberVisitor& visitor);
void visit_value(const KeyInfo& key, const std::string& path, std::vector<double>& value, const NumberVisitor& visitor);
/// Visits each number at the path of its name below `path`.
void visit_value(const KeyInfo& key, const std::string& path, std::map<std::string, double>& value,
                 const NumberVisitor& visitor);
/// These types hold no number with a unit: whole numbers are counts.
inline void visit_value(const KeyInfo&, const std::string&, int&, const NumberVisitor&) {}
inline void visit_value(const KeyInfo&, const std::string&, bool&, const NumberVisitor&) {}
inline void visit_value(const KeyInfo&, const std::string&, std::string&, const NumberVisitor&) {}
inline void visit_value(const KeyInfo&, const std::string&, std::vector<std::string>&, const NumberVisitor&) {}

template <class V>
void visit_value(const KeyInfo& key, const std::string& path, std::optional<V>& value, const NumberVisitor& visitor) {
  if (value) visit_value(key, path, *value, visitor);
}

/// Form of a value, whatever it means; `list` and `table`: of any values.
enum class ValueShape {
  number,
  whole_number,
  truth,
  text,
  texts,
  pair,
  pairs,
  number_list,
  numbers,
  list_or_table,
  list,
  table,
  anything
};

inline ValueShape shape_of(const KeyInfo&, const double*) {
  return ValueShape::number;
}
inline ValueShape shape_of(const KeyInfo&, const int*) {
  return ValueShape::whole_number;
}
inline ValueShape shape_of(const KeyInfo&, const bool*) {
  return ValueShape::truth;
}
inline ValueShape shape_of(const KeyInfo&, const std::string*) {
  return ValueShape::text;
}
inline ValueShape shape_of(const KeyInfo&, const Pair*) {
  return ValueShape::pair;
}
inline ValueShape shape_of(const KeyInfo&, const std::vector<Pair>*) {
  return ValueShape::pairs;
}
inline ValueShape shape_of(const KeyInfo&, const std::vector<double>*) {
  return ValueShape::number_list;
}
inline ValueShape shape_of(const KeyInfo&, const std::map<std::string, double>*) {
  return ValueShape::numbers;
}
inline ValueShape shape_of(const KeyInfo&, const std::vector<std::string>*) {
  return ValueShape::texts;
}
template <class V>
ValueShape shape_of(const KeyInfo& key, const std::optional<V>*) {
  return shape_of(key, static_cast<const V*>(nullptr));
}

/// The functions for a value of some type, which take a pointer to it.
struct ValueType {
  ValueShape (*shape)(const KeyInfo& key);
  Diagnostics (*read)(const Node& node, const KeyInfo& key, void* value);
  std::string (*text)(const KeyInfo& key);
  std::string (*print)(const KeyInfo& key, const void* value);
  void (*visit)(const KeyInfo& key, const std::string& path, void* value, const NumberVisitor& visitor);
};

template <class V>
const ValueType* value_type() {
  static constexpr ValueType type{
      [](const KeyInfo& key) { return shape_of(key, static_cast<const V*>(nullptr)); },
      [](const Node& node, const KeyInfo& key, void* value) { return read_value(node, key, *static_cast<V*>(value)); },
      [](const KeyInfo& key) { return type_text(key, static_cast<const V*>(nullptr)); },
      [](const KeyInfo& key, const void* value) { return print_value(key, *static_cast<const V*>(value)); },
      [](const KeyInfo& key, const std::string& path, void* value, const NumberVisitor& visitor) {
        visit_value(key, path, *static_cast<V*>(value), visitor);
      }};
  return &type;
}

}  // namespace upbead
