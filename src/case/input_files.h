// The files that a case reads, and a number that shows whether they have changed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "base/files.h"
#include "upbead/case/case.h"

namespace upbead {

/// Hash FNV-1a, 64 bits: it detects a changed file, but is no guard against malice.
class Fingerprint {
 public:
  void add(const std::string& text) {
    for (const char c : text + '\0') value_ = (value_ ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  }
  /// Adds a file's name and contents; nothing where there is no such file.
  void add_file(const std::filesystem::path& path);
  /// Adds all files that a case depends on: its own, mesh, histories.
  void add_files(const Case& problem);
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 14695981039346656037ULL;
};

/// The case itself, its mesh, histories, records of transducers and measured records, each with the key that names
/// it.
std::vector<InputFile> input_files(const Case& problem);

}  // namespace upbead
