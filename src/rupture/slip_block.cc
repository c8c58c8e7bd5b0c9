#include "rupture/slip_block.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "rupture/pattern_search.h"

namespace upbead {

namespace {

/// Ends behind and ahead, level, feet of the wedges behind and ahead, all from 0 to 1. Behind is where the ground slips
/// away from, so that a mirrored scene has the same places. Feet, not slopes: Rankine's wedges of the mobilised
/// friction phi_m, tan phi_m = tan phi'/F, fall at 45 + phi_m/2 and rise at 45 - phi_m/2, and so become steep and flat
/// where F is small; and of any two feet the one is behind the other.
using BlockPlace = std::array<double, 5>;

constexpr double steepest_behind = 1.536, steepest_ahead = 1.309;  // 88 and 75 degrees

std::optional<SlipBlock> block_at(const GroundSection& section, const CircleRange& range,
                                  const std::array<double, 2>& levels, const BlockPlace& place, SlipsTo slips) {
  const bool to_right = slips == SlipsTo::right;
  const double side = to_right ? 1. : -1.;
  const auto end = [&](bool is_left, double at) {
    return is_left ? range.from[1] - (range.from[1] - range.from[0]) * at * at
                   : range.to[0] + (range.to[1] - range.to[0]) * at * at;
  };
  const double behind = end(to_right, place[0]), ahead = end(!to_right, place[1]);
  const double level = levels[0] + (levels[1] - levels[0]) * place[2];
  const std::optional<double> top_behind = section.surface(behind), top_ahead = section.surface(ahead);
  if (!top_behind || !top_ahead || !(level < std::min(*top_behind, *top_ahead))) return std::nullopt;
  const double nearest = side * behind + (*top_behind - level) / std::tan(steepest_behind);
  const double farthest = side * ahead - (*top_ahead - level) / std::tan(steepest_ahead);
  if (!(farthest > nearest)) return std::nullopt;
  const double foot_behind = nearest + (farthest - nearest) * place[3] * place[3];
  const double foot_ahead = foot_behind + (farthest - foot_behind) * place[4];
  if (to_right) return SlipBlock{{behind, foot_behind, foot_ahead, ahead}, {*top_behind, level, level, *top_ahead}};
  return SlipBlock{{ahead, -foot_ahead, -foot_behind, behind}, {*top_ahead, level, level, *top_behind}};
}

/// Where the method or the wedges that are tried end: there less safe blocks may be, which have no factor.
bool is_at_limit(const BlockPlace& place, const FigureSafety& safety) {
  constexpr double near = 1e-3;
  return safety.least_m < 1.02 * least_m_alpha || place[4] > 1. - near;
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
  const Slices slices =
      slices_of(section, loads, line, block.x.front(), block.x.back(), n_slices, {block.x[1], block.x[2]});
  double force = loads.strip ? side * loads.strip->horizontal : 0.;
  for (const Slice& s : slices.list)
    force += (s.vertical * s.base.sine / s.base.cosine + side * s.horizontal) * s.width;
  FigureSafety found = safety_of(slices, force, [](const Slice& s) { return 1. / s.base.cosine; });
  found.from = block.x.front();
  found.to = block.x.back();
  return found;
}

namespace {

class BlockSearch {
 public:
  BlockSearch(const GroundSection& section, const GroundLoads& loads, SlipsTo slips, const CircleRange& range,
              const std::array<double, 2>& levels, const BlockOptions& options)
      : section_(section), loads_(loads), slips_(slips), range_(range), levels_(levels), options_(options) {}

  FoundBlock at(const BlockPlace& place, int n_slices) const {
    const std::optional<SlipBlock> block = block_at(section_, range_, levels_, place, slips_);
    if (!block) return {{}, {std::numeric_limits<double>::infinity(), NoFactor::outside, 0., 1., 0., 0.}};
    FoundBlock found{*block, block_safety(section_, loads_, *block, slips_, n_slices)};
    found.is_at_limit = is_at_limit(place, found.safety);
    return found;
  }

