#include "output/output_text.h"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <utility>

#include "base/format.h"
#include "base/text.h"

namespace upbead {

namespace {

constexpr std::size_t widest_line = 100, key_width = 30, value_width = 16;
constexpr std::size_t most_items = 40;  ///< of a list
using Rows = std::vector<OutputRow>;

const OutputRow* row_at(const std::string& path, const Rows& rows) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const OutputRow& row) { return row.path == path; });
  return found != rows.end() ? &*found : nullptr;
}

std::string unit_at(const std::string& path, const Rows& rows) {
  const OutputRow* row = row_at(path, rows);
  return row != nullptr ? row->unit : "";
}

/// The path of the items of an object whose keys are names: "waves.NAME" of "waves"; "" where its keys are declared.
std::string path_of_items(const std::string& path, const Rows& rows) {
  const std::size_t begin = path.size() + 1;
  for (const OutputRow& row : rows)
    if (row.path.size() > begin && starts_with(row.path, path + ".") && std::isupper(row.path[begin]) != 0)
      return row.path.substr(0, row.path.find_first_of(".[", begin));
  return "";
}

/// The part of a meaning that serves as a label, without Markdown, as far as it fits.
std::string label_of(const std::string& meaning, std::size_t width) {
  std::string label = meaning.substr(0, std::min(meaning.find(": "), meaning.find("; ")));
  if (const std::size_t link = label.find("]("); link != std::string::npos) {
    const std::size_t end = label.find(')', link);
    label.erase(link, end == std::string::npos ? end : end - link + 1);
  }
  label.erase(std::remove_if(label.begin(), label.end(), [](char c) { return c == '[' || c == ']' || c == '`'; }),
              label.end());
  return label.size() <= width ? label : label.substr(0, label.rfind(' ', width)) + " ...";
}

/// Areas and volumes, whose prefix would be squared, rates, and units that have a prefix or take none.
bool takes_no_prefix(const std::string& unit) {
  static const std::vector<std::string> beginnings{"degrees", "kg", "m2", "m3", "1/", "year"};
  return unit == "s" || std::any_of(beginnings.begin(), beginnings.end(),
                                    [&unit](const std::string& beginning) { return starts_with(unit, beginning); });
}

/// "1 per year" of 1/year.
std::string number_text(double value, const std::string& unit) {
  if (unit.empty()) return significant(value, 4);
  if (!takes_no_prefix(unit)) return with_unit(value, unit);
  const std::string of = starts_with(unit, "1/") ? "per " + unit.substr(2) : unit;
  return significant(value, 4) + " " + of;
}

/// A number, a word, or a list of those.
std::string value_text(const Json& value, const std::string& unit) {
  if (value.is_number()) return number_text(value.get<double>(), unit);
  if (value.is_string()) return value.get<std::string>();
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  std::string text;
  for (const Json& item : value) text += (text.empty() ? "" : ", ") + value_text(item, unit);
  return text;
}

bool is_told(const Json& value) {
  return !value.is_null() && !(value.is_structured() && value.empty()) && value != "";
}

/// "none where nothing overturns" of a meaning that says "..., null where nothing overturns".
std::string why_null(const std::string& meaning) {
  const std::size_t begin = meaning.find("null ");
  return begin == std::string::npos ? "none" : "none" + meaning.substr(begin + 4, meaning.find(';', begin) - begin - 4);
}

/// Adds a cell to a line, or to the next one, indented, where it does not fit.
void add_cell(const std::string& cell, std::size_t indent, std::string& line) {
  const std::size_t begin = line.rfind('\n') + 1;  // 0 in the first line
  const bool fits = line.size() - begin + indent + cell.size() < widest_line;
  line += (line.empty() ? "" : fits ? ", " : ",\n" + std::string(indent, ' ')) + cell;
}

class Lines {
 public:
  Lines(const Rows& rows, bool with_nulls) : rows_(rows), with_nulls_(with_nulls) {}

  /// The keys of an object; `path` ends with a point, or is empty.
  void add_object(const Json& object, const std::string& path, std::size_t indent) {
    for (const auto& [key, value] : object.items()) add(key, value, path + key, indent);
  }

  std::string text() const { return text_; }

 private:
  void add(const std::string& key, const Json& value, const std::string& path, std::size_t indent) {
    const OutputRow* row = row_at(path, rows_) != nullptr ? row_at(path, rows_) : row_at(path + "[]", rows_);
    if (!is_told(value)) {
      if (with_nulls_ && row != nullptr && row->is_number) add_line(key, why_null(row->meaning), "", indent);
    } else if (value.is_object()) {
      const std::size_t before = text_.size();
      add_heading(key, indent);
      const std::size_t inside = text_.size();
      if (const std::string named = path_of_items(path, rows_); !named.empty())
        for (const auto& [name, item] : value.items()) add(name, item, named, indent + 2);
      else
        add_object(value, path + ".", indent + 2);
      if (text_.size() == inside) text_.resize(before);
    } else if (value.is_array() && value.front().is_object()) {
      add_list(key, value, path + "[].", indent);
    } else {
      add_line(key, value_text(value, row != nullptr ? row->unit : ""),
               value.is_string() || row == nullptr ? "" : row->meaning, indent);
    }
  }

  void add_heading(const std::string& key, std::size_t indent) { text_ += std::string(indent, ' ') + key + "\n"; }

