#include "upbead/base/error.h"

namespace upbead {

std::string to_string(const Mistake& mistake) {
  std::string text = mistake.place.file;
  if (mistake.place.line > 0) text += ":" + std::to_string(mistake.place.line);
  if (mistake.place.line > 0 && mistake.place.column > 0) text += ":" + std::to_string(mistake.place.column);
  if (!text.empty()) text += ": ";
  text += mistake.what;
  if (!mistake.cure.empty()) text += "; " + mistake.cure;
  return text;
}

namespace {
std::string join(const std::vector<Mistake>& mistakes) {
  std::string text;
  for (const Mistake& mistake : mistakes) text += (text.empty() ? "" : "\n") + to_string(mistake);
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
