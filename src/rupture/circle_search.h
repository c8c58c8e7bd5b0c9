// The circle with the least factor of safety.
#pragma once

#include <vector>

#include "rupture/slip_circle.h"

namespace upbead {

/// Where circles meet the surface (m): the part that slips goes from x in `from` to x in `to`.
struct CircleRange {
  std::array<double, 2> from{}, to{};
};

/// All of the section that leaves the whole strip on the part that slips.
CircleRange range_beside(const GroundSection& section, const StripLoad& strip);

struct FoundCircle {
  SlipCircle circle;
  FigureSafety safety;
};

struct CircleSearch {
  std::vector<FoundCircle> family;  ///< local minima, the least first; empty where no circle has a factor
  int tried = 0;                    ///< circles
  int steep = 0;                    ///< of these: left out, as m_alpha is too small for the method
};

struct SearchOptions {
  int n_slices = 40;                    ///< while it searches
  int n_slices_found = 400;             ///< for the factors of what it found
  std::array<int, 3> grid{10, 20, 12};  ///< circles tried first: ends on the left, on the right, depths
  int starts = 6;                       ///< of the best of these, apart from each other, from which circles are refined
};

/// Tries a grid of circles, then refines several of its best (pattern_search.h). No circle overhangs: its centre is not
/// below its ends.
CircleSearch search_circles(const GroundSection& section, const GroundLoads& loads, SlipsTo slips,
                            const CircleRange& range, const SearchOptions& options = {});

}  // namespace upbead
