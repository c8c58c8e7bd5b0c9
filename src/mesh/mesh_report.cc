#include "mesh_report.h"

#include <cstdio>
#include <filesystem>

#include "base/text.h"

namespace upbead {

namespace {

/// Whether `name`, which may hold any characters, stands in a sentence as a separate word.
bool names(const std::string& sentence, const std::string& name) {
  if (name.empty()) return false;
  for (auto at = sentence.find(name); at != std::string::npos; at = sentence.find(name, at + 1)) {
    const std::size_t end = at + name.size();
    const bool begins = at == 0 || !is_word_character(sentence[at - 1]),
               ends = end == sentence.size() || !is_word_character(sentence[end]);
    if (begins && ends) return true;
  }
  return false;
}

}  // namespace

MeshReport::MeshReport(const MeshRequest& request)
    : request_(request), name_(std::filesystem::path(request.file).filename().string()) {}

void MeshReport::add_at(const Place& place, const std::string& what, const std::string& cure) {
  mistakes_.add(place, "mesh '" + name_ + "': " + what, cure);
}

void MeshReport::add_in_script(const Place& place, const std::string& what, const std::string& cure) {
  mistakes_.add(place, what, cure);
}

void MeshReport::add(const Diagnostics& mistakes) {
  mistakes_.add(mistakes);
}

void MeshReport::throw_if_any() const {
  mistakes_.throw_if_any();
}

void MeshReport::add(const std::string& what, const std::string& cure) {
  add_at(request_.place, what, cure);
}

void MeshReport::add_about_parameters(const std::string& what, const std::string& cure) {
  for (const auto& [name, place] : request_.parameter_places)
    if (names(what, name)) return add_at(place, what, cure);
  add(what, cure);
}

std::string Found::first() const {
  char text[80];
  std::snprintf(text, sizeof text, ", the first at (%.6g, %.6g)", where[0], where[1]);
  return text;
}

std::string counted(std::size_t count, const std::string& thing, const std::string& rest) {
  return std::to_string(count) + " " + thing + (count == 1 ? "" : "s") + rest;
}

std::string quoted(const std::string& name) {
  return name.empty() ? "without a name" : in_quotes(name);
}

}  // namespace upbead