  std::vector<Valued<5>> on_grid(int& steep) const {
    std::vector<Valued<5>> all;
    const auto& n = options_.grid;
    for (int k = 0; k < n[0] * n[1] * n[2] * n[3] * n[4]; ++k) {
      int rest = k;
      BlockPlace place;
      for (std::size_t i = 0; i < place.size(); ++i, rest /= n[i - 1])
        place[i] = (rest % n[i]) / std::max(1., n[i] - 1.);
      const FigureSafety safety = at(place, options_.n_slices).safety;
      if (safety.why == NoFactor::steep) ++steep;
      all.push_back({place, safety.factor});
    }
    return all;
  }

  /// Differential evolution (Storn and Price 1997, J. Global Optimization 11, 341-359), from the best of the grid and
  /// as many at random: the factor has long narrow valleys, with kinks where a line runs along the top of a soil.
  Valued<5> evolved(std::vector<Valued<5>> population, int n_slices) {
    constexpr double amplification = 0.6, crossover = 0.9;
    for (Valued<5>& one : population) one.value = at(one.place, n_slices).safety.factor;
    for (std::size_t best = population.size(); best > 0; --best) {
      BlockPlace place;
      for (double& x : place) x = uniform();
      population.push_back({place, at(place, n_slices).safety.factor});
    }
    const auto any = [&] { return population[random_() % population.size()].place; };
    for (int generation = 0; generation < options_.n_generations; ++generation)
      for (Valued<5>& one : population) {
        const BlockPlace a = any(), b = any(), c = any();
        const std::size_t always = random_() % a.size();
        BlockPlace place = one.place;
        for (std::size_t i = 0; i < place.size(); ++i)
          if (i == always || uniform() < crossover) place[i] = std::clamp(a[i] + amplification * (b[i] - c[i]), 0., 1.);
        const double value = at(place, n_slices).safety.factor;
        if (value <= one.value) one = {place, value};
      }
    return *std::min_element(population.begin(), population.end(),
                             [](const auto& x, const auto& y) { return x.value < y.value; });
  }

  /// Steps at random that become longer where they gain, in a fifth of them (Rechenberg 1973, Evolutionsstrategie,
  /// Frommann-Holzboog, Stuttgart).
  Valued<5> polished(const BlockPlace& start, int n_slices) {
    Valued<5> best{start, at(start, n_slices).safety.factor};
    double step = 0.03;
    for (int i = 0; i < options_.n_polish; ++i) {
      BlockPlace place = best.place;
      for (double& x : place) x = std::clamp(x + step * (2. * uniform() - 1.), 0., 1.);
      const double value = at(place, n_slices).safety.factor;
      const bool gains = value < best.value;
      if (gains) best = {place, value};
      step = std::clamp(step * (gains ? 1.5 : 0.9), 1e-4, 0.2);
    }
    return best;
  }

 private:
  const GroundSection& section_;
  const GroundLoads& loads_;
  SlipsTo slips_;
  const CircleRange& range_;
  const std::array<double, 2>& levels_;
  const BlockOptions& options_;
  std::mt19937 random_{1};  // the same scene gives the same block
  double uniform() { return static_cast<double>(random_()) / 4294967295.; }
};

}  // namespace

std::optional<FoundBlock> search_blocks(const GroundSection& section, const GroundLoads& loads, SlipsTo slips,
                                        const CircleRange& range, const std::array<double, 2>& levels,
                                        const BlockOptions& options) {
  BlockSearch search(section, loads, slips, range, levels, options);
  int steep = 0;
  std::vector<Valued<5>> all = search.on_grid(steep);
  const double tried = static_cast<double>(all.size());
  std::vector<Valued<5>> best = best_apart(std::move(all), options.grid, options.starts);
  if (best.empty()) return std::nullopt;
  const BlockPlace coarse = search.evolved(std::move(best), 4 * options.n_slices).place;
  FoundBlock found = search.at(search.polished(coarse, options.n_slices_found).place, options.n_slices_found);
  if (!std::isfinite(found.safety.factor)) return std::nullopt;
  found.share_steep = steep / tried;
  return found;
}

}  // namespace upbead
