#include "upbead/base/error.h"

#include <algorithm>
#include <tuple>

#include "base/text.h"

namespace upbead {

namespace {
constexpr std::size_t longest_sentence = 4000;  // limit of one sentence (bytes), however much it quotes
constexpr std::size_t n_told = 1000;            // number of mistakes listed: more than a person corrects at once

/// The text unchanged, also of several lines, unless it is longer than `most`.
std::string bounded(const std::string& text, std::size_t most) {
  return text.size() > most ? excerpt(text, most) : text;
}

std::string lines_of(const std::vector<Diagnostic>& list) {
  std::string text;
  for (std::size_t i = 0; i < list.size() && i < n_told; ++i) text += (text.empty() ? "" : "\n") + to_string(list[i]);
  if (list.size() > n_told) text += "\nand " + std::to_string(list.size() - n_told) + " more mistakes";
  return text;
}

}  // namespace

std::string to_string(const Diagnostic& diagnostic) {
  const Place& place = diagnostic.place;
  std::string text = bounded(place.file.empty() ? place.key : place.file, longest_path);
  if (place.line > 0) text += ":" + std::to_string(place.line);
  if (place.line > 0 && place.column > 0) text += ":" + std::to_string(place.column);
  if (!text.empty()) text += ": ";
  text += bounded(diagnostic.what, longest_sentence);
  if (!diagnostic.cure.empty()) text += "; " + bounded(diagnostic.cure, longest_sentence);
  return text;
}

Diagnostics::Diagnostics(std::initializer_list<Diagnostic> list) {
  for (const Diagnostic& diagnostic : list) add(diagnostic);
}

void Diagnostics::add(Diagnostic diagnostic) {
  if (!diagnostic.place.key.empty()) keys_.insert(diagnostic.place.key);
  list_.push_back(std::move(diagnostic));
}

void Diagnostics::add(Place place, std::string what, std::string cure) {
  add({std::move(place), std::move(what), std::move(cure)});
}

void Diagnostics::add(const Diagnostics& more) {
  for (const Diagnostic& diagnostic : more) add(diagnostic);
}

void Diagnostics::add_at(const std::string& key, const Diagnostics& more) {
  for (const Diagnostic& found : more) add({at_key(key, found.place), found.what, found.cure});
  for (const Diagnostic& found : more.notes_) note(at_key(key, found.place), found.what);
}

bool Diagnostics::sound(const std::string& key) const {
  if (key.empty()) return empty();
  const std::string below = key + ".";
  const auto next = keys_.lower_bound(below);
  return keys_.count(key) == 0 && (next == keys_.end() || next->compare(0, below.size(), below) != 0);
}

void Diagnostics::throw_if_any() const {
  if (!empty()) throw InputError(*this);
}

void Diagnostics::throw_if_any(const std::string& file) const {
  const auto rank = [&](const Diagnostic& d) {
    const bool here = d.place.file == file;
    return std::tuple(!here, here ? d.place.line : 0, here ? d.place.column : 0);
  };
  Diagnostics sorted = *this;
  std::stable_sort(sorted.list_.begin(), sorted.list_.end(),
                   [&](const Diagnostic& a, const Diagnostic& b) { return rank(a) < rank(b); });
  sorted.throw_if_any();
}

InputError::InputError(Diagnostics diagnostics)
    : std::runtime_error(lines_of(diagnostics.list())), diagnostics_(std::move(diagnostics)) {}

InputError::InputError(Place place, std::string what, std::string cure)
    : InputError(Diagnostics{{std::move(place), std::move(what), std::move(cure)}}) {}

}  // namespace upbead
