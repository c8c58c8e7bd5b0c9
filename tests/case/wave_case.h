// A case whose load is a wave on the section of section.toml.
#pragma once

#include <string>

#include "section_case.h"

namespace upbead::test {

inline const std::string section_table = R"([section]
water_depth = 15.0
foundation_depth = 9.0
berm_depth = 7.5
crest = 7.0
width = 18.0
berm_width = 7.0
bed_slope = 0.01
weight = 5.933088e6
submerged_weight = 4.296e6
)";

inline const std::string sliding_table = R"([sliding]
[sliding.uplift]
kind = "wave"
shape = "held"
)";

inline std::string wave_case(const std::string& wave, const std::string& mesh = "cells = 0.4, grading = 4") {
  const std::string load = "pulse = { shape = \"triangle\", peak = 1e6, duration = 0.15 }";
  return section_case({{"cells = 0.5, seabed_front = 60, seabed_back = 60", mesh},
                       {"[loads.impulse]", "[loads.storm]"},
                       {"kind = \"force\"", "kind = \"wave\""},
                       {load, "wave = " + wave},
                       {"end = 0.6", "end = 0.5\nstep = 0.01\n" + sliding_table + section_table}});
}

}  // namespace upbead::test