  /// Each item in a line: its own sentence where it has one, else its values, and below it the objects in it.
  void add_list(const std::string& key, const Json& items, const std::string& path, std::size_t indent) {
    add_heading(key, indent);
    for (std::size_t i = 0; i < std::min(items.size(), most_items); ++i) {
      const Json& item = items[i];
      std::string line = item.value("text", "");
      if (item.contains("what") && item.contains("why"))
        line = value_text(item["what"], "") + ": " + value_text(item["why"], "");
      Json inside = Json::object();
      if (line.empty()) {
        for (const auto& [name, value] : item.items())
          if (value.is_object())
            inside[name] = value;
          else if (is_told(value))
            add_cell(name + " " + value_text(value, unit_at(path + name, rows_)), indent + 4, line);
      }
      add_heading(line, indent + 2);
      add_object(inside, path, indent + 4);
    }
    if (items.size() > most_items)
      add_heading("and " + std::to_string(items.size() - most_items) + " others", indent + 2);
  }

  void add_line(const std::string& key, const std::string& value, const std::string& meaning, std::size_t indent) {
    std::string line = std::string(indent, ' ') + key;
    line.resize(std::max(line.size() + 1, key_width), ' ');
    line += value;
    if (!meaning.empty()) {
      line.resize(std::max(line.size() + 2, key_width + value_width), ' ');
      const std::size_t left = line.size() < widest_line ? widest_line - line.size() : 0;
      line += left > 12 ? label_of(meaning, left - 4) : "";
    }
    text_ += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }

  const Rows& rows_;
  bool with_nulls_;
  std::string text_;
};

Json::json_pointer pointer_to(const std::string& key) {
  Json::json_pointer at;
  std::istringstream parts(key);
  for (std::string part; std::getline(parts, part, '.');) at.push_back(part);
  return at;
}

/// The first column, and those from `from` on that fit in a line; the next one that does not.
std::pair<std::string, std::size_t> aligned_from(std::size_t from, const std::vector<TextRow>& rows,
                                                 const std::vector<std::size_t>& width) {
  constexpr std::size_t gap = 2;
  std::size_t to = from, line = width[0];
  while (to < width.size() && (to == from || line + gap + width[to] <= widest_line)) line += gap + width[to++];
  std::string text;
  for (const TextRow& row : rows) {
    text += row[0] + std::string(width[0] - row[0].size(), ' ');
    for (std::size_t i = from; i < to; ++i) text += std::string(gap + width[i] - row[i].size(), ' ') + row[i];
    text += "\n";
  }
  return {text, to};
}

/// The numbers of many items by column: the least, the largest, of which items, and in how many it is not 0.
std::string ranges_of(const Json& items, const Rows& rows, const std::string& path,
                      const std::vector<TextColumn>& columns) {
  std::vector<TextRow> table{{"of " + std::to_string(items.size()), "least", "in", "largest", "in", "not 0 in"}};
  for (const TextColumn& column : columns) {
    const auto at = pointer_to(column.key);
    std::vector<std::pair<double, std::string>> values;
    for (const auto& item : items.items())
      if (item.value().contains(at) && item.value()[at].is_number())
        values.emplace_back(item.value()[at].get<double>(), item.value().value("name", item.key()));
    if (values.empty()) continue;
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    const auto n = std::count_if(values.begin(), values.end(), [](const auto& value) { return value.first != 0.; });
    const std::string unit = unit_at(path + "." + column.key, rows);
    table.push_back({column.head, number_text(least->first, unit), least->second, number_text(most->first, unit),
                     most->second, std::to_string(n)});
  }
  return aligned(table);
}

}  // namespace

std::string text_of(const Json& summary, const Rows& rows) {
  Lines lines(rows, false);
  lines.add_object(summary, "", 0);
  return lines.text();
}

std::string text_of(const Json& summary, const Rows& rows, const std::vector<std::string>& keys) {
  Json some = Json::object();
  for (const std::string& key : keys)
    if (const auto at = pointer_to(key); summary.contains(at)) some[at] = summary[at];
  Lines lines(rows, true);
  lines.add_object(some, "", 0);
  return lines.text();
}

std::string aligned(const std::vector<TextRow>& rows) {
  std::vector<std::size_t> width(rows.front().size());
  for (const TextRow& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) width[i] = std::max(width[i], row[i].size());
  std::string text;
  for (std::size_t next = 1; next < width.size();) {
    const auto [block, to] = aligned_from(next, rows, width);
    text += (next > 1 ? "\n" : "") + block;
    next = to;
  }
  return text;
}

std::string table_of(const Json& items, const Rows& rows, const std::string& path,
                     const std::vector<TextColumn>& columns, const std::string& name, std::size_t most) {
  if (items.size() > most) return ranges_of(items, rows, path, columns);
  std::vector<TextRow> table(items.size() + 1);
  if (items.is_object()) {
    table.clear();
    table.push_back({name});
    for (const auto& item : items.items()) table.push_back({item.key()});
  }
  for (const TextColumn& column : columns) {
    const auto at = pointer_to(column.key);
    TextRow cells{column.head};
    for (const Json& item : items)
      cells.push_back(
          item.contains(at) && is_told(item[at]) ? value_text(item[at], unit_at(path + "." + column.key, rows)) : "-");
    if (std::all_of(cells.begin() + 1, cells.end(), [](const std::string& cell) { return cell == "-"; })) continue;
    for (std::size_t i = 0; i < cells.size(); ++i) table[i].push_back(cells[i]);
  }
  return aligned(table);
}

}  // namespace upbead
