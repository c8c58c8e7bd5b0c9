#include "upbead/base/error.h"

#include "base/quoted.h"

namespace upbead {

namespace {
constexpr std::size_t longest_sentence = 4000;  // whatever was quoted in it
constexpr std::size_t n_told = 1000;            // mistakes that a person mends in one go

/// As it is, also several lines, where it is no longer than a message may be.
std::string bounded(const std::string& text, std::size_t most) {
  return text.size() > most ? excerpt(text, most) : text;
}
}  // namespace

std::string to_string(const Mistake& mistake) {
  const Place& place = mistake.place;
  std::string text = bounded(place.file.empty() ? place.key : place.file, longest_path);
  if (mistake.place.line > 0) text += ":" + std::to_string(mistake.place.line);
  if (mistake.place.line > 0 && mistake.place.column > 0) text += ":" + std::to_string(mistake.place.column);
  if (!text.empty()) text += ": ";
  text += bounded(mistake.what, longest_sentence);
  if (!mistake.cure.empty()) text += "; " + bounded(mistake.cure, longest_sentence);
  return text;
}

namespace {
std::string join(const std::vector<Mistake>& mistakes) {
  std::string text;
  for (std::size_t i = 0; i < mistakes.size() && i < n_told; ++i)
    text += (text.empty() ? "" : "\n") + to_string(mistakes[i]);
  if (mistakes.size() > n_told) text += "\nand " + std::to_string(mistakes.size() - n_told) + " more mistakes";
  return text;
}
}  // namespace

InputError::InputError(std::vector<Mistake> mistakes)
    : std::runtime_error(join(mistakes)), mistakes_(std::move(mistakes)) {}

InputError::InputError(Place place, std::string what, std::string cure)
    : InputError(Mistake{std::move(place), std::move(what), std::move(cure)}) {}

void Mistakes::add(Place place, std::string what, std::string cure) {
  list_.push_back({std::move(place), std::move(what), std::move(cure)});
}

void Mistakes::add(const InputError& error) {
  list_.insert(list_.end(), error.mistakes().begin(), error.mistakes().end());
}

void Mistakes::throw_if_any() const {
  if (!list_.empty()) throw InputError(list_);
}

}  // namespace upbead
