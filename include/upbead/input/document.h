// A TOML file as a person wrote it, with overrides from the command line.
#pragma once

#include <string>
#include <vector>

#include "upbead/input/node.h"

namespace upbead {

/// Every key with its place. The place of an override is `--set KEY=VALUE` instead of a file and a line.
class Document {
 public:
  Document() = default;
  /// `overrides`: texts KEY=VALUE with a dotted KEY and a TOML value; text that is no TOML value counts as a string, so
  /// that words need no quotes. A table replaces the whole table of the file. Throws InputError where there is no such
  /// file, it is not TOML, or an override is wrong.
  Document(const std::string& path, const std::vector<std::string>& overrides);
  /// A document of overrides alone, without a file.
  explicit Document(const std::vector<std::string>& overrides);
  /// The same of TOML `text`; messages name `path` as its file.
  static Document of_text(const std::string& text, const std::string& path,
                          const std::vector<std::string>& overrides = {});

  const std::string& path() const { return path_; }
  const Node& root() const { return root_; }
  /// The node at a dotted path, or nullptr.
  const Node* find(const std::string& path) const;
  /// Where the key at a dotted path was written. For a key that was not written: the place of the nearest table that
  /// would hold it.
  Place place(const std::string& path) const;

 private:
  void change(const std::vector<std::string>& overrides);

  std::string path_;
  Node root_{NodeTable{}, {}};
};

}  // namespace upbead
