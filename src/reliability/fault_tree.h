// A fault tree: which limit states together are a failure of the system.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "design/reliability_table.h"
#include "upbead/base/error.h"

namespace upbead {

/// Gates over events that are known by their place in a list.
class FaultTree {
 public:
  /// `events`: names of what may fail; `top`: the gate that is asked for. Throws std::invalid_argument where a name is
  /// neither an event nor a gate, or a gate is part of itself.
  FaultTree(const std::map<std::string, SystemNode>& gates, const std::string& top,
            const std::vector<std::string>& events);
  /// The margin of the gate: the least of `any`, the largest of `all`.
  double margin(const std::vector<double>& events) const;
  /// The sets of events that together fail it, without those that contain another: it fails where all events of any of
  /// these sets fail. Each set ascends.
  std::vector<std::vector<std::size_t>> cut_sets() const;

 private:
  struct Node {
    bool any = true;
    int event = -1;  ///< a leaf; -1: a gate
    std::vector<Node> inside;
  };
  Node root_;
  static Node node_of(const std::map<std::string, SystemNode>& gates, const std::string& name,
                      const std::vector<std::string>& events, std::vector<std::string> above);
  static double margin(const Node& node, const std::vector<double>& events);
  static std::vector<std::vector<std::size_t>> cut_sets(const Node& node);
};

/// The union of two sets that ascend.
std::vector<std::size_t> united(const std::vector<std::size_t>& a, const std::vector<std::size_t>& b);

/// The gates that are part of no other one; each must have 'any' or 'all'.
std::vector<std::string> tops_of(const std::map<std::string, SystemNode>& gates);

/// Mistakes of [reliability.system]: unknown names, gates with both or neither of any and all, circles, more than one
/// gate that is part of no other. The key of a place is below that table.
Diagnostics diagnose(const std::map<std::string, SystemNode>& gates, const std::vector<std::string>& events);

}  // namespace upbead
