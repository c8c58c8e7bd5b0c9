#include "input/input_report.h"

#include <algorithm>
#include <tuple>

namespace upbead {

void InputReport::add(const std::string& path, const Mistake& mistake) {
  list_.push_back(mistake);
  std::string around;
  unsound_.insert(around);
  for (const std::string& key : split_dotted(path)) unsound_.insert(around = dotted(around, key));
}

void InputReport::add(const std::string& path, Place place, std::string what, std::string cure) {
  add(path, {std::move(place), std::move(what), std::move(cure)});
}

void InputReport::throw_if_any(const std::string& path) const {
  if (list_.empty()) return;
  std::vector<Mistake> sorted = list_;
  const auto order = [&](const Mistake& m) { return std::tuple(m.place.file != path, m.place.line, m.place.column); };
  std::stable_sort(sorted.begin(), sorted.end(), [&](const Mistake& a, const Mistake& b) {
    if (a.place.file != path && b.place.file != path) return false;  // other files keep the order of their discovery
    return order(a) < order(b);
  });
  throw InputError(std::move(sorted));
}

}  // namespace upbead
