#include <zlib.h>

#include <cstdio>

#include "hdf5_contents.h"

namespace upbead::detail {

namespace {

/// Of bytes behind those that `sum` is of.
std::uint32_t crc(const void* data, std::size_t size, std::uint32_t sum = 0) {
  return static_cast<std::uint32_t>(crc32_z(sum, static_cast<const Bytef*>(data), size));
}

/// Files hold texts up to their first zero. The zero is counted, so that "ab", "c" is not "a", "bc".
std::uint32_t crc_of_text(const std::string& text, std::uint32_t sum = 0) {
  const std::string kept = text.c_str();
  return crc(kept.c_str(), kept.size() + 1, sum);
}

std::string key_of(const AttributeName& name) {
  return name.first + "\n" + name.second;
}

}  // namespace

void Hdf5Checksum::add(const std::string& path, const std::vector<std::size_t>& shape, const double* values) {
  std::uint32_t sum = 0;
  std::size_t n = 1;
  for (const std::uint64_t size : shape) {
    sum = crc(&size, sizeof size, sum);
    n *= size;
  }
  note(path, n > 0 ? crc(values, n * sizeof(double), sum) : sum);
}

void Hdf5Checksum::add(const std::string& path, const std::vector<std::string>& texts) {
  std::uint32_t sum = 0;
  for (const std::string& text : texts) sum = crc_of_text(text, sum);
  note(path, sum);
}

void Hdf5Checksum::add(const AttributeName& name, double number) {
  note(key_of(name), crc(&number, sizeof number));
}

void Hdf5Checksum::add(const AttributeName& name, const std::string& text) {
  if (name != AttributeName("/", checksum_name)) note(key_of(name), crc_of_text(text));
}

std::string Hdf5Checksum::value() const {
  std::uint32_t sum = 0;
  for (const auto& [key, part] : sums_) sum = crc(&part, sizeof part, crc_of_text(key, sum));
  char text[16];
  std::snprintf(text, sizeof text, "crc32:%08x", sum);
  return text;
}

std::string checksum_of(const Hdf5Contents& contents) {
  Hdf5Checksum checksum;
  for (const auto& [path, array] : contents.numbers) checksum.add(path, array.shape, array.values.data());
  for (const auto& [path, texts] : contents.texts) checksum.add(path, texts);
  for (const auto& [name, number] : contents.number_attributes) checksum.add(name, number);
  for (const auto& [name, text] : contents.text_attributes) checksum.add(name, text);
  return checksum.value();
}

}  // namespace upbead::detail
