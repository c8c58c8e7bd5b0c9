// Safety of ground that slips on a plane, as along a weak layer, between a wedge that sinks behind it and one that is
// pushed up before it: horizontal forces, without shear between slices (Janbu 1954, Application of composite slip
// surfaces for stability analysis, European Conf. on Stability of Earth Slopes, Stockholm, 3, 43-49; Fredlund and Krahn
// 1977), and without Janbu's factor f_0 >= 1 on the result.
#pragma once

#include "rupture/circle_search.h"

namespace upbead {

/// Corners of the line below the ground that slips, from left to right; the first and the last are on the surface.
struct SlipBlock {
  std::array<double, 4> x{}, y{};  ///< m
};

FigureSafety block_safety(const GroundSection& section, const GroundLoads& loads, const SlipBlock& block, SlipsTo slips,
                          int n_slices);

struct FoundBlock {
  SlipBlock block;
  FigureSafety safety;
  /// It stands where m_alpha is 0.2 or where the wedges that are tried end: less safe blocks may have no factor, and
  /// its factor is no number of the section.
  bool is_at_limit = false;
  double share_steep = 0.;  ///< of the blocks of the grid, those that have no factor as m_alpha is below 0.2
};

struct BlockOptions {
  int n_slices = 30, n_slices_found = 400;
  std::array<int, 5> grid{6, 8, 8, 5, 5};  ///< ends behind and ahead, levels, wedges behind and ahead
  int starts = 25, n_generations = 150, n_polish = 1000;
};

/// The least safe block with ends in `range` and a level plane at y in `levels`; none where no block has a factor.
std::optional<FoundBlock> search_blocks(const GroundSection& section, const GroundLoads& loads, SlipsTo slips,
                                        const CircleRange& range, const std::array<double, 2>& levels,
                                        const BlockOptions& options = {});

}  // namespace upbead
