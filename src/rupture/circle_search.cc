#include "rupture/circle_search.h"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>

#include "rupture/pattern_search.h"

namespace upbead {

namespace {

/// Where in the unit cube a circle is: where its ends are in their ranges, how deep it goes.
using Place = std::array<double, 3>;

struct Arc {
  double from = 0., to = 0.;
  double lowest = 0.;  ///< y of the circle's lowest point
  SlipCircle circle;
};

/// The straight line between the ends of an arc. Ends are closer to each other where the ranges face each other.
struct Chord {
  double from = 0., to = 0., left = 0., right = 0.;
  double length() const { return std::hypot(to - from, right - left); }
  double slope() const { return std::abs(std::atan2(right - left, to - from)); }
  /// The angle between chord and arc with which the arc is vertical at one end.
  double largest_angle() const { return boost::math::constants::half_pi<double>() - slope(); }
};

std::optional<Chord> chord_at(const GroundSection& section, const CircleRange& range, const Place& place) {
  Chord chord;
  chord.from = range.from[1] - (range.from[1] - range.from[0]) * place[0] * place[0];
  chord.to = range.to[0] + (range.to[1] - range.to[0]) * place[1] * place[1];
  const std::optional<double> left = section.surface(chord.from), right = section.surface(chord.to);
  if (!left || !right || !(chord.to > chord.from)) return std::nullopt;
  chord.left = *left;
  chord.right = *right;
  return chord;
}

Arc arc_of(const Chord& chord, double angle) {
  const double above = 0.5 / std::tan(angle), radius = 0.5 * chord.length() / std::sin(angle);
  const SlipCircle circle{0.5 * (chord.from + chord.to) - above * (chord.right - chord.left),
                          0.5 * (chord.left + chord.right) + above * (chord.to - chord.from), radius};
  return {chord.from, chord.to, circle.y - radius, circle};
}

std::optional<Arc> arc_at(const GroundSection& section, const CircleRange& range, const Place& place) {
  const std::optional<Chord> chord = chord_at(section, range, place);
  const double angle = chord ? place[2] * chord->largest_angle() : 0.;
  if (!(angle > 1e-3)) return std::nullopt;
  return arc_of(*chord, angle);
}

/// The place between the same ends whose circle is as low as that; unchanged where there is none that goes down and up.
/// Where a soil below is stronger, the least circle touches it, and is found only along such circles.
Place as_low_as(const GroundSection& section, const CircleRange& range, Place place, double lowest) {
  const std::optional<Chord> chord = chord_at(section, range, place);
  if (!chord) return place;
  double shallow = std::max(chord->slope(), 2e-3), deep = chord->largest_angle();
  if (!(deep > shallow) || arc_of(*chord, shallow).lowest < lowest || arc_of(*chord, deep).lowest > lowest)
    return place;
  const double largest = deep;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (shallow + deep);
    (arc_of(*chord, middle).lowest > lowest ? shallow : deep) = middle;
  }
  place[2] = shallow / largest;
  return place;
}

class CircleTrials {
 public:
  CircleTrials(const GroundSection& section, const GroundLoads& loads, SlipsTo slips, const CircleRange& range)
      : section_(section), loads_(loads), slips_(slips), range_(range) {}

  FoundCircle at(const Place& place, int n_slices) const {
    const std::optional<Arc> arc = arc_at(section_, range_, place);
    if (!arc) return {{}, {std::numeric_limits<double>::infinity(), NoFactor::outside, 0., 1., 0., 0.}};
    return {arc->circle, circle_safety(section_, loads_, arc->circle, slips_, arc->from, arc->to, n_slices)};
  }

  /// Ends move with the lowest point held, then with the angle between chord and arc.
  std::vector<Place> moved(const Place& place, std::size_t i, double by) const {
    Place other = place;
    other[i] = std::clamp(place[i] + by, 0., 1.);
    const std::optional<Arc> arc = arc_at(section_, range_, place);
    if (i == 2 || !arc) return {other};
    return {as_low_as(section_, range_, other, arc->lowest), other};
  }

  Valued<3> refined(const Place& start, const std::array<int, 3>& grid, int n_slices) const {
    const auto value_at = [&](const Place& place) { return at(place, n_slices).safety.factor; };
    const auto places = [&](const Place& place, std::size_t i, double by) { return moved(place, i, by); };
    return PatternSearch<3, decltype(value_at), decltype(places)>(value_at, places).from(start, grid);
  }

 private:
  const GroundSection& section_;
  const GroundLoads& loads_;
  SlipsTo slips_;
  const CircleRange& range_;
};

std::vector<Place> places_of(const std::array<int, 3>& n) {
  std::vector<Place> all;
  for (int i = 0; i < n[0]; ++i)
    for (int j = 0; j < n[1]; ++j)
      for (int k = 1; k <= n[2]; ++k)
        all.push_back({i / std::max(1., n[0] - 1.), (j + 0.5) / n[1], k / static_cast<double>(n[2])});
  return all;
}

}  // namespace

CircleRange range_beside(const GroundSection& section, const StripLoad& strip) {
  return {{section.left(), strip.from}, {strip.to, section.right()}};
}

CircleSearch search_circles(const GroundSection& section, const GroundLoads& loads, SlipsTo slips,
                            const CircleRange& range, const SearchOptions& options) {
  const CircleTrials trials(section, loads, slips, range);
  CircleSearch search;
  std::vector<Valued<3>> all;
  for (const Place& place : places_of(options.grid)) {
    const FigureSafety safety = trials.at(place, options.n_slices).safety;
    all.push_back({place, safety.factor});
    if (safety.why == NoFactor::steep) ++search.steep;
  }
  search.tried = static_cast<int>(all.size());
  for (const Valued<3>& start : best_apart(std::move(all), options.grid, options.starts)) {
    const Valued<3> coarse = trials.refined(start.place, options.grid, options.n_slices);
    const Valued<3> fine = trials.refined(coarse.place, options.grid, options.n_slices_found);
    if (std::isfinite(fine.value)) search.family.push_back(trials.at(fine.place, options.n_slices_found));
  }
  std::sort(search.family.begin(), search.family.end(),
            [](const FoundCircle& a, const FoundCircle& b) { return a.safety.factor < b.safety.factor; });
  return search;
}

}  // namespace upbead
