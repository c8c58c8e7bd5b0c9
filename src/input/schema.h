// The keys of a TOML table, each declared once. The declaration serves for reading with checks, unknown and missing
// keys, defaults, the echo as TOML, the reference, and the JSON Schema.
//
//   TableSchema<Fluid> table;
//   table.key("density", &Fluid::density, "kg/m3", "density of the water", above(0.));
//
// Defaults are those of a default-constructed T.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/text.h"
#include "input/values.h"

namespace upbead {

class Table;

/// A declared key. Objects, values and parts have no type here: only a TableSchema knows which struct it fills.
struct Key {
  KeyInfo info;
  std::string decisive;                            ///< the key that decides whether this one belongs
  std::function<bool(const void*)> belongs;        ///< whether the key belongs to that object; none: to all
  const ValueType* type = nullptr;                 ///< none: a choice or a table, not a value
  std::function<void*(void*)> value;               ///< address of the value in an object
  std::function<void(void*, std::size_t)> choose;  ///< sets it to one of info.words
  std::function<std::optional<std::size_t>(const void*)> chosen;  ///< the word chosen; none where it is not given
  std::shared_ptr<const Table> table;                             ///< schema of the table; none: not a table
  bool named = false;                                             ///< any number of tables, each by its name
  std::function<void*(void*, const std::string& name)> make;      ///< the part of an object that a table fills
  std::function<std::vector<std::pair<std::string, void*>>(void*)> parts;  ///< the parts that are given
};

/// What all schemas do, whatever struct they fill.
class Table {
 public:
  /// `make`: makes an object with all defaults.
  explicit Table(std::function<std::shared_ptr<void>()> make) : make_(std::move(make)), standard_(make_()) {}
  const std::vector<Key>& keys() const { return keys_; }
  /// Keys that may stand in the table and are read by another schema.
  const std::vector<std::string>& elsewhere() const { return elsewhere_; }
  std::shared_ptr<void> make() const { return make_(); }
  Key& add(const std::string& name);
  void leave(const std::vector<std::string>& names) { elsewhere_ = names; }
  void read(const Node& node, const std::string& path, void* object, Diagnostics& report) const;
  /// `without`: keys of this table that are left out.
  std::string echo(const void* object, const std::string& path, const std::vector<std::string>& without = {}) const;
  void visit_numbers(void* object, const std::string& path, const NumberVisitor& visitor) const;
  /// Every table and key as Markdown, depth first.
  std::string reference(const std::string& path, const std::string& doc) const;

 private:
  std::function<std::shared_ptr<void>()> make_;
  std::shared_ptr<const void> standard_;  ///< an object with all defaults
  std::vector<Key> keys_;
  std::vector<std::string> elsewhere_;
};

/// JSON Schema (draft 4, which editors read) of a file with this table, for completion and checks while one types:
/// types, units, ranges, words, missing and unknown keys, and keys that do not belong with the word of a choice. Only
/// the program can check what depends on more than one other key, or on a mesh.
std::string json_schema(const Table& table, const std::string& title);

/// Declares further properties of a key. The named setters can be chained.
template <class T>
class Entry {
 public:
  explicit Entry(Key& key) : key_(key) {}

  Entry unit(std::string text) const { return set(key_.info.unit, std::move(text)); }
  /// Unit of the first number of a list of pairs; unit() is then that of the second.
  Entry unit_of_first(std::string text) const { return set(key_.info.unit_of_first, std::move(text)); }
  Entry range(Range range) const { return set(key_.info.range, range); }
  /// The meaning, as a noun phrase after "give the"; text after a ";" is for the reference only.
  Entry doc(std::string text) const { return set(key_.info.doc, std::move(text)); }
  /// The default in words, for a key whose default follows from others.
  Entry fallback(std::string text) const { return set(key_.info.fallback, std::move(text)); }
  /// A word that stands for "not given" in an optional member.
  Entry or_word(std::string word) const { return set(key_.info.word, std::move(word)); }
  Entry required() const { return set(key_.info.required, true); }
  /// An older name of the key: still accepted, with a note that states the new name.
  Entry formerly(std::string name) const { return set(key_.info.former, std::move(name)); }
  /// An older word of a choice: still accepted, with a note that states the new word.
  Entry formerly_word(std::string former, std::string now) const {
    return set(key_.info.former_words[std::move(former)], std::move(now));
  }
  /// The key belongs only where `belongs` holds; checked once `decisive_key`, declared before this key, is read and
  /// valid.
  Entry when(std::string decisive_key, std::function<bool(const T&)> belongs, std::string in_words) const {
    key_.decisive = std::move(decisive_key);
    key_.belongs = [belongs = std::move(belongs)](const void* object) {
      return belongs(*static_cast<const T*>(object));
    };
    return set(key_.info.condition, std::move(in_words));
  }
  const std::string& name() const { return key_.info.name; }

 private:
  template <class Member, class Value>
  Entry set(Member& member, Value&& value) const {
    member = std::forward<Value>(value);
    return *this;
  }
  Key& key_;
};

template <class T>
class TableSchema {
 public:
  /// A value: double, int, bool, string, Pair, list of Pair, table of numbers, or an optional of those.
  template <class V, class Base>
  Entry<T> key(const std::string& name, V Base::*member) {
    return Entry<T>(add_key(name, member));
  }
  /// With its unit ("" where it has none), meaning (see Entry::doc()) and range.
  template <class V, class Base>
  Entry<T> key(const std::string& name, V Base::*member, const std::string& unit, const std::string& meaning,
               const Range& range = {}) {
    return key(name, member).unit(unit).doc(meaning).range(range);
  }

