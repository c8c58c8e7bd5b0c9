// Random numbers that are the same on every machine: the distributions of <random> are not.
#pragma once

#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <random>

namespace upbead::test {

/// One stream of numbers by seed and scene.
class Draw {
 public:
  Draw(std::uint64_t seed, std::uint64_t scene) : engine_(seed * 0x9E3779B97F4A7C15ULL + scene + 1) {}

  /// In [0, 1).
  double unit() { return std::ldexp(static_cast<double>(engine_() >> 11), -53); }
  bool chance(double probability) { return unit() < probability; }
  double uniform(double low, double high) { return low + (high - low) * unit(); }
  double log_uniform(double low, double high) { return low * std::pow(high / low, unit()); }
  /// Log-uniform, but either end itself with a probability of 7 % each.
  double ranged(double low, double high) {
    const double at = unit(), value = log_uniform(low, high);
    return at < 0.07 ? low : at > 0.93 ? high : value;
  }
  /// From low to high, both included.
  int whole(int low, int high) { return low + static_cast<int>(unit() * (high - low + 1)); }
  template <class T>
  T one_of(std::initializer_list<T> list) {
    return *std::next(list.begin(), whole(0, static_cast<int>(list.size()) - 1));
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace upbead::test
