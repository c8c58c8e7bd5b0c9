// Values of any kind in a study file: what a key of some case will take, nobody knows yet.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "input/values.h"

namespace upbead {

/// A number, a word, true or false, or a list of those.
struct Literal {
  std::string toml;  ///< as TOML; a whole number without a point, so that a key for whole numbers takes it too
  bool is_number = false;
  double number = 0.;
};

Literal literal(double number);

Diagnostics read_value(const Node& node, const KeyInfo& key, Literal& value);
Diagnostics read_value(const Node& node, const KeyInfo& key, std::vector<Literal>& value);
Diagnostics read_value(const Node& node, const KeyInfo& key, std::vector<std::string>& value);
/// By dotted key; tables within the table lengthen it.
Diagnostics read_value(const Node& node, const KeyInfo& key, std::map<std::string, Literal>& value);

std::string type_text(const KeyInfo& key, const Literal*);
std::string type_text(const KeyInfo& key, const std::vector<Literal>*);
std::string type_text(const KeyInfo& key, const std::vector<std::string>*);
std::string type_text(const KeyInfo& key, const std::map<std::string, Literal>*);

std::string print_value(const KeyInfo& key, const Literal& value);
std::string print_value(const KeyInfo& key, const std::vector<Literal>& value);
std::string print_value(const KeyInfo& key, const std::vector<std::string>& value);
std::string print_value(const KeyInfo& key, const std::map<std::string, Literal>& value);

/// None of these belongs to a key with a unit.
inline void visit_value(const KeyInfo&, const std::string&, std::vector<Literal>&, const NumberVisitor&) {}
inline void visit_value(const KeyInfo&, const std::string&, std::vector<std::string>&, const NumberVisitor&) {}
inline void visit_value(const KeyInfo&, const std::string&, std::map<std::string, Literal>&, const NumberVisitor&) {}

}  // namespace upbead