  /// An enum (or an optional one), written as a word.
  template <class V, class Base, class Enum>
  Entry<T> choice(const std::string& name, V Base::*member, const std::vector<std::pair<std::string, Enum>>& words) {
    Key& key = table_->add(name);
    for (const auto& [word, value] : words) key.info.words.push_back(word);
    key.choose = [member, words](void* object, std::size_t i) { static_cast<T*>(object)->*member = words[i].second; };
    key.chosen = [member, words](const void* object) -> std::optional<std::size_t> {
      const std::optional<Enum> value = static_cast<const T*>(object)->*member;
      for (std::size_t i = 0; i < words.size(); ++i)
        if (value == words[i].second) return i;
      return {};
    };
    return Entry<T>(key);
  }
  template <class V, class Base, class Enum>
  Entry<T> choice(const std::string& name, V Base::*member, const std::vector<std::pair<std::string, Enum>>& words,
                  const std::string& meaning) {
    return choice(name, member, words).doc(meaning);
  }

  /// A value that fills one member, or a table that fills another: `name = 1.0` or `name = { ... }`.
  template <class V, class U, class Base>
  Entry<T> key_or_table(const std::string& name, V Base::*member, std::optional<U> Base::*other,
                        const TableSchema<U>& schema) {
    return fill(add_key(name, member), other, schema);
  }

  /// A table that fills a member of T.
  template <class U, class Base>
  Entry<T> table(const std::string& name, U Base::*member, const TableSchema<U>& schema) {
    return add_table(name, schema, [member](void* object) { return &(static_cast<T*>(object)->*member); });
  }
  template <class U, class Base>
  Entry<T> table(const std::string& name, std::optional<U> Base::*member, const TableSchema<U>& schema) {
    return fill(table_->add(name), member, schema);
  }

  /// A table whose keys fill T itself.
  Entry<T> section(const std::string& name, const TableSchema<T>& schema) {
    return add_table(name, schema, [](void* object) { return object; });
  }

  /// Any number of tables by name: [name.NAME].
  template <class U, class Base>
  Entry<T> tables(const std::string& name, std::map<std::string, U> Base::*member, const TableSchema<U>& schema) {
    Key& key = table_->add(name);
    key.named = true;
    key.table = schema.table_;
    key.make = [member](void* object, const std::string& part) { return &(static_cast<T*>(object)->*member)[part]; };
    key.parts = [member](void* object) {
      std::vector<std::pair<std::string, void*>> list;
      for (auto& [part, value] : static_cast<T*>(object)->*member) list.emplace_back(part, &value);
      return list;
    };
    return Entry<T>(key);
  }

  /// The declared keys.
  std::vector<std::string> names() const {
    std::vector<std::string> list;
    for (const Key& key : table_->keys()) list.push_back(key.info.name);
    return list;
  }

  /// Keys that may stand in the table and are left to another schema, which checks them.
  TableSchema& elsewhere(const std::vector<std::string>& names) {
    table_->leave(names);
    return *this;
  }

  /// Reads the table `node` at the dotted path ("" for the root) into `object`; mistakes go to `report`.
  void read(const Node& node, const std::string& path, T& object, Diagnostics& report) const {
    table_->read(node, path, &object, report);
  }
  /// `object` as TOML with all defaults spelled out, readable by read().
  std::string echo(const T& object, const std::vector<std::string>& without = {}) const {
    return table_->echo(&object, "", without);
  }
  /// Passes every number that belongs to `object`, with its declaration and dotted path, to a visitor that may change
  /// it.
  void visit_numbers(T& object, const std::string& path, const NumberVisitor& visitor) const {
    table_->visit_numbers(&object, path, visitor);
  }
  /// As Markdown.
  std::string reference() const { return table_->reference("", ""); }
  /// As JSON Schema.
  std::string json_schema(const std::string& title) const { return upbead::json_schema(*table_, title); }

 private:
  template <class U>
  friend class TableSchema;

  template <class V, class Base>
  Key& add_key(const std::string& name, V Base::*member) {
    Key& key = table_->add(name);
    key.type = value_type<V>();
    key.value = [member](void* object) { return &(static_cast<T*>(object)->*member); };
    return key;
  }

  /// `part`: finds the member that the table fills.
  template <class U, class Part>
  Entry<T> add_table(const std::string& name, const TableSchema<U>& schema, const Part& part) {
    Key& key = table_->add(name);
    key.table = schema.table_;
    key.make = [part](void* object, const std::string&) { return part(object); };
    key.parts = [part](void* object) { return std::vector<std::pair<std::string, void*>>{{"", part(object)}}; };
    return Entry<T>(key);
  }

  template <class U, class Base>
  Entry<T> fill(Key& key, std::optional<U> Base::*member, const TableSchema<U>& schema) {
    key.table = schema.table_;
    key.make = [member](void* object, const std::string&) { return &(static_cast<T*>(object)->*member).emplace(); };
    key.parts = [member](void* object) {
      std::optional<U>& part = static_cast<T*>(object)->*member;
      std::vector<std::pair<std::string, void*>> list;
      if (part) list.emplace_back("", &*part);
      return list;
    };
    return Entry<T>(key);
  }

  std::shared_ptr<Table> table_ = std::make_shared<Table>([] { return std::make_shared<T>(); });
};

/// The reference of a schema as Markdown.
template <class T>
std::string reference(const TableSchema<T>& schema) {
  return schema.reference();
}

}  // namespace upbead
