#include "input/schema.h"

#include <algorithm>

namespace upbead {

namespace {

/// "in [regions.sand]", or "at the top of the file" for the root.
std::string where_text(const std::string& path) {
  return path.empty() ? "at the top of the file" : "in [" + path + "]";
}

/// Reports a node that is not a table; true where `node` is one.
bool check_is_table(const Node& node, const std::string& path, Diagnostics& report) {
  if (node.table()) return true;
  report.add(at_key(path, node.place), path + ": expected a table, found " + found(node),
             "write [" + path + "] and its keys");
  return false;
}

void check_known(const Node& node, const std::string& path, const Table& table, Diagnostics& report) {
  std::vector<std::string> known, former;
  for (const Key& key : table.keys()) {
    known.push_back(key.info.name);
    former.push_back(key.info.former);
  }
  known.insert(known.end(), table.elsewhere().begin(), table.elsewhere().end());
  const auto has = [](const std::vector<std::string>& list, const std::string& name) {
    return !name.empty() && std::find(list.begin(), list.end(), name) != list.end();
  };
  for (const auto& [name, entry] : *node.table())
    if (!has(known, name) && !has(former, name))
      report.add(at_key(dotted(path, name), entry.place), "unknown key " + in_quotes(name) + " " + where_text(path),
                 suggestion(name, known, "keys"));
}

/// The value of a key, given by its present or its older name; nullptr where it is not given. An override by one name
/// replaces a value that the file gives by the other name.
const Node* find_value(const Node& node, const KeyInfo& key, const std::string& path, Diagnostics& report) {
  const Node* value = node.find(key.name);
  const Node* old = key.former.empty() ? nullptr : node.find(key.former);
  if (!old) return value;
  const Place place = at_key(path, old->place);
  const auto overrides = [](const Node* by) { return by && by->place.file.rfind("--set ", 0) == 0; };
  if (overrides(value) && !overrides(old)) return value;
  if (overrides(old) && !overrides(value)) value = nullptr;
  if (value)
    report.add(place, in_quotes(key.former) + " is the older name of " + in_quotes(key.name) + ", and both are given",
               "remove it");
  else
    report.note(place, in_quotes(key.former) + " is called " + in_quotes(key.name) + " now");
  return value ? value : old;
}

/// What values a key takes, in words; "" for a table alone.
std::string type_of(const Key& key) {
  if (key.choose) return "one of " + join(key.info.words);
  return key.type ? key.type->text(key.info) + (key.table ? " or a table" : "") : "";
}

/// The value as TOML; "" where it is not given.
std::string print(const Key& key, const void* object) {
  if (!key.chosen) return key.type->print(key.info, key.value(const_cast<void*>(object)));
  const std::optional<std::size_t> word = key.chosen(object);
  return word ? to_toml(key.info.words[*word]) : "";
}

bool is_value(const Key& key) {
  return key.type || key.choose;
}

void read_value(const Key& key, const Node& node, const std::string& path, void* object, Diagnostics& report) {
  if (key.type) return report.add_at(path, key.type->read(node, key.info, key.value(object)));
  std::size_t index = 0;
  const Diagnostics wrong = read_word(node, key.info, index);
  report.add_at(path, wrong);
  if (wrong.empty()) key.choose(object, index);
}

void read_key(const Key& key, const Node& node, const std::string& path, void* object, Diagnostics& report) {
  if (is_value(key) && !(key.table && node.table())) return read_value(key, node, path, object, report);
  if (!key.named) return key.table->read(node, path, key.make(object, ""), report);
  if (!check_is_table(node, path, report)) return;
  for (const auto& [name, item] : *node.table())
    if (check_is_table(item, dotted(path, name), report))
      key.table->read(item, dotted(path, name), key.make(object, name), report);
}

/// The tables that are given in an object, with their paths.
std::vector<std::pair<std::string, void*>> tables_of(const Key& key, const std::string& path, void* object) {
  if (!key.table) return {};
  std::vector<std::pair<std::string, void*>> list = key.parts(object);
  for (auto& [name, part] : list) name = key.named ? dotted(path, name) : path;
  return list;
}

/// "name = value  # unit"; where there is no value, a comment with the fallback.
std::string echo_line(const KeyInfo& key, const std::string& value) {
  const bool has_unit = !key.unit.empty() && value != to_toml(key.word);
  if (!value.empty()) return key.name + " = " + value + (has_unit ? "  # " + key.unit : "") + "\n";
  return key.fallback.empty() ? "" : "# " + key.name + ": " + key.fallback + "\n";
}

std::string with_condition(const KeyInfo& key) {
  return key.condition.empty() ? key.doc : key.doc + " (only " + key.condition + ")";
}

std::string cell(const std::string& text) {
  std::string escaped;
  for (const char c : text) escaped += c == '|' ? "\\|" : std::string(1, c);
  return escaped.empty() ? " " : escaped;
}

/// A row of the reference; `standard`: the default as TOML, "" where there is none.
std::string row(const Key& key, const std::string& standard) {
  const KeyInfo& info = key.info;
  const bool bounded = info.range.text() != Range().text();
  const std::string by_default = info.required            ? "required"
                                 : !info.fallback.empty() ? info.fallback
                                 : standard.empty()       ? ""
                                                          : "`" + standard + "`";
  return "| `" + info.name + "` | " + cell(type_of(key)) + " | " + cell(bounded ? info.range.text() : "") + " | " +
         cell(by_default) + " | " + cell(with_condition(info)) + " |\n";
}

}  // namespace

Key& Table::add(const std::string& name) {
  keys_.emplace_back().info.name = name;
  return keys_.back();
}

void Table::read(const Node& node, const std::string& path, void* object, Diagnostics& report) const {
  if (!check_is_table(node, path, report)) return;
  check_known(node, path, *this, report);
  for (const Key& key : keys_) {
    const std::string place = dotted(path, key.info.name);
    const Node* value = find_value(node, key.info, place, report);
    const bool decided = key.decisive.empty() || report.sound(dotted(path, key.decisive));
    const bool belongs = !key.belongs || key.belongs(object);
    if (value && decided && !belongs)
      report.add(at_key(place, value->place),
                 "'" + key.info.name + "' does not belong " + where_text(path) + " (only " + key.info.condition + ")",
                 "remove it");
    else if (value)
      read_key(key, *value, place, object, report);
    else if (key.info.required && decided && belongs)
      report.add(at_key(place, node.place), "'" + key.info.name + "' is missing " + where_text(path),
                 is_value(key) ? "add " + key.info.name + ", " + type_of(key) : "add [" + place + "]");
  }
}

std::string Table::echo(const void* object, const std::string& path, const std::vector<std::string>& without) const {
  std::string lines, tables;
  for (const Key& key : keys_) {
    if (key.belongs && !key.belongs(object)) continue;
    if (std::find(without.begin(), without.end(), key.info.name) != without.end()) continue;
    if (is_value(key)) lines += echo_line(key.info, print(key, object));
    for (const auto& [at, part] : tables_of(key, dotted(path, key.info.name), const_cast<void*>(object)))
      tables += key.table->echo(part, at);
  }
  return (lines.empty() || path.empty() ? lines : "\n[" + path + "]\n" + lines) + tables;
}

void Table::visit_numbers(void* object, const std::string& path, const NumberVisitor& visitor) const {
  for (const Key& key : keys_) {
    if (key.belongs && !key.belongs(object)) continue;
    const std::string place = dotted(path, key.info.name);
    if (key.type) key.type->visit(key.info, place, key.value(object), visitor);
    for (const auto& [at, part] : tables_of(key, place, object)) key.table->visit_numbers(part, at, visitor);
  }
}

std::string Table::reference(const std::string& path, const std::string& doc) const {
  std::string rows, tables;
  for (const Key& key : keys_) {
    if (is_value(key)) rows += row(key, print(key, standard_.get()));
    if (key.table)
      tables += "\n" + key.table->reference(dotted(path, key.info.name) + (key.named ? ".NAME" : ""),
                                            with_condition(key.info));
  }
  return "## " + (path.empty() ? "top of the file" : "`[" + path + "]`") + "\n\n" + (doc.empty() ? "" : doc + "\n\n") +
         (rows.empty() ? "" : "| key | type | range | default | meaning |\n|---|---|---|---|---|\n" + rows) + tables;
}

}  // namespace upbead
