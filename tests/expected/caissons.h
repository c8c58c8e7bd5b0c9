// Breakwaters of the tests.
#pragma once

#include "../waves/sections.h"
#include "upbead/expected/sliding_law.h"

namespace upbead::test {

/// A caisson of 4.27 MN/m on a mound of medium height; not from a publication.
inline Breakwater medium_caisson() {
  Breakwater caisson;
  caisson.section = sliding_section();
  return caisson;
}

/// 600 waves of 12 s.
inline SeaState storm(double significant_height) {
  return {significant_height, 12., 600., 0., 0.};
}

}  // namespace upbead::test
