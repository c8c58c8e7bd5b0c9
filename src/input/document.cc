#include "upbead/input/document.h"

#include <toml++/toml.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "base/table_text.h"
#include "base/text.h"
#include "base/text_file.h"

namespace upbead {

namespace {

Place place_of(const toml::source_region& source, const std::string& file) {
  return {file, static_cast<int>(source.begin.line), static_cast<int>(source.begin.column)};
}

constexpr std::size_t longest_key = 500;  // a message about a key quotes its whole path

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
  // the library sorts entries by name; they are read in the order of the file
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

/// toml++ descends into a dotted key part by part, and overflows the stack at some ten thousand parts. The marks = ,
/// [ ] { } stand in no key outside quotes: between two of them, a key has as many parts as there are dots.
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

/// Reads TOML `text` that stands in `file`. Throws InputError with the place of a syntax error.
Node parse_toml(const std::string& text, const std::string& file) {
  refuse_endless_keys(text, file);
  try {
    return convert_table(toml::parse(std::string_view(text), std::string_view(file)), {file});
  } catch (const toml::parse_error& error) {
    throw InputError(place_of(error.source(), file), "not TOML: " + std::string(error.description()),
                     "see https://toml.io for the syntax");
  }
}

constexpr std::size_t longest_override = 300;      // of one override that a message quotes
constexpr std::uintmax_t most_bytes = 10'000'000;  // a case has some kilobytes

std::string read_text(const std::string& path) {
  require_readable(path, most_bytes, Place());
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  const std::string mark = text.str().substr(0, 2);
  // editors of Windows write "Unicode" as UTF-16
  return mark == "\xFF\xFE" || mark == "\xFE\xFF" ? as_utf8(text.str(), path, Place()) : text.str();
}

/// The tree that one override stands for: nested tables with one entry each, and the value at the end.
Node read_override(const std::string& text) {
  const std::string place = "--set " + excerpt(text, longest_override);
  const std::size_t equals = text.find('=');
  const auto fail = [&](const std::string& what) -> InputError {
    return InputError({place}, what, "write --set KEY=VALUE, such as --set time.end=2.0");
  };
  if (equals == std::string::npos) throw fail("no '=' between key and value");
  const std::string key = text.substr(0, equals), value = text.substr(equals + 1);
  const std::size_t first = value.find_first_not_of(' ');
  if (first == std::string::npos) throw fail("no value after '='");
  if (text.find('\n') != std::string::npos) throw fail("more than one line");
  try {
    return parse_toml(key + " = " + value, place);
  } catch (const InputError&) {
    // a value that begins like a TOML list, table or string is meant as one; any other is a word without quotes
    if (std::string("[{\"'").find(value[first]) != std::string::npos) throw fail("the value is not TOML");
  }
  try {
    return parse_toml(key + " = " + to_toml(value), place);
  } catch (const InputError&) {
    throw fail("the key is not TOML");
  }
}

/// Line numbers within an override tell nothing; its whole text is the place.
void forget_lines(Node& node) {
  node.place.line = node.place.column = 0;
  if (auto* table = std::get_if<NodeTable>(&node.value))
    for (auto& [key, entry] : *table) forget_lines(entry);
  if (auto* array = std::get_if<NodeArray>(&node.value))
    for (Node& item : *array) forget_lines(item);
}

/// Puts the value at the end of the chain `change`, `depth` keys long, into `root`.
void apply(Node& root, Node&& change, std::size_t depth) {
  auto& [key, value] = std::get<NodeTable>(change.value).front();
  auto* table = std::get_if<NodeTable>(&root.value);
  if (!table)
    throw InputError(change.place, in_quotes(key) + " is set within " + found(root), "see the keys of the case");
  const auto old = std::find_if(table->begin(), table->end(), [k = &key](const auto& e) { return e.first == *k; });
  if (old == table->end())
    table->emplace_back(std::move(key), std::move(value));
  else if (depth > 1)
    apply(old->second, std::move(value), depth - 1);
  else
    old->second = std::move(value);
}

}  // namespace

Document::Document(const std::string& path, const std::vector<std::string>& overrides)
    : path_(path), root_(parse_toml(read_text(path), path)) {
  change(overrides);
}

Document::Document(const std::vector<std::string>& overrides) {
  change(overrides);
}

Document Document::of_text(const std::string& text, const std::string& path,
                           const std::vector<std::string>& overrides) {
  Document document;
  document.path_ = path;
  document.root_ = parse_toml(text, path);
  document.change(overrides);
  return document;
}

void Document::change(const std::vector<std::string>& overrides) {
  Diagnostics mistakes;
  for (const std::string& text : overrides) try {
      Node node = read_override(text);
      forget_lines(node);
      apply(root_, std::move(node), split_dotted(text.substr(0, text.find('='))).size());
    } catch (const InputError& error) {
      mistakes.add(error.diagnostics());
    }
  mistakes.throw_if_any();
}

const Node* Document::find(const std::string& path) const {
  const Node* node = &root_;
  for (const std::string& key : split_dotted(path))
    if (!(node = node->find(key))) return nullptr;
  return node;
}

Place Document::place(const std::string& path) const {
  const Node* node = &root_;
  for (const std::string& key : split_dotted(path)) {
    const Node* next = node->find(key);
    if (!next) break;
    node = next;
  }
  return at_key(path, node->place);
}

}  // namespace upbead
