#include "findings/circle_ground.h"

#include <algorithm>
#include <cmath>

#include "fem/compile.h"
#include "fem/surcharge.h"
#include "findings/topics.h"
#include "upbead/rupture/circle_family.h"

namespace upbead {

namespace {

constexpr double widths_beside = 4.;

SlipCircleFound told(const FoundCircle& found, const BaseMoment& moment, const StripLoad& strip, SlipsTo slips) {
  SlipCircleFound s;
  s.factor = found.safety.factor;
  s.driving = found.safety.driving;
  s.time = moment.time;
  s.slips = slips == SlipsTo::right ? "landward" : "seaward";
  s.centre = {found.circle.x, found.circle.y};
  s.radius = found.circle.radius;
  s.from = found.safety.from;
  s.to = found.safety.to;
  s.force = moment.force;
  s.shear = moment.shear;
  s.moment = moment.moment;
  s.strip_from = strip.from;
  s.strip_to = strip.to;
  return s;
}

/// The less safe of two.
std::optional<SlipCircleFound> worse(const std::optional<SlipCircleFound>& a, const std::optional<SlipCircleFound>& b) {
  if (!a || !b) return a ? a : b;
  return b->factor < a->factor ? b : a;
}

/// Tells which moments the least circle may be of, before it is sought as far as it needs; it errs by some percent.
const SearchOptions rough{30, 60, {8, 14, 10}, 2};
constexpr double rough_error = 0.25;

SlipsTo way_of(const SlipCircleFound& circle) {
  return circle.slips == "landward" ? SlipsTo::right : SlipsTo::left;
}

}  // namespace

std::function<double(double)> surcharge_of(const Simulation& simulation) {
  std::vector<SurchargePiece> pieces = surcharge_pieces(simulation.scene(), *simulation.mesh());
  const auto is_on_caisson = [&](const SurchargePiece& piece) {
    return simulation.mesh()->surface_of(piece.cell) == caisson_name;
  };
  pieces.erase(std::remove_if(pieces.begin(), pieces.end(), is_on_caisson), pieces.end());
  if (pieces.empty()) return {};
  return [pieces = std::move(pieces)](double x) {
    double sum = 0.;
    for (const SurchargePiece& piece : pieces)
      if (x >= piece.from && x < piece.to) sum += piece.weight;
    return sum;
  };
}

CircleGround::CircleGround(const Simulation& simulation)
    : section(ground_section(simulation)), surcharge(surcharge_of(simulation)) {
  const Caisson& caisson = *simulation.compiled()->caisson;
  const double B = caisson.bottom_width;
  left = caisson.bottom_centre[0] - 0.5 * B;
  right = left + B;
  level = caisson.bottom_centre[1];
  from = std::max(section.left(), left - widths_beside * B);
  to = std::min(section.right(), right + widths_beside * B);
}

CircleRange range_beside(const CircleGround& ground, const StripLoad& strip) {
  return {{ground.from, strip.from}, {strip.to, ground.to}};
}

std::optional<CircleSearch> search_one_way(const CircleGround& ground, const GroundLoads& loads,
                                           const BaseMoment& moment, SlipsTo slips, const SearchOptions& options) {
  if (!may_slip(moment.shear, moment.moment, slips)) return std::nullopt;
  return search_circles(ground.section, loads, slips, range_beside(ground, *loads.strip), options);
}

std::vector<BaseMoment> moments_to_look_at(const EffectiveBase& base, const std::vector<double>& shear,
                                           const std::vector<double>& time) {
  std::vector<BaseMoment> moments;
  for (const std::size_t i : moments_that_may_govern(base.force, base.moment, shear, base.width))
    moments.push_back({time[i], base.force[i], shear[i], base.moment[i]});
  return moments;
}

std::optional<GroundLoads> loads_of(const CircleGround& ground, const BaseMoment& moment, const PressureAt& pressure) {
  GroundLoads loads;
  loads.strip = effective_strip(moment.force, moment.moment, moment.shear, ground.left, ground.right, ground.level);
  if (!loads.strip) return std::nullopt;
  loads.pressure = pressure;
  loads.surcharge = ground.surcharge;
  return loads;
}

LookedFor least_circle(const CircleGround& ground, const BaseMoment& moment, const PressureAt& pressure,
                       const SearchOptions& options) {
  LookedFor found;
  const std::optional<GroundLoads> loads = loads_of(ground, moment, pressure);
  if (!loads) return found;
  for (const SlipsTo slips : {SlipsTo::right, SlipsTo::left}) {
    const std::optional<CircleSearch> search = search_one_way(ground, *loads, moment, slips, options);
    if (!search) continue;
    found.tried += search->tried;
    found.steep += search->steep;
    if (!search->family.empty())
      found.least = worse(found.least, told(search->family[0], moment, *loads->strip, slips));
  }
  return found;
}

LookedFor least_of_moments(const CircleGround& ground, const std::vector<BaseMoment>& moments,
                           const std::function<PressureAt(double time)>& pressure_at) {
  std::vector<double> roughly;
  for (const BaseMoment& moment : moments) {
    const LookedFor found = least_circle(ground, moment, pressure_at(*moment.time), rough);
    roughly.push_back(found.least ? found.least->factor : HUGE_VAL);
  }
  LookedFor all;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    if (roughly[i] > (1. + rough_error) * *std::min_element(roughly.begin(), roughly.end())) continue;
    const LookedFor found = least_circle(ground, moments[i], pressure_at(*moments[i].time));
    all.least = worse(all.least, found.least);
    all.tried += found.tried;
    all.steep += found.steep;
  }
  return all;
}

