#include "upbead/input/node.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace upbead {

const Node* Node::find(const std::string& key) const {
  if (!table()) return nullptr;
  for (const auto& [name, node] : *table())
    if (name == key) return &node;
  return nullptr;
}

std::string found(const Node& node) {
  struct Visitor {
    std::string operator()(bool) const { return "true or false"; }
    std::string operator()(std::int64_t value) const { return "the number " + std::to_string(value); }
    std::string operator()(double value) const { return "the number " + to_toml(value); }
    std::string operator()(const std::string&) const { return "a string"; }
    std::string operator()(NodeDate) const { return "a date or time"; }
    std::string operator()(const NodeArray& list) const { return "a list of " + std::to_string(list.size()); }
    std::string operator()(const NodeTable&) const { return "a table"; }
  };
  return std::visit(Visitor{}, node.value);
}

namespace {
bool is_bare(const std::string& key) {
  const auto plain = [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '-'; };
  return !key.empty() && std::all_of(key.begin(), key.end(), plain);
}
}  // namespace

std::string dotted(const std::string& path, const std::string& key) {
  const std::string name = is_bare(key) ? key : to_toml(key);
  return path.empty() ? name : path + "." + name;
}

std::vector<std::string> split_dotted(const std::string& path) {
  std::vector<std::string> keys(1);
  char quote = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const char c = path[i];
    if (c == quote || (quote == 0 && (c == '"' || c == '\'')))
      quote = quote == 0 ? c : 0;
    else if (c == '.' && quote == 0)
      keys.emplace_back();
    else
      keys.back() += quote == '"' && c == '\\' && i + 1 < path.size() ? path[++i] : c;
  }
  return keys;
}

std::string number_text(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0. ? "inf" : "-inf";
  std::array<char, 32> buffer;
  const std::to_chars_result end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  std::string text(buffer.data(), end.ptr);
  const std::size_t exponent = text.find('e');
  if (exponent == std::string::npos) return text;
  // to_chars writes 1e+08 and 1e-05; people write 1e8 and 1e-5
  std::string digits = text.substr(exponent + 2);
  digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size() - 1));
  return text.substr(0, exponent + 1) + (text[exponent + 1] == '-' ? "-" : "") + digits;
}

std::string to_toml(double value) {
  const std::string text = number_text(value);
  return text.find_first_of(".einf") == std::string::npos ? text + ".0" : text;
}

std::string to_toml(int value) {
  return std::to_string(value);
}

std::string to_toml(bool value) {
  return value ? "true" : "false";
}

std::string to_toml(const std::string& value) {
  constexpr const char* hex = "0123456789ABCDEF";
  std::string text = "\"";
  for (const char c : value) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\')
      text += {'\\', c};
    else if (code < 0x20 || code == 0x7F)
      text += {'\\', 'u', '0', '0', hex[code / 16], hex[code % 16]};
    else
      text += c;
  }
  return text + "\"";
}

}  // namespace upbead
