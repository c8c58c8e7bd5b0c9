#include "output/output_text.h"

#include <algorithm>

#include "base/format.h"
#include "base/text.h"

namespace upbead {

namespace {

constexpr std::size_t widest_line = 100, key_width = 30, value_width = 16;
constexpr std::size_t most_items = 12;  ///< of a list

const OutputRow* row_at(const std::string& path, const std::vector<OutputRow>& rows) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const OutputRow& row) { return row.path == path; });
  return found != rows.end() ? &*found : nullptr;
}

/// The part of a meaning that serves as a label, without Markdown, as far as it fits.
std::string label_of(const std::string& meaning, std::size_t width) {
  std::string label = meaning.substr(0, std::min(meaning.find(": "), meaning.find("; ")));
  if (const std::size_t link = label.find("]("); link != std::string::npos) {
    const std::size_t end = label.find(')', link);
    label.erase(link, end == std::string::npos ? end : end - link + 1);
  }
  label.erase(std::remove_if(label.begin(), label.end(), [](char c) { return c == '[' || c == '`'; }), label.end());
  return label.size() <= width ? label : label.substr(0, label.rfind(' ', width)) + " ...";
}

std::string number_text(double value, const std::string& unit) {
  if (unit.empty()) return significant(value, 4);
  return unit == "s" || unit == "degrees" ? significant(value, 4) + " " + unit : with_unit(value, unit);
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

class Lines {
 public:
  explicit Lines(const std::vector<OutputRow>& rows) : rows_(rows) {}

  /// The keys of an object; `path` ends with a point, or is empty. Names that a user gave stand for NAME.
  void add_object(const Json& object, const std::string& path, std::size_t indent) {
    for (const auto& [key, value] : object.items()) {
      if (!is_told(value)) continue;
      if (row_at(path + key + ".NAME", rows_) != nullptr)
        add_named(key, value, path + key + ".NAME", indent);
      else
        add(key, value, path + key, indent);
    }
  }

  std::string text() const { return text_; }

 private:
  void add_named(const std::string& key, const Json& items, const std::string& path, std::size_t indent) {
    text_ += std::string(indent, ' ') + key + "\n";
    for (const auto& [name, value] : items.items()) add(name, value, path, indent + 2);
  }

  void add(const std::string& key, const Json& value, const std::string& path, std::size_t indent) {
    if (value.is_object()) {
      text_ += std::string(indent, ' ') + key + "\n";
      add_object(value, path + ".", indent + 2);
    } else if (value.is_array() && value.front().is_object()) {
      add_list(key, value, path + "[].", indent);
    } else {
      const OutputRow* row = row_at(path, rows_) != nullptr ? row_at(path, rows_) : row_at(path + "[]", rows_);
      add_line(key, value_text(value, row != nullptr ? row->unit : ""),
               value.is_string() || row == nullptr ? "" : row->meaning, indent);
    }
  }

  /// Each item in a line: its own sentence where it has one, else its values.
  void add_list(const std::string& key, const Json& items, const std::string& path, std::size_t indent) {
    text_ += std::string(indent, ' ') + key + "\n";
    for (std::size_t i = 0; i < std::min(items.size(), most_items); ++i) {
      const Json& item = items[i];
      std::string line = item.value("text", "");
      if (item.contains("what") && item.contains("why"))
        line = value_text(item["what"], "") + ": " + value_text(item["why"], "");
      if (line.empty())
        for (const auto& [name, value] : item.items()) {
          if (!is_told(value) || value.is_object()) continue;
          const OutputRow* row = row_at(path + name, rows_);
          line += (line.empty() ? "" : ", ") + name + " " + value_text(value, row != nullptr ? row->unit : "");
        }
      text_ += std::string(indent + 2, ' ') + line + "\n";
    }
    if (items.size() > most_items)
      text_ += std::string(indent + 2, ' ') + "and " + std::to_string(items.size() - most_items) + " others\n";
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

  const std::vector<OutputRow>& rows_;
  std::string text_;
};

}  // namespace

std::string text_of(const Json& summary, const std::vector<OutputRow>& rows) {
  Lines lines(rows);
  lines.add_object(summary, "", 0);
  return lines.text();
}

}  // namespace upbead
