// One declared key of a table that fills a struct T.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "input/numbers.h"
#include "input/values.h"
#include "upbead/base/error.h"

namespace upbead {

/// A row of the reference.
struct KeyRow {
  std::string key, type, range, standard, meaning;
};

/// The reference of one table.
struct TableDoc {
  std::string path, doc;
  std::vector<KeyRow> rows;
};

/// What a schema needs of a key, whatever its type. Made by TableSchema; the named setters are for the declaration.
template <class T>
class Entry {
 public:
  explicit Entry(std::string name) { info.name = std::move(name); }

  Entry& unit(std::string text) { return set(info.unit, std::move(text)); }
  /// Unit of the first number of a list of pairs; unit() is then that of the second.
  Entry& unit_of_first(std::string text) { return set(info.unit_of_first, std::move(text)); }
  Entry& range(Range range) { return set(info.range, range); }
  /// A noun phrase for "give the ..."; text after a ";" is for the reference only.
  Entry& doc(std::string text) { return set(info.doc, std::move(text)); }
  /// The default in words, for a key whose default follows from others.
  Entry& fallback(std::string text) { return set(info.fallback, std::move(text)); }
  /// A word that stands for "not given" in an optional member.
  Entry& or_word(std::string word) { return set(info.word, std::move(word)); }
  Entry& required() { return set(info.required, true); }
  /// The key belongs only where `belongs` holds; judged once `decisive_key`, declared before, is read and sound.
  Entry& when(std::string decisive_key, std::function<bool(const T&)> belongs, std::string in_words) {
    decisive = std::move(decisive_key);
    condition = std::move(belongs);
    return set(info.condition, std::move(in_words));
  }

  bool belongs_to(const T& object) const { return !condition || condition(object); }

  KeyInfo info;
  std::string decisive;
  std::function<bool(const T&)> condition;
  /// Reads `node`, which stands at the dotted path, into the object.
  std::function<void(const KeyInfo&, const Node& node, const std::string& path, T& object, Diagnostics&)> read;
  /// The value as TOML, "" where it is not given or a table with its own header.
  std::function<std::string(const KeyInfo&, const T&)> print;
  /// Tables below, with headers.
  std::function<std::string(const T&, const std::string& path)> print_tables;
  /// Shows every number of the key and of the tables below to a visitor, which may change it.
  std::function<void(const KeyInfo&, const std::string& path, T& object, const NumberVisitor&)> visit_numbers;
  std::function<std::string(const KeyInfo&)> type;
  std::function<void(const std::string& path, const std::string& doc, std::vector<TableDoc>&)> describe_tables;

 private:
  template <class Member, class Value>
  Entry& set(Member& member, Value&& value) {
    member = std::forward<Value>(value);
    return *this;
  }
};

}  // namespace upbead
