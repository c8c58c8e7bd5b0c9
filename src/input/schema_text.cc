#include "input/schema_text.h"

#include "base/text.h"

namespace upbead {

std::string where_text(const std::string& path) {
  return path.empty() ? "at the top of the file" : "in [" + path + "]";
}

bool check_is_table(const Node& node, const std::string& path, Diagnostics& report) {
  if (node.table()) return true;
  report.add(at_key(path, node.place), path + ": expected a table, found " + found(node),
             "write [" + path + "] and its keys");
  return false;
}

void check_known(const Node& node, const std::string& path, const std::vector<std::string>& known,
                 Diagnostics& report) {
  for (const auto& [key, entry] : *node.table()) {
    bool is_known = false;
    for (const std::string& name : known) is_known = is_known || name == key;
    if (!is_known)
      report.add(at_key(dotted(path, key), entry.place), "unknown key " + in_quotes(key) + " " + where_text(path),
                 suggestion(key, known, "keys"));
  }
}

void report_missing(const KeyInfo& key, const std::string& type, const Node& node, const std::string& path,
                    Diagnostics& report) {
  const std::string cure = type.empty() ? "add [" + dotted(path, key.name) + "]" : "add " + key.name + ", " + type;
  report.add(at_key(dotted(path, key.name), node.place), "'" + key.name + "' is missing " + where_text(path), cure);
}

void report_misplaced(const KeyInfo& key, const Node& node, const std::string& path, Diagnostics& report) {
  report.add(at_key(dotted(path, key.name), node.place),
             "'" + key.name + "' does not belong " + where_text(path) + " (only " + key.condition + ")", "remove it");
}

std::string echo_line(const KeyInfo& key, const std::string& value) {
  const bool has_unit = !key.unit.empty() && value != to_toml(key.word);
  if (!value.empty()) return key.name + " = " + value + (has_unit ? "  # " + key.unit : "") + "\n";
  return key.fallback.empty() ? "" : "# " + key.name + ": " + key.fallback + "\n";
}

std::string echo_block(const std::string& path, const std::string& lines) {
  if (lines.empty() || path.empty()) return lines;
  return "\n[" + path + "]\n" + lines;
}

namespace {
std::string with_condition(const KeyInfo& key) {
  return key.condition.empty() ? key.doc : key.doc + " (only " + key.condition + ")";
}
}  // namespace

KeyRow key_row(const KeyInfo& key, const std::string& type, const std::string& standard) {
  const bool bounded = key.range.text() != Range().text();
  return {key.name, type, bounded ? key.range.text() : "",
          key.required            ? "required"
          : !key.fallback.empty() ? key.fallback
          : standard.empty()      ? ""
                                  : "`" + standard + "`",
          with_condition(key)};
}

std::string table_doc(const KeyInfo& key) {
  return with_condition(key);
}

namespace {
std::string cell(const std::string& text) {
  std::string escaped;
  for (const char c : text) escaped += c == '|' ? "\\|" : std::string(1, c);
  return escaped.empty() ? " " : escaped;
}
}  // namespace

std::string markdown(const std::vector<TableDoc>& docs) {
  std::string text;
  for (const TableDoc& table : docs) {
    text +=
        (text.empty() ? "## " : "\n## ") + (table.path.empty() ? "top of the file" : "`[" + table.path + "]`") + "\n\n";
    if (!table.doc.empty()) text += table.doc + "\n\n";
    if (table.rows.empty()) continue;
    text += "| key | type | range | default | meaning |\n|---|---|---|---|---|\n";
    for (const KeyRow& row : table.rows)
      text += "| `" + row.key + "` | " + cell(row.type) + " | " + cell(row.range) + " | " + cell(row.standard) + " | " +
              cell(row.meaning) + " |\n";
  }
  return text;
}

}  // namespace upbead