PointGrid grid_of(const CircleGround& ground) {
  double low = ground.level, high = ground.level;
  for (int i = 0; i <= 100; ++i)
    high = std::max(high, ground.section.surface(ground.from + (ground.to - ground.from) * i / 100.).value_or(low));
  const double B = ground.right - ground.left;
  low -= widths_beside * B;
  const auto points = [B](double length) { return 2 + static_cast<int>(40. * length / B); };
  return {{ground.from, ground.to}, {low, high}, {points(ground.to - ground.from), points(high - low)}};
}

std::optional<FoundBlock> least_block(const CircleGround& ground, const SlipCircleFound& circle,
                                      const PressureAt& pressure) {
  const auto loads = loads_of(ground, {circle.time, circle.force, circle.shear, circle.moment}, pressure);
  if (!loads) return std::nullopt;
  const double B = ground.right - ground.left;
  return search_blocks(ground.section, *loads, way_of(circle), range_beside(ground, *loads->strip),
                       {ground.level - 2. * B, ground.level});
}

FigureSafety safety_at(const CircleGround& ground, const SlipCircleFound& circle, const BaseMoment& moment,
                       const PressureAt& pressure, int n_slices) {
  const auto loads = loads_of(ground, moment, pressure);
  if (!loads) return {};
  return circle_safety(ground.section, *loads, {circle.centre[0], circle.centre[1], circle.radius}, way_of(circle),
                       circle.from, circle.to, n_slices);
}

FigureSafety widened_safety_at(const CircleGround& ground, SlipCircleFound circle, const BaseMoment& moment,
                               const PressureAt& pressure) {
  const auto loads = loads_of(ground, moment, pressure);
  if (!loads) return {};
  const double from = std::min(circle.from, loads->strip->from), to = std::max(circle.to, loads->strip->to);
  const auto left = ground.section.surface(from), right = ground.section.surface(to);
  if ((from < circle.from || to > circle.to) && left && right) {
    const double x = 0.5 * (circle.from + circle.to), away = circle.centre[0] - x;
    const double y = circle.centre[1] - std::sqrt(circle.radius * circle.radius - away * away);
    // the centre is as far from both ends as from the middle (x, y) of the arc
    const double a = 2. * (from - x), b = 2. * (*left - y), c = 2. * (to - x), d = 2. * (*right - y);
    const double e = from * from - x * x + *left * *left - y * y, f = to * to - x * x + *right * *right - y * y;
    circle.centre = {(e * d - b * f) / (a * d - b * c), (a * f - e * c) / (a * d - b * c)};
    circle.radius = std::hypot(circle.centre[0] - x, circle.centre[1] - y);
    circle.from = from;
    circle.to = to;
  }
  return safety_at(ground, circle, moment, pressure);
}

SlipCircleSlices slices_at(const CircleGround& ground, const SlipCircleFound& circle, const PressureAt& pressure,
                           int n_slices) {
  SlipCircleSlices told;
  const auto loads = loads_of(ground, {circle.time, circle.force, circle.shear, circle.moment}, pressure);
  if (!loads) return told;
  const auto arc = arc_of({circle.centre[0], circle.centre[1], circle.radius}, way_of(circle));
  for (const Slice& s : slices_of(ground.section, *loads, arc, circle.from, circle.to, n_slices).list) {
    told.x.push_back(s.x);
    told.width.push_back(s.width);
    told.base.push_back(s.base.y);
    told.surface.push_back(ground.section.surface(s.x).value_or(s.base.y));
    told.weight.push_back(s.vertical);
    told.pressure.push_back(s.vertical - s.normal);
  }
  return told;
}

std::string why_no_circles_in(const Simulation& simulation) {
  const Scene& scene = simulation.scene();
  if (!simulation.compiled()->caisson) return "there is no caisson";
  if (std::none_of(scene.regions.begin(), scene.regions.end(), [](const auto& r) { return r.second.strength; }))
    return "no region has a table strength";
  if (is_shaken(scene)) return "a motion shakes the ground, and slices have no inertia";
  return "";
}

}  // namespace upbead
