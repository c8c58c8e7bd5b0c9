// Cross-sections that several tests share.
#pragma once

#include <cmath>

#include "upbead/waves/goda.h"

namespace upbead::test {

constexpr double degree = 3.14159265358979323846 / 180.;

/// The example of Goda (2000), p. 140, with a berm of 8 m added for alpha_I. Its caisson has 2.1 and 2.4 t/m3 below and
/// above still water.
inline Section goda_section() {
  Section s;
  s.water_depth = 10.1;
  s.foundation_depth = 7.1;
  s.berm_depth = 5.6;
  s.crest = 3.4;
  s.width = 15.;
  s.berm_width = 8.;
  s.bed_slope = 0.01;
  s.weight = 346.05e3 * 9.81;
  s.submerged_weight = 2318.643e3;
  return s;
}

/// Its wave, with the heights that H_0' = 6.3 m gives by random breaking, rounded as in the book.
inline DesignWave goda_wave() {
  return {8.05, 5.796, 11.4, 15. * degree};
}

/// The section of the regression table for sliding: declared, not published.
inline Section sliding_section() {
  Section s;
  s.water_depth = 15.;
  s.foundation_depth = 10.5;
  s.berm_depth = 8.5;
  s.crest = 6.;
  s.width = 12.;
  s.berm_width = 8.;
  s.bed_slope = 0.01;
  s.weight = 16.5 * 12. * 2200. * 9.81;
  s.submerged_weight = s.weight - 1030. * 9.81 * 10.5 * 12.;
  return s;
}

/// base.toml of a stranger, who worked it out by hand.
inline Section stranger_section() {
  Section s;
  s.water_depth = 12.;
  s.foundation_depth = s.berm_depth = 7.;
  s.crest = 10.;
  s.width = 20.;
  s.berm_width = 8.;
  s.bed_slope = 0.02;
  s.weight = 7.004e6;
  s.submerged_weight = 5.589e6;
  return s;
}

/// 12 s, head-on, H_1/3 = H/1.8.
inline DesignWave sliding_wave(double height) {
  return {height, height / 1.8, 12., 0.};
}

}  // namespace upbead::test
