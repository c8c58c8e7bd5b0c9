#include "rupture/slip_block.h"

#include <algorithm>
#include <cmath>

#include "rupture/pattern_search.h"

namespace upbead {

namespace {

/// Ends on the left and on the right, level, slopes of the wedges below these ends, all from 0 to 1.
using BlockPlace = std::array<double, 5>;

/// Wedges rise at 15 to 75 degrees.
double run_of_wedge(double height, double place) {
  constexpr double flattest = 0.262, steepest = 1.309;
  return height / std::tan(flattest + (steepest - flattest) * place);
}

std::optional<SlipBlock> block_at(const GroundSection& section, const CircleRange& range,
                                  const std::array<double, 2>& levels, const BlockPlace& place) {
  const double from = range.from[1] - (range.from[1] - range.from[0]) * place[0] * place[0];
  const double to = range.to[0] + (range.to[1] - range.to[0]) * place[1] * place[1];
  const double level = levels[0] + (levels[1] - levels[0]) * place[2];
  const std::optional<double> left = section.surface(from), right = section.surface(to);
  if (!left || !right || !(level < std::min(*left, *right))) return std::nullopt;
  const double first = from + run_of_wedge(*left - level, place[3]);
  const double last = to - run_of_wedge(*right - level, place[4]);
  if (!(last > first)) return std::nullopt;
  return SlipBlock{{from, first, last, to}, {*left, level, level, *right}};
}

}  // namespace

FigureSafety block_safety(const GroundSection& section, const GroundLoads& loads, const SlipBlock& block, SlipsTo slips,
                          int n_slices) {
  const double side = slips == SlipsTo::right ? 1. : -1.;
  const auto line = [&](double x) -> std::optional<BasePoint> {
    for (std::size_t i = 0; i + 1 < block.x.size(); ++i) {
      const double dx = block.x[i + 1] - block.x[i], dy = block.y[i + 1] - block.y[i];
      if (x > block.x[i + 1] || !(dx > 0.)) continue;
      const double length = std::hypot(dx, dy);
      return BasePoint{block.y[i] + dy * (x - block.x[i]) / dx, -side * dy / length, dx / length};
    }
    return std::nullopt;
  };
  const Slices slices = slices_of(section, loads, line, block.x.front(), block.x.back(), n_slices);
  double force = loads.strip ? side * loads.strip->horizontal : 0.;
  for (const Slice& s : slices.list)
    force += (s.vertical * s.base.sine / s.base.cosine + side * s.horizontal) * s.width;
  FigureSafety found = safety_of(slices, force, [](const Slice& s) { return 1. / s.base.cosine; });
  found.from = block.x.front();
  found.to = block.x.back();
  return found;
}

std::optional<FoundBlock> search_blocks(const GroundSection& section, const GroundLoads& loads, SlipsTo slips,
                                        const CircleRange& range, const std::array<double, 2>& levels,
                                        const BlockOptions& options) {
  const auto found_at = [&](const BlockPlace& place, int n) {
    const std::optional<SlipBlock> block = block_at(section, range, levels, place);
    return block ? FoundBlock{*block, block_safety(section, loads, *block, slips, n)} : FoundBlock{};
  };
  const auto moved = [](BlockPlace place, std::size_t i, double by) {
    place[i] = std::clamp(place[i] + by, 0., 1.);
    return std::vector<BlockPlace>{place};
  };
  const auto refined = [&](const BlockPlace& start, int n) {
    const auto value_at = [&](const BlockPlace& place) { return found_at(place, n).safety.factor; };
    return PatternSearch<5, decltype(value_at), decltype(moved)>(value_at, moved).from(start, options.grid).place;
  };
  std::vector<Valued<5>> all;
  const auto& n = options.grid;
  for (int k = 0; k < n[0] * n[1] * n[2] * n[3] * n[4]; ++k) {
    int rest = k;
    BlockPlace place;
    for (std::size_t i = 0; i < place.size(); ++i, rest /= n[i - 1]) place[i] = (rest % n[i]) / std::max(1., n[i] - 1.);
    all.push_back({place, found_at(place, options.n_slices).safety.factor});
  }
  std::optional<FoundBlock> least;
  for (const Valued<5>& start : best_apart(std::move(all), options.grid, options.starts)) {
    const FoundBlock found =
        found_at(refined(refined(start.place, options.n_slices), options.n_slices_found), options.n_slices_found);
    if (!least || found.safety.factor < least->safety.factor) least = found;
  }
  return least;
}

}  // namespace upbead
