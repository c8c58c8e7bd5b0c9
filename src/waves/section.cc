#include "upbead/waves/section.h"

#include <algorithm>

#include "base/text.h"

namespace upbead {

std::vector<Objection> objections(const Section& s) {
  std::vector<Objection> list;
  if (s.buoyant_weight >= s.weight)
    list.push_back({"buoyant_weight",
                    "buoyant_weight = " + significant(s.buoyant_weight, 6) +
                        " N/m is not below weight = " + significant(s.weight, 6) + " N/m",
                    "give W' in still water, W less the weight of the displaced water"});
  if (s.centroid && *s.centroid >= s.width)
    list.push_back({"centroid",
                    "centroid = " + significant(*s.centroid, 6) +
                        " m lies outside the caisson, width = " + significant(s.width, 6) + " m",
                    "give the distance from the landward heel to the line of W' (m)"});
  return list;
}

Section at_water_level(const Section& section, const Water& water, double rise) {
  Section s = section;
  s.water_depth += rise;
  s.foundation_depth += rise;
  s.berm_depth += rise;
  s.crest -= rise;
  const double under_water = std::clamp(rise, -section.foundation_depth, section.crest);
  s.buoyant_weight -= water.density * water.gravity * section.width * under_water;
  return s;
}

}  // namespace upbead
