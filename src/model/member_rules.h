// Which members belong to which kinds of a part of a scene.
#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "upbead/base/error.h"

namespace upbead {

template <class Part, class Kind>
struct MemberRule {
  std::string key;
  std::vector<Kind> kinds;                 ///< kinds that the member belongs to
  bool needed;                             ///< all these kinds require it
  std::function<bool(const Part&)> given;  ///< whether it differs from its default
  bool belongs_to(Kind kind) const { return std::find(kinds.begin(), kinds.end(), kind) != kinds.end(); }
};

template <class Part, class Value>
std::function<bool(const Part&)> is_set(std::optional<Value> Part::*member) {
  return [member](const Part& part) { return (part.*member).has_value(); };
}

/// `whose`: "a porous region".
inline void add_missing(const std::string& key, const std::string& whose, Diagnostics& list) {
  list.add(at_key(key), "'" + key + "' is missing, which " + whose + " needs", "add " + key);
}

/// Members that are missing, or that do not belong to a part of that kind.
template <class Part, class Kind>
Diagnostics diagnose_members(const std::vector<MemberRule<Part, Kind>>& rules, const Part& part, Kind kind,
                             const std::string& whose) {
  Diagnostics list;
  for (const MemberRule<Part, Kind>& rule : rules) {
    const bool given = rule.given(part), belongs = rule.belongs_to(kind);
    if (given && !belongs) list.add(at_key(rule.key), "'" + rule.key + "' does not belong to " + whose, "remove it");
    if (!given && belongs && rule.needed) add_missing(rule.key, whose, list);
  }
  return list;
}

}  // namespace upbead
