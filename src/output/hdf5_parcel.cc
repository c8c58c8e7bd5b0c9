#include <algorithm>
#include <stdexcept>

#include "hdf5_contents.h"

namespace upbead::detail {

namespace {

void put_key(Parcel& parcel, const std::string& path) {
  parcel.put(path);
}

void put_key(Parcel& parcel, const AttributeName& name) {
  parcel.put(name.first);
  parcel.put(name.second);
}

void take_key(OpenParcel& parcel, std::string& path) {
  path = parcel.text();
}

void take_key(OpenParcel& parcel, AttributeName& name) {
  name.first = parcel.text();
  name.second = parcel.text();
}

template <class Map, class PutValue>
void put_map(Parcel& parcel, const Map& map, const PutValue& put_value) {
  parcel.put(map.size());
  for (const auto& [key, value] : map) {
    put_key(parcel, key);
    put_value(value);
  }
}

template <class Map, class TakeValue>
void take_map(OpenParcel& parcel, Map& map, const TakeValue& take_value) {
  for (auto n = parcel.value<std::size_t>(); n > 0; --n) {
    typename Map::key_type key;
    take_key(parcel, key);
    map.insert_or_assign(std::move(key), take_value());
  }
}

NumberArray take_array(OpenParcel& parcel) {
  NumberArray array{parcel.list<std::size_t>(), parcel.list<double>()};
  if (!has_its_shape(array)) throw std::runtime_error("an array that has another shape than it says");
  return array;
}

}  // namespace

bool has_its_shape(const NumberArray& array) {
  if (std::find(array.shape.begin(), array.shape.end(), 0U) != array.shape.end()) return array.values.empty();
  std::size_t n = 1;
  for (const std::size_t size : array.shape)
    if (__builtin_mul_overflow(n, size, &n)) return false;
  return n == array.values.size();
}

void put(Parcel& parcel, const Hdf5Contents& contents) {
  parcel.put(contents.names);
  put_map(parcel, contents.numbers, [&parcel](const NumberArray& array) {
    parcel.put(array.shape);
    parcel.put(array.values);
  });
  put_map(parcel, contents.texts, [&parcel](const auto& texts) { parcel.put(texts); });
  put_map(parcel, contents.number_attributes, [&parcel](double number) { parcel.put(number); });
  put_map(parcel, contents.text_attributes, [&parcel](const std::string& text) { parcel.put(text); });
}

Hdf5Contents take_contents(OpenParcel& parcel) {
  Hdf5Contents contents;
  contents.names = parcel.texts();
  take_map(parcel, contents.numbers, [&parcel] { return take_array(parcel); });
  take_map(parcel, contents.texts, [&parcel] { return parcel.texts(); });
  take_map(parcel, contents.number_attributes, [&parcel] { return parcel.value<double>(); });
  take_map(parcel, contents.text_attributes, [&parcel] { return parcel.text(); });
  return contents;
}

}  // namespace upbead::detail
