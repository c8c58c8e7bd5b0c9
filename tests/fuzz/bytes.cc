#include "bytes.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>

namespace upbead::fuzz {

unsigned char Bytes::byte() {
  if (rest_.empty()) return 0;
  const auto first = static_cast<unsigned char>(rest_.front());
  rest_.remove_prefix(1);
  return first;
}

std::string Bytes::text(int n) {
  const std::size_t size = std::min(rest_.size(), static_cast<std::size_t>(n));
  std::string text(rest_.substr(0, size));
  rest_.remove_prefix(size);
  return text;
}

double Bytes::number() {
  using Limits = std::numeric_limits<double>;
  static const std::array<double, 16> special{0.5,
                                              -0.5,
                                              1e-6,
                                              -1e-300,
                                              1e300,
                                              -1e300,
                                              1e10,
                                              0.1,
                                              Limits::infinity(),
                                              -Limits::infinity(),
                                              Limits::quiet_NaN(),
                                              Limits::denorm_min(),
                                              Limits::max(),
                                              2147483648.,
                                              1e-12,
                                              -0.};
  const int choice = byte();
  constexpr int n_small = 240, middle = 20;
  if (choice < n_small) return choice % (2 * middle) - middle / 2;
  return special[static_cast<std::size_t>(choice - n_small)];
}

std::string Bytes::number_text() {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.17g", number());
  return text.data();
}

}  // namespace upbead::fuzz
