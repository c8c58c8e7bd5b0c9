// What there is to know of the law of a region.
#pragma once

#include "material/soil_law.h"
#include "upbead/model/region.h"

namespace upbead {

/// Null for elastic soil.
inline const SoilLawRow* row_of(SoilLaw law) {
  return law == SoilLaw::elastic ? nullptr : soil_law_rows()[static_cast<std::size_t>(law) - 1];
}

inline bool starts_from(RestStress rest, const Region& region) {
  const SoilLawRow* row = row_of(region.law);
  return row && row->rest == rest;
}

}  // namespace upbead
