// Writes the parts of a random case; later parts depend on the draws of earlier ones.
#pragma once

#include <map>
#include <sstream>

#include "layout.h"
#include "random_case.h"

namespace upbead::test {

/// The draws that the parts of a case share.
struct CaseDraft {
  CaseDraft(Draw& numbers, Layout section) : draw(numbers), layout(std::move(section)) {}

  bool is(const std::string& region, const std::string& kind_) const {
    const auto found = kind.find(region);
    return found != kind.end() && found->second == kind_;
  }
  bool has_pore_water(const std::string& region) const { return is(region, "porous") && flow.at(region) != "drained"; }
  bool is_incompressible() const { return std::isinf(bulk_modulus); }

  Draw& draw;
  Layout layout;
  bool inertia = true, friction = false;
  bool sane = true;  ///< false: the parts may contradict each other
  double bulk_modulus = 0., step = 0., end = 0.;
  std::string scheme;
  std::map<std::string, std::string> kind, flow;  ///< by region
  std::map<std::string, std::string> pressure;    ///< by boundary
  std::ostringstream toml;
  std::vector<std::pair<std::string, std::string>> facts;
};

/// A number as TOML takes it.
std::string number(double value);

/// The tables [regions], with the friction of the caisson.
void write_regions(CaseDraft& draft);
/// The tables [boundaries].
void write_boundaries(CaseDraft& draft);
/// The tables [loads]; `step` and `end` are known.
void write_loads(CaseDraft& draft);

}  // namespace upbead::test
