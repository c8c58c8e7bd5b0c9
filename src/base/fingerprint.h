// A number that shows whether texts and files have changed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace upbead {

/// Hash FNV-1a, 64 bits: it detects a changed file, but is no guard against malice.
class Fingerprint {
 public:
  void add(const std::string& text) {
    for (const char c : text + '\0') value_ = (value_ ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  }
  /// Adds a file's name and contents; nothing where there is no such file.
  void add_file(const std::filesystem::path& path);
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 14695981039346656037ULL;
};

}  // namespace upbead
