#include "base/parcel.h"

#include <stdexcept>

namespace upbead {

void Parcel::put(const std::vector<std::string>& texts) {
  put(texts.size());
  for (const std::string& text : texts) put(text);
}

void Parcel::put(const Diagnostics& mistakes) {
  put(mistakes.list().size());
  for (const Diagnostic& mistake : mistakes) {
    put(mistake.place.file);
    put(mistake.place.line);
    put(mistake.place.column);
    put(mistake.what);
    put(mistake.cure);
  }
}

std::vector<std::string> OpenParcel::texts() {
  std::vector<std::string> texts;
  for (auto n = value<std::size_t>(); n > 0; --n) texts.push_back(text());
  return texts;
}

Diagnostics OpenParcel::diagnostics() {
  Diagnostics mistakes;
  for (auto n = value<std::size_t>(); n > 0; --n) {
    Diagnostic mistake;
    mistake.place.file = text();
    mistake.place.line = value<int>();
    mistake.place.column = value<int>();
    mistake.what = text();
    mistake.cure = text();
    mistakes.add(std::move(mistake));
  }
  return mistakes;
}

std::string_view OpenParcel::next(std::size_t size) {
  if (size > rest_.size()) too_short();
  const std::string_view bytes = rest_.substr(0, size);
  rest_.remove_prefix(size);
  return bytes;
}

void OpenParcel::too_short() {
  throw std::runtime_error("a confined process handed back less than it said");
}

}  // namespace upbead
