// Breakwaters of the tests.
#pragma once

#include "upbead/expected/sliding_law.h"

namespace upbead::test {

/// A caisson of 4.27 MN/m on a mound of medium height; not from a publication.
inline Breakwater medium_caisson() {
  Breakwater caisson;
  Section& s = caisson.section;
  s.water_depth = 15.;
  s.foundation_depth = 10.5;
  s.berm_depth = 8.5;
  s.crest = 6.;
  s.width = 12.;
  s.berm_width = 8.;
  s.bed_slope = 0.01;
  s.weight = 16.5 * 12. * 2200. * 9.81;
  s.submerged_weight = s.weight - 1030. * 9.81 * 10.5 * 12.;
  return caisson;
}

/// 600 waves of 12 s.
inline SeaState storm(double significant_height) {
  return {significant_height, 12., 600., 0., 0.};
}

}  // namespace upbead::test
