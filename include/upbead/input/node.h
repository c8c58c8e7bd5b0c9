// A tree of values from a TOML file, each with the place where a person wrote it.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "upbead/base/error.h"

namespace upbead {

struct Node;
using NodeTable = std::vector<std::pair<std::string, Node>>;
using NodeArray = std::vector<Node>;

/// A date or time of TOML. No key has such a value, but a message must be able to say what was found.
struct NodeDate {};

struct Node {
  std::variant<bool, std::int64_t, double, std::string, NodeDate, NodeArray, NodeTable> value;
  Place place;  ///< of the key; within an array, of the value

  const NodeTable* table() const { return std::get_if<NodeTable>(&value); }
  const NodeArray* array() const { return std::get_if<NodeArray>(&value); }
  const std::string* text() const { return std::get_if<std::string>(&value); }
  /// The entry of a table, or nullptr where there is none or this is no table.
  const Node* find(const std::string& key) const;
};

/// The value described for a message: "a string", "the number 2.5", "a list of 3".
std::string found(const Node& node);

/// "regions.sand" and "porosity" make "regions.sand.porosity"; a name that TOML requires to be quoted is quoted.
std::string dotted(const std::string& path, const std::string& key);
/// The keys of a dotted path, quotes removed.
std::vector<std::string> split_dotted(const std::string& path);

/// Shortest TOML text that reads back as the same value.
std::string to_toml(double value);
std::string to_toml(int value);
std::string to_toml(bool value);
std::string to_toml(const std::string& value);

/// A number for a message: like to_toml, but 40 instead of 40.0.
std::string number_text(double value);

}  // namespace upbead
