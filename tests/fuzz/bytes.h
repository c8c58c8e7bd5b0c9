// Choices made by the bytes of an input, for inputs with a structure.
#pragma once

#include <string>
#include <string_view>

namespace upbead::fuzz {

/// Takes bytes from the front; zeros where there are no more.
class Bytes {
 public:
  explicit Bytes(std::string_view bytes) : rest_(bytes) {}

  bool empty() const { return rest_.empty(); }
  unsigned char byte();
  /// From 0 to n - 1, n up to 256.
  int below(int n) { return byte() % n; }
  bool one_in(int n) { return below(n) == n - 1; }
  /// The next n bytes, or as many as are left.
  std::string text(int n);
  /// Mostly a small number; also halves, huge ones, tiny ones, inf and nan.
  double number();
  /// Such a number in the notation of C.
  std::string number_text();

 private:
  std::string_view rest_;
};

}  // namespace upbead::fuzz
