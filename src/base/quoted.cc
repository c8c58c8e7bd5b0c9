#include "base/quoted.h"

#include <algorithm>

namespace upbead {

namespace {

/// Bytes 10xxxxxx of UTF-8 go on with a character.
bool goes_on(char c) {
  return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

}  // namespace

std::string excerpt(std::string_view text, std::size_t most) {
  constexpr std::string_view gap = " ... ";
  std::string line(text.substr(0, most));
  if (text.size() > most) {
    const std::size_t kept = most - gap.size();
    std::size_t head = kept - kept / 3, tail = text.size() - kept / 3;
    while (head > 0 && goes_on(text[head])) --head;
    while (tail < text.size() && goes_on(text[tail])) ++tail;
    line = std::string(text.substr(0, head)).append(gap).append(text.substr(tail));
  }
  std::replace_if(
      line.begin(), line.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20U || c == 0x7F; }, ' ');
  return line;
}

std::string in_quotes(std::string_view text, std::size_t most) {
  return "'" + excerpt(text, most) + "'";
}

std::string quoted_path(std::string_view path) {
  return in_quotes(path, path.size() > longest_path ? longest_quote : longest_path);
}

}  // namespace upbead
