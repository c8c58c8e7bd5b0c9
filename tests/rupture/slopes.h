// Sections for tests: a slope between level grounds, of layers whose tops are lines.
#pragma once

#include <array>
#include <vector>

#include "rupture/section.h"

namespace upbead::test {

using Polyline = std::vector<std::array<double, 2>>;

struct SlopeLayer {
  GroundSoil soil;
  Polyline top;  ///< from left to right
};

inline GroundSoil soil_of(double weight, double cohesion, double degrees) {
  GroundSoil soil;
  soil.weight = soil.submerged = weight;
  soil.cohesion = cohesion;
  soil.friction = std::tan(degrees * std::acos(-1.) / 180.);
  return soil;
}

/// Layers from the top downwards; the last ends at `bottom`.
inline GroundSection section_of(const std::vector<SlopeLayer>& layers, double bottom,
                                std::optional<double> water_level = std::nullopt) {
  std::vector<GroundSoil> soils;
  std::vector<GroundLine> lines;
  const auto add = [&lines](const Polyline& top, int below) {
    for (std::size_t i = 0; i + 1 < top.size(); ++i)
      if (top[i + 1][0] > top[i][0]) lines.push_back({{top[i][0], top[i + 1][0]}, {top[i][1], top[i + 1][1]}, below});
  };
  for (const SlopeLayer& layer : layers) {
    add(layer.top, static_cast<int>(soils.size()));
    soils.push_back(layer.soil);
  }
  add({{layers[0].top.front()[0], bottom}, {layers[0].top.back()[0], bottom}}, no_soil);
  return GroundSection(soils, lines, water_level);
}

}  // namespace upbead::test
