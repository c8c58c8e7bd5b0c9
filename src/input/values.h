// How one value of a key is read, named and written, by its type in C++.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "input/range.h"
#include "upbead/input/node.h"

namespace upbead {

/// What is declared about a key besides its type.
struct KeyInfo {
  std::string name;
  std::string unit;                ///< "" for a number without one
  std::string doc;                 ///< a noun phrase after "the"; what follows a ";" is for the reference only
  std::string fallback;            ///< the default in words, where it is none of the values
  std::string unit_of_first;       ///< in a list of pairs whose second number has another unit
  std::string word;                ///< stands for "not given", such as "auto"; "" where there is none
  std::string condition;           ///< where the key belongs, in words; "" for everywhere
  std::vector<std::string> words;  ///< allowed words of a choice
  Range range;
  bool required = false;

  /// What to give: the doc up to its ";" and the unit.
  std::string meaning() const;
};

using Pair = std::array<double, 2>;

/// What is wrong with a value, if anything.
Diagnostics read_value(const Node& node, const KeyInfo& key, double& value);
Diagnostics read_value(const Node& node, const KeyInfo& key, int& value);
Diagnostics read_value(const Node& node, const KeyInfo& key, bool& value);
Diagnostics read_value(const Node& node, const KeyInfo& key, std::string& value);
Diagnostics read_value(const Node& node, const KeyInfo& key, Pair& value);
Diagnostics read_value(const Node& node, const KeyInfo& key, std::vector<Pair>& value);
Diagnostics read_value(const Node& node, const KeyInfo& key, std::map<std::string, double>& value);
/// One of key.words; `index` is its place among them.
Diagnostics read_word(const Node& node, const KeyInfo& key, std::size_t& index);

template <class V>
Diagnostics read_value(const Node& node, const KeyInfo& key, std::optional<V>& value) {
  if (node.text() && !key.word.empty() && *node.text() == key.word) {
    value.reset();
    return {};
  }
  return read_value(node, key, value.emplace());
}

/// What a person is asked for: "a number (Pa)".
std::string type_text(const KeyInfo& key, const double*);
std::string type_text(const KeyInfo& key, const int*);
std::string type_text(const KeyInfo& key, const bool*);
std::string type_text(const KeyInfo& key, const std::string*);
std::string type_text(const KeyInfo& key, const Pair*);
std::string type_text(const KeyInfo& key, const std::vector<Pair>*);
std::string type_text(const KeyInfo& key, const std::map<std::string, double>*);

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
std::string print_value(const KeyInfo& key, const std::map<std::string, double>& value);

template <class V>
std::string print_value(const KeyInfo& key, const std::optional<V>& value) {
  if (value) return print_value(key, *value);
  return key.word.empty() ? "" : to_toml(key.word);
}

}  // namespace upbead
