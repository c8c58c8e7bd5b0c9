#include "reliability/fault_tree.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "base/text.h"

namespace upbead {

FaultTree::FaultTree(const std::map<std::string, SystemNode>& gates, const std::string& top,
                     const std::vector<std::string>& events)
    : root_(node_of(gates, top, events, {})) {}

FaultTree::Node FaultTree::node_of(const std::map<std::string, SystemNode>& gates, const std::string& name,
                                   const std::vector<std::string>& events, std::vector<std::string> above) {
  Node node;
  const auto event = std::find(events.begin(), events.end(), name);
  if (event != events.end()) {
    node.event = static_cast<int>(event - events.begin());
    return node;
  }
  if (std::find(above.begin(), above.end(), name) != above.end())
    throw std::invalid_argument("the gate " + in_quotes(name) + " is part of itself");
  const auto gate = gates.find(name);
  if (gate == gates.end()) throw std::invalid_argument("there is no limit state or gate " + in_quotes(name));
  above.push_back(name);
  node.any = gate->second.any.has_value();
  for (const std::string& part : *(node.any ? gate->second.any : gate->second.all))
    node.inside.push_back(node_of(gates, part, events, above));
  return node;
}

double FaultTree::margin(const Node& node, const std::vector<double>& events) {
  if (node.event >= 0) return events[static_cast<std::size_t>(node.event)];
  double value = margin(node.inside.front(), events);
  for (const Node& part : node.inside)
    value = node.any ? std::min(value, margin(part, events)) : std::max(value, margin(part, events));
  return value;
}

double FaultTree::margin(const std::vector<double>& events) const {
  return margin(root_, events);
}

std::vector<std::size_t> united(const std::vector<std::size_t>& a, const std::vector<std::size_t>& b) {
  std::vector<std::size_t> both;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  return both;
}

namespace {

using CutSets = std::vector<std::vector<std::size_t>>;

/// Without sets that contain another one.
CutSets least(const CutSets& sets) {
  CutSets list;
  for (std::size_t i = 0; i < sets.size(); ++i) {
    const auto contains = [&](std::size_t k) {
      return k != i && std::includes(sets[i].begin(), sets[i].end(), sets[k].begin(), sets[k].end()) &&
             (sets[k] != sets[i] || k < i);
    };
    bool needed = true;
    for (std::size_t k = 0; needed && k < sets.size(); ++k) needed = !contains(k);
    if (needed) list.push_back(sets[i]);
  }
  return list;
}

}  // namespace

CutSets FaultTree::cut_sets(const Node& node) {
  if (node.event >= 0) return {{static_cast<std::size_t>(node.event)}};
  CutSets sets = cut_sets(node.inside.front());
  for (std::size_t i = 1; i < node.inside.size(); ++i) {
    const CutSets more = cut_sets(node.inside[i]);
    if (node.any) {
      sets.insert(sets.end(), more.begin(), more.end());
    } else {
      CutSets product;
      for (const auto& a : sets)
        for (const auto& b : more) product.push_back(united(a, b));
      sets = product;
    }
    sets = least(sets);
  }
  return sets;
}

CutSets FaultTree::cut_sets() const {
  return cut_sets(root_);
}

Diagnostics diagnose(const std::map<std::string, SystemNode>& gates, const std::vector<std::string>& events) {
  Diagnostics list;
  std::vector<std::string> known = events;
  for (const auto& [name, gate] : gates) known.push_back(name);
  for (const auto& [name, gate] : gates) {
    if (gate.any.has_value() == gate.all.has_value()) {
      list.add(at_key(name), gate.any ? "both 'any' and 'all' are given" : "neither 'any' nor 'all' is given",
               "give one of them, a list of names");
      continue;
    }
    if (std::find(events.begin(), events.end(), name) != events.end())
      list.add(at_key(name), "a limit state has that name", "give the gate another name");
    for (const std::string& part : *(gate.any ? gate.any : gate.all))
      if (std::find(known.begin(), known.end(), part) == known.end())
        list.add(at_key(name), "there is no limit state or gate " + in_quotes(part),
                 suggestion(part, known, "limit states and gates"));
  }
  if (!list.empty()) return list;
  for (const auto& [name, gate] : gates) try {
      const FaultTree tree(gates, name, events);
    } catch (const std::invalid_argument& circle) {
      list.add(at_key(name), circle.what(), "take it out of one of the lists");
    }
  if (const std::vector<std::string> tops = tops_of(gates); list.empty() && tops.size() > 1)
    list.add(at_key(tops[1]),
             "gates " + join(tops) + " are each part of no other, and which stands for the whole is not said",
             "join them in one gate, [reliability.system.NAME] any = [\"" + tops[0] + "\", \"" + tops[1] +
                 "\"], or remove those that are not asked for");
  return list;
}

std::vector<std::string> tops_of(const std::map<std::string, SystemNode>& gates) {
  std::vector<std::string> tops;
  for (const auto& [name, gate] : gates) {
    bool inside = false;
    for (const auto& [other, above] : gates)
      for (const std::string& part : *(above.any ? above.any : above.all)) inside = inside || part == name;
    if (!inside) tops.push_back(name);
  }
  return tops;
}

}  // namespace upbead
