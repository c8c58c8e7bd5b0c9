#include "toml_text.h"

#include <toml++/toml.h>

#include <algorithm>

#include "base/text.h"

namespace upbead {

namespace {

Place place_of(const toml::source_region& source, const std::string& file) {
  return {file, static_cast<int>(source.begin.line), static_cast<int>(source.begin.column)};
}

constexpr std::size_t longest_key = 500;  // every message about it tells its whole path

Node convert(const toml::node& node, const Place& place);

Node convert_table(const toml::table& table, const Place& place) {
  NodeTable entries;
  for (const auto& [key, value] : table) {
    if (key.length() > longest_key)
      throw InputError(place_of(key.source(), place.file),
                       "a key of " + std::to_string(key.length()) + " characters, " + in_quotes(key.str()) +
                           "; at most " + std::to_string(longest_key) + " are read",
                       "give it a shorter name");
    entries.emplace_back(std::string(key.str()), convert(value, place_of(key.source(), place.file)));
  }
  // the library sorts by name, a person by place
  std::stable_sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) {
    return std::pair(a.second.place.line, a.second.place.column) <
           std::pair(b.second.place.line, b.second.place.column);
  });
  return {std::move(entries), place};
}

Node convert(const toml::node& node, const Place& place) {
  if (node.is_table()) return convert_table(*node.as_table(), place);
  if (const toml::array* array = node.as_array()) {
    NodeArray items;
    for (const toml::node& item : *array) items.push_back(convert(item, place_of(item.source(), place.file)));
    return {std::move(items), place};
  }
  if (const auto* value = node.as_boolean()) return {value->get(), place};
  if (const auto* value = node.as_integer()) return {value->get(), place};
  if (const auto* value = node.as_floating_point()) return {value->get(), place};
  if (const auto* value = node.as_string()) return {value->get(), place};
  return {NodeDate{}, place};
}

/// toml++ goes down into a dotted key part by part, and beyond some ten thousand parts the stack ends. Between two
/// marks that no key holds outside quotes there are as many parts as dots.
void refuse_endless_keys(const std::string& text, const std::string& file) {
  constexpr int most = 1000;
  int dots = 0, line = 1;
  char quote = 0;
  for (const char c : text) {
    if (c == '\n') ++line;
    if (c == '\n' || c == quote)
      quote = 0;
    else if (quote != 0)
      continue;
    else if (c == '"' || c == '\'')
      quote = c;
    if (std::string_view("\n=,[]{}").find(c) != std::string_view::npos) dots = 0;
    if (c == '.' && ++dots > most)
      throw InputError({file, line, 1}, "a key of more than " + std::to_string(most) + " parts",
                       "write keys such as regions.sand.porosity");
  }
}

}  // namespace

Node parse_toml(const std::string& text, const std::string& file) {
  refuse_endless_keys(text, file);
  try {
    return convert_table(toml::parse(std::string_view(text), std::string_view(file)), {file});
  } catch (const toml::parse_error& error) {
    throw InputError(place_of(error.source(), file), "not TOML: " + std::string(error.description()),
                     "see https://toml.io for the syntax");
  }
}

}  // namespace upbead
