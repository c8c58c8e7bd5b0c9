// Values as bytes, between this process and a confined one, see confined_work.h. The format may change at any time.
#pragma once

#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "upbead/base/error.h"

namespace upbead {

/// Packs values one after another.
class Parcel {
 public:
  template <class T, class = std::enable_if_t<std::is_trivially_copyable_v<T>>>
  void put(const T& value) {
    append(&value, sizeof value);
  }
  void put(const std::string& text) { put_all(text.data(), text.size()); }
  template <class T, class = std::enable_if_t<std::is_trivially_copyable_v<T>>>
  void put(const std::vector<T>& list) {
    put_all(list.data(), list.size());
  }
  void put(const std::vector<std::string>& texts);
  void put(const Diagnostics& mistakes);
  /// Returns the bytes and leaves the parcel empty.
  std::string take() { return std::move(bytes_); }

 private:
  void append(const void* data, std::size_t size) { bytes_.append(static_cast<const char*>(data), size); }
  template <class T>
  void put_all(const T* data, std::size_t size) {
    put(size);
    append(data, size * sizeof(T));
  }
  std::string bytes_;
};

/// Unpacks values in the same order; the bytes must outlive it. Throws std::runtime_error where the bytes do not fit:
/// a malicious file may control the other process.
class OpenParcel {
 public:
  explicit OpenParcel(std::string_view bytes) : rest_(bytes) {}

  template <class T, class = std::enable_if_t<std::is_trivially_copyable_v<T>>>
  T value() {
    T value;
    std::memcpy(&value, next(sizeof value).data(), sizeof value);
    return value;
  }
  std::string text() { return std::string(next(value<std::size_t>())); }
  template <class T>
  std::vector<T> list() {
    static_assert(std::is_trivially_copyable_v<T>);
    const std::string_view bytes = next(size_of<T>());
    std::vector<T> list(bytes.size() / sizeof(T));
    if (!list.empty()) std::memcpy(list.data(), bytes.data(), bytes.size());
    return list;
  }
  std::vector<std::string> texts();
  Diagnostics diagnostics();

 private:
  /// Number of elements of the list that comes next, checked against the bytes left.
  template <class T>
  std::size_t size_of() {
    const auto n = value<std::size_t>();
    if (n > rest_.size() / sizeof(T)) too_short();
    return n * sizeof(T);
  }
  std::string_view next(std::size_t size);
  [[noreturn]] static void too_short();

  std::string_view rest_;
};

}  // namespace upbead
