#include "case/new_case.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/text.h"
#include "upbead/base/error.h"
#include "upbead/input/node.h"

namespace upbead {

namespace {

// {NAME} stands for a number of the section
const char* const pattern =
    R"(# Complete it in an editor that reads TOML and its schema; `upbead explain --keys` tells every key.
# Written from a few numbers. What is marked "assumed" is to be replaced by what is known of the site.

title = "{title}"

[mesh]
geometry = "composite"  # a shipped section; or file = "own.geo"
[mesh.parameters]       # m
caisson_width = {width}
caisson_height = {height}
mound_height = {mound}
mound_crest_front = {crest_side}  # from the caisson's middle
mound_crest_back = {crest_side}
mound_slope = 2  # assumed
seabed_depth = {seabed}
seabed_front = {far}  # no echo of the sides before the end
seabed_back = {far}
water_depth = {depth}
sea_front = {sea}  # length over depth
sea_back = {sea}

[section]  # for the wave's pressure, by Goda's formula with the impulsive pressure coefficient
water_depth = {depth}
foundation_depth = {foundation}  # still water to the caisson's bottom
berm_depth = {berm}  # still water to the top of the armour
crest = {crest}  # of the caisson above still water
width = {width}
berm_width = {shoulder}
bed_slope = 0.01  # assumed
weight = {weight}  # N/m, of the caisson of {density} kg/m3
submerged_weight = {submerged}
friction = 0.6  # of concrete on rubble, assumed

[loads.wave]
boundary = "front"
kind = "wave"
[loads.wave.wave]
height = {wave_height}  # highest wave (m)
period = {period}  # s
course = "church_roof"  # an impulsive peak before half a standing wave; or standing, triangle, sine, combined
# The peak of the impact is Goda's P with alpha*, the least that may be assumed; measured peaks scatter up to several
# times that: [loads.wave.wave.impact] peak_gain. The checks by Goda's formulas stand beside those of this run.
force = "impulse"  # the wave's own, as the ground's dynamics are solved here

[sliding]  # friction and weights of [section]
[sliding.uplift]
kind = "wave"
shape = "held"  # the safe side

[limits]
sliding = 0.3  # m, assumed
base_pressure = 600e3  # Pa, of Goda's p_e, assumed
overturning = 1.2  # assumed

[regions.seabed]  # sand, assumed
kind = "porous"
shear_modulus = 40e6  # at small strain (Pa)
poissons_ratio = 0.33
porosity = 0.40
grain_density = 2650.0
hydraulic_conductivity = 1e-4  # m/s
damping = { ratio = 0.05, frequencies = [1, 10] }

[regions.mound]  # rubble, assumed
kind = "porous"
shear_modulus = 80e6
poissons_ratio = 0.30
porosity = 0.40
grain_density = 2650.0
hydraulic_conductivity = 0.2
damping = { ratio = 0.05, frequencies = [1, 10] }

[regions.caisson]
kind = "rigid"
density = {density}  # of concrete, fill and pores together, assumed

[regions.sea_front]
kind = "water"

[regions.sea_back]
kind = "water"

[boundaries]
base = { displacement = "fixed", pressure = "sealed" }  # rock
left = { displacement = "absorbing", pressure = "absorbing" }  # the ground goes on
right = { displacement = "absorbing", pressure = "absorbing" }
bed = { pressure = "open" }
mound_surface = { pressure = "open" }
sea_surface = { pressure = "open" }
sea_left = { pressure = "absorbing" }
sea_right = { pressure = "absorbing" }
front = {}
back = {}
top = {}

[time]
end = {end}  # s; the wave is over at T/2
)";

void require_it_stands(const NewCase& s) {
  Diagnostics wrong;
  if (s.mound + s.armour >= s.depth)
    wrong.add(Place{},
              "the mound and its armour, " + significant(s.mound + s.armour) + " m, reach above the water, " +
                  significant(s.depth) + " m deep",
              "give a larger --depth, or a smaller --mound");
  if (s.mound + s.height <= s.depth)
    wrong.add(Place{},
              "the caisson's top, " + significant(s.mound + s.height) + " m above the seabed, lies under water",
              "give a larger --height");
  wrong.throw_if_any();
}

}  // namespace

std::string new_case(const NewCase& s, const std::string& title) {
  require_it_stands(s);
  constexpr double density = 2100., water = 1030., gravity = 9.81;
  const double foundation = s.depth - s.mound, weight = density * gravity * s.width * s.height;
  const std::map<std::string, double> numbers{
      {"width", s.width},
      {"height", s.height},
      {"mound", s.mound},
      {"crest_side", 0.5 * s.width + s.shoulder},
      {"seabed", s.seabed},
      {"depth", s.depth},
      {"foundation", foundation},
      {"berm", foundation - s.armour},
      {"crest", s.height - foundation},
      {"shoulder", s.shoulder},
      {"weight", weight},
      {"submerged", weight - water * gravity * s.width * foundation},
      {"wave_height", s.wave_height},
      {"period", s.period},
      {"end", 0.5 * s.period + 0.5},
      {"density", density},
      {"sea", std::max(6., 1. + std::ceil((s.shoulder + 2. * s.mound) / s.depth))},  // beyond the toe of 1 : 2
      {"far", std::ceil(80. * (0.5 * s.period + 0.5) / 10.) * 10.},  // half the path of a shear wave of 160 m/s
  };
  std::string text = pattern;
  const auto fill = [&text](const std::string& name, const std::string& value) {
    const std::string mark = "{" + name + "}";
    for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at + value.size()))
      text.replace(at, mark.size(), value);
  };
  for (const auto& [name, value] : numbers) fill(name, number_text(value));
  fill("title", title);
  return text;
}

}  // namespace upbead
