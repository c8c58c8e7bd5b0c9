// The parts of TableSchema that depend on the type of a member; included by schema.h.
#pragma once

namespace upbead {

template <class T>
template <class V, class Base>
Entry<T>& TableSchema<T>::key(const std::string& name, V Base::*member) {
  Entry<T>& entry = add(name);
  entry.read = [member](const KeyInfo& info, const Node& node, const std::string& path, T& object,
                        Diagnostics& report) { report.add_at(path, read_value(node, info, object.*member)); };
  entry.print = [member](const KeyInfo& info, const T& object) { return print_value(info, object.*member); };
  entry.type = [](const KeyInfo& info) { return type_text(info, static_cast<const V*>(nullptr)); };
  entry.visit_numbers = [member](const KeyInfo& info, const std::string& path, T& object,
                                 const NumberVisitor& visitor) { visit_value(info, path, object.*member, visitor); };
  return entry;
}

template <class T>
template <class V, class U, class Base>
Entry<T>& TableSchema<T>::key_or_table(const std::string& name, V Base::*member, std::optional<U> Base::*other,
                                       const TableSchema<U>& schema) {
  Entry<T>& entry = key(name, member);
  entry.read = [read_value = entry.read, other, schema](const KeyInfo& info, const Node& node, const std::string& path,
                                                        T& object, Diagnostics& report) {
    if (node.table())
      schema.read(node, path, (object.*other).emplace(), report);
    else
      read_value(info, node, path, object, report);
  };
  entry.print_tables = [other, schema](const T& object, const std::string& path) {
    return object.*other ? schema.echo(*(object.*other), path) : std::string();
  };
  entry.visit_numbers = [visit_value = entry.visit_numbers, other, schema](const KeyInfo& info, const std::string& path,
                                                                           T& object, const NumberVisitor& visitor) {
    visit_value(info, path, object, visitor);
    if (object.*other) schema.visit_numbers(*(object.*other), path, visitor);
  };
  entry.type = [of_value = entry.type](const KeyInfo& info) { return of_value(info) + " or a table"; };
  entry.describe_tables = [schema](const std::string& path, const std::string& doc, std::vector<TableDoc>& docs) {
    schema.describe(path, doc, docs);
  };
  return entry;
}

template <class Enum>
const Enum* given(const Enum& value) {
  return &value;
}
template <class Enum>
const Enum* given(const std::optional<Enum>& value) {
  return value ? &*value : nullptr;
}

template <class T>
template <class V, class Base, class Enum>
Entry<T>& TableSchema<T>::choice(const std::string& name, V Base::*member,
                                 std::vector<std::pair<std::string, Enum>> words) {
  Entry<T>& entry = add(name);
  for (const auto& [word, value] : words) entry.info.words.push_back(word);
  entry.read = [member, words](const KeyInfo& info, const Node& node, const std::string& path, T& object,
                               Diagnostics& report) {
    std::size_t index = 0;
    const Diagnostics wrong = read_word(node, info, index);
    report.add_at(path, wrong);
    if (wrong.empty()) object.*member = words[index].second;
  };
  entry.print = [member, words](const KeyInfo&, const T& object) {
    const Enum* value = given(object.*member);
    for (const auto& [word, meaning] : words)
      if (value && *value == meaning) return to_toml(word);
    return std::string();
  };
  entry.type = [](const KeyInfo& info) { return "one of " + join(info.words); };
  return entry;
}

template <class T>
template <class U, class Make, class Find>
Entry<T>& TableSchema<T>::add_table(const std::string& name, const TableSchema<U>& schema, Make make, Find find) {
  Entry<T>& entry = add(name);
  entry.read = [schema, make](const KeyInfo&, const Node& node, const std::string& path, T& object,
                              Diagnostics& report) { schema.read(node, path, make(object), report); };
  entry.print_tables = [schema, find](const T& object, const std::string& path) {
    const U* part = find(object);
    return part ? schema.echo(*part, path) : std::string();
  };
  entry.visit_numbers = [schema, find](const KeyInfo&, const std::string& path, T& object,
                                       const NumberVisitor& visitor) {
    if (U* part = find(object)) schema.visit_numbers(*part, path, visitor);
  };
  entry.describe_tables = [schema](const std::string& path, const std::string& doc, std::vector<TableDoc>& docs) {
    schema.describe(path, doc, docs);
  };
  return entry;
}

template <class T>
template <class U, class Base>
Entry<T>& TableSchema<T>::table(const std::string& name, U Base::*member, const TableSchema<U>& schema) {
  return add_table(
      name, schema, [member](T& object) -> U& { return object.*member; },
      [member](auto& object) { return &(object.*member); });
}

template <class T>
template <class U, class Base>
Entry<T>& TableSchema<T>::table(const std::string& name, std::optional<U> Base::*member, const TableSchema<U>& schema) {
  return add_table(
      name, schema, [member](T& object) -> U& { return (object.*member).emplace(); },
      [member](auto& object) { return object.*member ? &*(object.*member) : nullptr; });
}

template <class T>
Entry<T>& TableSchema<T>::section(const std::string& name, const TableSchema<T>& schema) {
  return add_table(
      name, schema, [](T& object) -> T& { return object; }, [](auto& object) { return &object; });
}

template <class T>
template <class U, class Base>
Entry<T>& TableSchema<T>::tables(const std::string& name, std::map<std::string, U> Base::*member,
                                 const TableSchema<U>& schema) {
  Entry<T>& entry = add(name);
  entry.read = [member, schema](const KeyInfo&, const Node& node, const std::string& path, T& object,
                                Diagnostics& report) {
    if (!check_is_table(node, path, report)) return;
    for (const auto& [key, item] : *node.table())
      if (check_is_table(item, dotted(path, key), report))
        schema.read(item, dotted(path, key), (object.*member)[key], report);
  };
  entry.print_tables = [member, schema](const T& object, const std::string& path) {
    std::string text;
    for (const auto& [key, item] : object.*member) text += schema.echo(item, dotted(path, key));
    return text;
  };
  entry.visit_numbers = [member, schema](const KeyInfo&, const std::string& path, T& object,
                                         const NumberVisitor& visitor) {
    for (auto& [key, item] : object.*member) schema.visit_numbers(item, dotted(path, key), visitor);
  };
  entry.describe_tables = [schema](const std::string& path, const std::string& doc, std::vector<TableDoc>& docs) {
    schema.describe(path + ".NAME", doc, docs);
  };
  return entry;
}

template <class T>
std::vector<std::string> TableSchema<T>::names() const {
  std::vector<std::string> list;
  for (const Entry<T>& entry : entries_) list.push_back(entry.info.name);
  return list;
}

template <class T>
void TableSchema<T>::read(const Node& node, const std::string& path, T& object, Diagnostics& report) const {
  if (!check_is_table(node, path, report)) return;
  check_known(node, path, names(), report);
  for (const Entry<T>& entry : entries_) {
    const KeyInfo& info = entry.info;
    const Node* value = node.find(info.name);
    const bool decided = entry.decisive.empty() || report.sound(dotted(path, entry.decisive));
    const bool belongs = entry.belongs_to(object);
    if (value && decided && !belongs)
      report_misplaced(info, *value, path, report);
    else if (value)
      entry.read(info, *value, dotted(path, info.name), object, report);
    else if (info.required && decided && belongs)
      report_missing(info, entry.type ? entry.type(info) : "", node, path, report);
  }
}

template <class T>
std::string TableSchema<T>::echo(const T& object, const std::string& path) const {
  std::string lines, tables;
  for (const Entry<T>& entry : entries_) {
    if (!entry.belongs_to(object)) continue;
    if (entry.print) lines += echo_line(entry.info, entry.print(entry.info, object));
    if (entry.print_tables) tables += entry.print_tables(object, dotted(path, entry.info.name));
  }
  return echo_block(path, lines) + tables;
}

template <class T>
void TableSchema<T>::visit_numbers(T& object, const std::string& path, const NumberVisitor& visitor) const {
  for (const Entry<T>& entry : entries_)
    if (entry.visit_numbers && entry.belongs_to(object))
      entry.visit_numbers(entry.info, dotted(path, entry.info.name), object, visitor);
}

template <class T>
void TableSchema<T>::describe(const std::string& path, const std::string& doc, std::vector<TableDoc>& docs) const {
  const std::size_t index = docs.size();
  docs.push_back({path, doc, {}});
  const T standard{};
  for (const Entry<T>& entry : entries_) {
    if (entry.print)
      docs[index].rows.push_back(key_row(entry.info, entry.type(entry.info), entry.print(entry.info, standard)));
    if (entry.describe_tables) entry.describe_tables(dotted(path, entry.info.name), table_doc(entry.info), docs);
  }
}

}  // namespace upbead
