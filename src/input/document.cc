#include "upbead/input/document.h"

#include <algorithm>
#include <fstream>
#include <sstream>

#include "base/text.h"
#include "base/text_file.h"
#include "toml_text.h"

namespace upbead {

namespace {

constexpr std::size_t longest_override = 300;      // of one that a message quotes
constexpr std::uintmax_t most_bytes = 10'000'000;  // a case has some kilobytes

std::string read_text(const std::string& path) {
  require_readable(path, most_bytes, Place());
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

/// The tree that one override stands for: tables of one entry each, down to its value.
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
    // what opens like a TOML value but is none is a slip; anything else is a word
    if (std::string("[{\"'").find(value[first]) != std::string::npos) throw fail("the value is not TOML");
  }
  try {
    return parse_toml(key + " = " + to_toml(value), place);
  } catch (const InputError&) {
    throw fail("the key is not TOML");
  }
}

/// Lines within an override say nothing; its whole text is the place.
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
  Diagnostics mistakes;
  for (const std::string& text : overrides) try {
      Node change = read_override(text);
      forget_lines(change);
      apply(root_, std::move(change), split_dotted(text.substr(0, text.find('='))).size());
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
