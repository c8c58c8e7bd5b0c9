// The least value of a function on the unit cube that has several minima and jumps: a grid, then pattern searches
// (Hooke and Jeeves 1961, "Direct search" solution of numerical and statistical problems, J. ACM 8(2)) from its best
// points.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace upbead {

/// A point of the unit cube, and the value there; infinity where there is none.
template <std::size_t N>
struct Valued {
  std::array<double, N> place{};
  double value = 0.;
};

/// The best of the points, at most n, no two of which are within 2.5 steps of the grid in all directions.
template <std::size_t N>
std::vector<Valued<N>> best_apart(std::vector<Valued<N>> all, const std::array<int, N>& grid, int n) {
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.value < b.value; });
  const auto is_near = [&grid](const Valued<N>& a, const Valued<N>& b) {
    for (std::size_t i = 0; i < N; ++i)
      if (std::abs(a.place[i] - b.place[i]) > 2.5 / grid[i]) return false;
    return true;
  };
  std::vector<Valued<N>> chosen;
  for (const Valued<N>& one : all) {
    if (!std::isfinite(one.value) || static_cast<int>(chosen.size()) == n) break;
    if (std::none_of(chosen.begin(), chosen.end(), [&](const Valued<N>& other) { return is_near(one, other); }))
      chosen.push_back(one);
  }
  return chosen;
}

/// Gains less than this, relative, count as none.
constexpr double least_gain = 1e-6;

template <std::size_t N, class ValueAt, class Moved>
class PatternSearch {
 public:
  using Place = std::array<double, N>;

  /// value_at(place); moved(place, i, by): places to try for a move along coordinate i, in their order.
  PatternSearch(const ValueAt& value_at, const Moved& moved) : value_at_(value_at), moved_(moved) {}

  /// From `start`, with steps of 1/grid that are halved down to 1e-4.
  Valued<N> from(const Place& start, const std::array<int, N>& grid) const {
    Valued<N> best{start, value_at_(start)};
    Place step;
    for (std::size_t i = 0; i < N; ++i) step[i] = 1. / grid[i];
    while (*std::max_element(step.begin(), step.end()) > 1e-4) {
      Valued<N> next = explored(best, step);
      if (!is_better(next, best))
        for (double& s : step) s *= 0.5;
      while (is_better(next, best)) {
        const Place ahead = beyond(best.place, next.place);
        best = next;
        next = explored({ahead, value_at_(ahead)}, step);
      }
    }
    return best;
  }

 private:
  static bool is_better(const Valued<N>& a, const Valued<N>& b) { return a.value < (1. - least_gain) * b.value; }

  /// Moves `best` along a coordinate where that gains; whether it does.
  bool goes(Valued<N>& best, std::size_t i, double by) const {
    for (const Place& place : moved_(best.place, i, by)) {
      const Valued<N> tried{place, value_at_(place)};
      if (!is_better(tried, best)) continue;
      best = tried;
      return true;
    }
    return false;
  }

  /// The best of the places one step away, along one coordinate after the other.
  Valued<N> explored(Valued<N> best, const Place& step) const {
    for (std::size_t i = 0; i < N; ++i)
      if (!goes(best, i, step[i])) goes(best, i, -step[i]);
    return best;
  }

  /// What was a step to something better is tried twice as long.
  static Place beyond(const Place& before, const Place& now) {
    Place place;
    for (std::size_t i = 0; i < N; ++i) place[i] = std::clamp(2. * now[i] - before[i], 0., 1.);
    return place;
  }

  const ValueAt& value_at_;
  const Moved& moved_;
};

}  // namespace upbead
