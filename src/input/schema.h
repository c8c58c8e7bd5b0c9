// The keys of a TOML table, each declared once. From the declaration come: reading with checks, unknown and missing
// keys, defaults, the echo as TOML, and the reference.
//
//   TableSchema<Fluid> table;
//   table.key("density", &Fluid::density).unit("kg/m3").range(above(0.)).doc("density of the water");
//
// Defaults are those of a default-constructed T.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/text.h"
#include "input/entry.h"
#include "input/schema_text.h"

namespace upbead {

template <class T>
class TableSchema {
 public:
  /// A value: double, int, bool, string, Pair, list of Pair, table of numbers, or an optional of those.
  template <class V, class Base>
  Entry<T>& key(const std::string& name, V Base::*member);
  /// An enum (or an optional one) by word.
  template <class V, class Base, class Enum>
  Entry<T>& choice(const std::string& name, V Base::*member, std::vector<std::pair<std::string, Enum>> words);
  /// A value that fills one member, or a table that fills another: `name = 1.0` or `name = { ... }`.
  template <class V, class U, class Base>
  Entry<T>& key_or_table(const std::string& name, V Base::*member, std::optional<U> Base::*other,
                         const TableSchema<U>& schema);
  /// A table that fills a member of T.
  template <class U, class Base>
  Entry<T>& table(const std::string& name, U Base::*member, const TableSchema<U>& schema);
  template <class U, class Base>
  Entry<T>& table(const std::string& name, std::optional<U> Base::*member, const TableSchema<U>& schema);
  /// A table whose keys fill T itself.
  Entry<T>& section(const std::string& name, const TableSchema<T>& schema);
  /// Any number of tables by name: [name.NAME].
  template <class U, class Base>
  Entry<T>& tables(const std::string& name, std::map<std::string, U> Base::*member, const TableSchema<U>& schema);

  /// Reads the table `node` at the dotted path ("" for the root) into `object`; mistakes go to `report`.
  void read(const Node& node, const std::string& path, T& object, Diagnostics& report) const;
  /// `object` as TOML with all defaults spelled out, readable by read().
  std::string echo(const T& object, const std::string& path = "") const;
  /// Shows every number that belongs to `object`, with its declaration and dotted path, to a visitor that may change
  /// it.
  void visit_numbers(T& object, const std::string& path, const NumberVisitor& visitor) const;
  /// Every table and key, depth first.
  void describe(const std::string& path, const std::string& doc, std::vector<TableDoc>& docs) const;

 private:
  Entry<T>& add(const std::string& name) { return entries_.emplace_back(name); }
  /// `make` gives the part of a T that the schema fills, `find` the part or nullptr where it is not given.
  template <class U, class Make, class Find>
  Entry<T>& add_table(const std::string& name, const TableSchema<U>& schema, Make make, Find find);
  std::vector<std::string> names() const;

  std::vector<Entry<T>> entries_;
};

/// The reference of a schema as Markdown.
template <class T>
std::string reference(const TableSchema<T>& schema) {
  std::vector<TableDoc> docs;
  schema.describe("", "", docs);
  return markdown(docs);
}

}  // namespace upbead

#include "input/schema.templates.h"
