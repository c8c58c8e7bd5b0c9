// A number that tells whether texts are still the same.
#pragma once

#include <cstdint>
#include <string>

namespace upbead {

/// FNV-1a, 64 bits: no guard against malice, only against a changed file.
class Fingerprint {
 public:
  void add(const std::string& text) {
    for (const char c : text + '\0') value_ = (value_ ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 14695981039346656037ULL;
};

}  // namespace upbead
