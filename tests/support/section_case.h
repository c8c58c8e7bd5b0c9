// The case section.toml as a text, and changes of it.
#pragma once

#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace upbead::test {

/// The case with changes (old, new), each only at its first place; throws if an old text does not occur.
inline std::string section_case(const std::vector<std::pair<std::string, std::string>>& changes) {
  std::ifstream file(UPBEAD_SECTION_CASE);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  for (const auto& [before, after] : changes) {
    const auto place = text.find(before);
    if (place == std::string::npos) throw std::invalid_argument("section.toml has no '" + before + "'");
    text.replace(place, before.size(), after);
  }
  return text;
}

}  // namespace upbead::test
