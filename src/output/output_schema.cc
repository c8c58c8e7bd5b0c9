#include "output/output_schema.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "upbead/base/error.h"

namespace upbead {

namespace {

void require_finite(const Json& value, const std::string& path) {
  if (value.is_number_float() && !std::isfinite(value.get<double>()))
    throw NumericsError("'" + path + "' of the summary is not finite; nothing was written");
  if (value.is_structured())
    for (const auto& item : value.items()) require_finite(item.value(), path + "/" + item.key());
}

/// The first key of a path: "slips" of "slips[].start".
std::string first_key(const std::string& path) {
  return path.substr(0, path.find_first_of(".["));
}

std::string cell(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) text.insert(at, "\\");
  return text;
}

std::string table(const std::vector<OutputRow>& rows, const std::string& below) {
  std::string text;
  for (const OutputRow& row : rows)
    text += "| `" + row.path.substr(below.size()) + "` | " + (row.unit.empty() ? "" : row.unit + " ") + "| " +
            cell(row.meaning) + " |\n";
  return text.empty() ? "" : "| key | unit | |\n|---|---|---|\n" + text;
}

std::string sentence(std::string words) {
  words[0] = static_cast<char>(std::toupper(words[0]));
  return words + ".";
}

}  // namespace

std::string json_text(const Json& json, int indent) {
  require_finite(json, "");
  return json.dump(indent) + "\n";
}

std::string markdown(const std::vector<OutputRow>& rows) {
  constexpr auto most = 6;  // keys of an object, itself included, that stays in the first table
  std::vector<OutputRow> top;
  std::string sections;
  for (auto at = rows.begin(); at != rows.end();) {
    const auto end =
        std::find_if(at, rows.end(), [&](const OutputRow& row) { return first_key(row.path) != first_key(at->path); });
    if (end - at <= most)
      top.insert(top.end(), at, end);
    else
      sections +=
          "\n### `" + at->path + "`\n\n" + sentence(at->meaning) + "\n\n" + table({at + 1, end}, at->path + ".");
    at = end;
  }
  return table(top, "") + sections;
}

OutputSchema<NumberedWarning> warning_outputs() {
  using W = NumberedWarning;
  const auto number = [](double W::*member) {
    return [member](const W& w) { return w.unit.empty() ? std::nullopt : std::optional(w.*member); };
  };
  return OutputSchema<W>()
      .key("name", &W::name, "", "as in [warnings](warnings.md)")
      .key("value", number(&W::value), "", "that decided; null where no number did")
      .key("limit", number(&W::limit), "", "that it passes; null likewise")
      .reason("unit", &W::unit, "of both; null likewise")
      .reason("cure", &W::cure, "what to do; null where nothing is known")
      .key("text", &W::text, "", "what is wrong, and the cure");
}

Json warnings_json(const NumberedWarnings& warnings) {
  Json list = Json::array();
  for (const NumberedWarning& warning : warnings) list.push_back(warning_outputs().to_json(warning));
  return list;
}

std::vector<OutputRow> OutputKeys::rows() const {
  std::vector<OutputRow> list;
  for (const Entry& entry : entries_) list.insert(list.end(), entry.rows.begin(), entry.rows.end());
  return list;
}

void OutputKeys::add(const OutputRow& row, std::function<Json(const void*)> value, const OutputKeys* inside) {
  Entry entry{{row}, std::move(value)};
  if (inside != nullptr)
    for (OutputRow below : inside->rows()) {
      below.path = row.path + "." + below.path;
      entry.rows.push_back(below);
    }
  entries_.push_back(std::move(entry));
}

void OutputKeys::leave_out_null() {
  auto& value = entries_.back().value;
  value = [often = value](const void* of) {
    Json json = often(of);
    return json.is_null() || (json.is_object() && json.empty()) ? Json(Json::value_t::discarded) : json;
  };
}

Json OutputKeys::object(const void* of) const {
  Json json = Json::object();
  for (const Entry& entry : entries_)
    if (Json value = entry.value(of); !value.is_discarded())
      json[first_key(entry.rows.front().path)] = std::move(value);
  return json;
}

}  // namespace upbead
