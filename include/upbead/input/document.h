// A TOML file as a person wrote it, with overrides from the command line.
#pragma once

#include <string>
#include <vector>

#include "upbead/input/node.h"

namespace upbead {

/// Every key with its place. An override reads `--set KEY=VALUE` where a file has its name and line.
class Document {
 public:
  Document() = default;
  /// `overrides`: texts KEY=VALUE with a dotted KEY and a TOML value; what is no TOML value counts as a string, so that
  /// words need no quotes. A table replaces a whole table. Throws InputError: no such file, not TOML, a wrong override.
  Document(const std::string& path, const std::vector<std::string>& overrides);
  /// Of overrides alone, without a file.
  explicit Document(const std::vector<std::string>& overrides);

  const std::string& path() const { return path_; }
  const Node& root() const { return root_; }
  /// The node at a dotted path, or nullptr.
  const Node* find(const std::string& path) const;
  /// Where the key at a dotted path was written; of the nearest table around it where it was not.
  Place place(const std::string& path) const;

 private:
  void change(const std::vector<std::string>& overrides);

  std::string path_;
  Node root_{NodeTable{}, {}};
};

}  // namespace upbead
