#include "findings/circle_model.h"

#include <algorithm>
#include <cmath>

#include "base/stopwatch.h"
#include "dynamics/readings_at.h"
#include "fem/caisson/readings.h"
#include "fem/compile.h"
#include "findings/circle_ground.h"
#include "findings/effective_base.h"
#include "response/reduction.h"
#include "rupture/fixed_circle.h"

namespace upbead {

namespace {

constexpr int slices_of_family = 40;
constexpr double width_step = 0.035;   // between levels, of the base: arcs are far longer than the effective width
constexpr double largest_scale = 50.;  // of the scene's own wave
const SearchOptions of_family{30, 100, {8, 14, 10}, 3};

/// The scene's own wave: what it changes of the base's load over time, which grows with the wave.
struct OwnWave {
  std::vector<double> time;
  BaseMoment rest;
  std::vector<double> force, shear, moment;  ///< changes

  /// The load at a time under `scale` times the wave.
  BaseMoment at(std::size_t i, double scale) const {
    return {time[i], rest.force + scale * force[i], rest.shear + scale * shear[i], rest.moment + scale * moment[i]};
  }
};

std::optional<OwnWave> own_wave(const Simulation& simulation, const Reduction& reduction) {
  const System& system = simulation.system();
  const Response response = respond(reduction, simulation.scene(), system);
  const std::optional<EffectiveBase> base = effective_base(simulation, response.ends);
  if (!base) return std::nullopt;
  OwnWave own{response.ends.time, {{}, base->weight, base->push, base->weight_moment}, {}, {}, {}};
  const auto F = response.ends.reading.row(system.reading(reading::shear_force));
  for (std::size_t i = 0; i < own.time.size(); ++i) {
    own.force.push_back(base->force[i] - base->weight);
    own.moment.push_back(base->moment[i] - base->weight_moment);
    own.shear.push_back(F[static_cast<Eigen::Index>(i)]);
  }
  return own;
}

/// What the making of a family needs everywhere.
struct Making {
  Making(const Simulation& scene, const PressureModel& pressures, OwnWave wave)
      : ground(scene), map(scene, pressures, grid_of(ground)), own(std::move(wave)) {
    family.left = ground.left;
    family.right = ground.right;
    family.level = ground.level;
  }
  double width() const { return ground.right - ground.left; }

  CircleGround ground;
  PressureMap map;
  OwnWave own;
  CircleFamily family;
};

PressureAt scaled_pressure(const PressureMap& map, const BaseMoment& moment, double scale) {
  return [at = map.at(*moment.time), scale](double x, double y) { return scale * at(x, y); };
}

/// The least circle of a moment one way; none where none has a factor.
std::optional<FoundCircle> least_one(const CircleGround& ground, const BaseMoment& moment, const PressureAt& pressure,
                                     SlipsTo slips, const SearchOptions& options) {
  const std::optional<GroundLoads> loads = loads_of(ground, moment, pressure);
  if (!loads) return std::nullopt;
  const std::optional<CircleSearch> search = search_one_way(ground, *loads, moment, slips, options);
  return search && !search->family.empty() ? std::optional(search->family[0]) : std::nullopt;
}

bool is_like(const FamilyCircle& a, const FamilyCircle& b, double width) {
  const double near = 0.01 * width;
  return a.landward == b.landward && std::abs(a.from - b.from) < near && std::abs(a.to - b.to) < near &&
         std::abs(a.y - a.radius - b.y + b.radius) < near;
}

/// Adds the least circle of a moment, unless the family has one like it.
void add_circle(Making& making, const BaseMoment& moment, const PressureAt& pressure, SlipsTo slips) {
  const auto found = least_one(making.ground, moment, pressure, slips, of_family);
  if (!found) return;
  GroundLoads weights;
  weights.surcharge = making.ground.surcharge;
  const auto circle = family_circle(making.ground.section, weights, found->circle, slips, found->safety.from,
                                    found->safety.to, slices_of_family);
  if (!circle) return;
  for (const FamilyCircle& other : making.family.circles)
    if (is_like(*circle, other, making.width())) return;
  making.family.circles.push_back(*circle);
}

/// The scale at which the resultant at that time is `eccentricity` from the middle; none up to the largest.
std::optional<double> scale_for(const OwnWave& own, std::size_t i, double eccentricity) {
  const double gains = own.moment[i] - eccentricity * own.force[i];
  const double scale = (eccentricity * own.rest.force - own.rest.moment) / gains;
  return std::isfinite(scale) && scale >= 0. && scale <= largest_scale ? std::optional(scale) : std::nullopt;
}

std::size_t time_of_largest(const std::vector<double>& values, double side) {
  std::size_t best = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (side * values[i] > side * values[best]) best = i;
  return best;
}

/// Effective widths over that of the base.
std::vector<double> levels() {
  std::vector<double> widths;
  for (double width = 1.; width > width_step; width -= width_step) widths.push_back(width);
  for (const double last : {0.4, 0.1}) widths.push_back(last * width_step);
  return widths;
}

/// The circles one way: under the wave at its largest moment and at its largest F_T that way.
void add_circles(Making& making, SlipsTo slips) {
  const double side = slips == SlipsTo::right ? 1. : -1.;
  const OwnWave& own = making.own;
  add_circle(making, own.rest, {}, slips);
  const std::size_t most_moment = time_of_largest(own.moment, side), most_shear = time_of_largest(own.shear, side);
  const std::vector<double> widths = levels();
  const std::size_t every = slips == SlipsTo::right ? 1 : 2;  // troughs demand less
  for (std::size_t level = 0; level < widths.size(); level += every)
    for (const std::size_t i : {most_moment, most_shear}) {
      if (i == most_shear && (level % (3 * every) != 0 || most_shear == most_moment)) continue;
      const auto scale = scale_for(own, i, side * 0.5 * (1. - widths[level]) * making.width());
      if (!scale) continue;
      const BaseMoment moment = own.at(i, *scale);
      add_circle(making, moment, i == most_moment ? scaled_pressure(making.map, moment, *scale) : PressureAt(), slips);
    }
}

/// The readings of a family by the coordinates of the pressures' basis.
Eigen::MatrixXd readings_by_coordinates(const CircleFamily& family, const Simulation& simulation,
                                        const FieldBasis& basis) {
  const GroundSection section = ground_section(simulation);
  std::vector<std::array<double, 2>> points;
  std::vector<std::vector<SliceReading>> slices;
  const double below = 1e-6 * (family.right - family.left);  // points on the surface are inside the ground
  for (const FamilyCircle& circle : family.circles) {
    slices.push_back(readings_of(section, circle));
    for (const SliceReading& s : slices.back()) {
      points.push_back({s.surface[0], s.surface[1] - below});
      points.push_back(s.base);
    }
  }
  const Eigen::MatrixXd at = pressure_readings(simulation, basis, points);
  Eigen::MatrixXd rows(family.n_readings(), at.cols());
  Eigen::Index row = 0, point = 0;
  for (const auto& circle : slices) {
    const Eigen::Index moment = row + static_cast<Eigen::Index>(circle.size());
    rows.row(moment).setZero();
    for (const SliceReading& s : circle) {
      rows.row(row++) = at.row(point) - at.row(point + 1);
      rows.row(moment) += s.moment_per_pressure * at.row(point);
      point += 2;
    }
    ++row;
  }
  return rows;
}

/// The largest share by which the family's least factor exceeds that of a full search.
double gap_of(const Making& making, const ModalModel& pressures, const SampledLoads& loads) {
  const OwnWave& own = making.own;
  double gap = 0.;
  for (const double scale : {0.35, 0.6, 0.85, 1., 1.3}) {
    std::vector<double> force, moment, shear;
    for (std::size_t i = 0; i < own.time.size(); ++i) {
      const BaseMoment at = own.at(i, scale);
      force.push_back(at.force);
      moment.push_back(at.moment);
      shear.push_back(at.shear);
    }
    const auto readings = [&](const std::vector<std::size_t>& times) -> Eigen::MatrixXd {
      return scale * respond_at(pressures, loads, times);
    };
    const auto found = circle_of_wave(making.family, force, moment, shear, readings);
    if (!found || found->factor == 0.) continue;
    const BaseMoment then = own.at(found->moment, scale);
    const PressureAt pressure = found->computed ? scaled_pressure(making.map, then, scale) : PressureAt();
    const SlipsTo slips = making.family.circles[found->circle].landward ? SlipsTo::right : SlipsTo::left;
    if (const auto full = least_one(making.ground, then, pressure, slips, {}))
      gap = std::max(gap, found->factor / full->safety.factor - 1.);
  }
  return gap;
}

}  // namespace

ModalModel circle_readings(const CircleFamily& family, const Simulation& simulation, const PressureModel& pressures) {
  const Eigen::MatrixXd rows = readings_by_coordinates(family, simulation, pressures.basis);
  ModalModel model = pressures.model;
  model.reading = rows * pressures.model.reading;
  model.feedthrough = rows * pressures.model.feedthrough;
  model.impulse = rows * pressures.model.impulse;
  model.reading_label.assign(static_cast<std::size_t>(rows.rows()), {});
  return model;
}

CircleModelMade circle_model(const Simulation& simulation, const Reduction& reduction) {
  CircleModelMade made;
  const Stopwatch watch;
  made.why_not = why_no_circles_in(simulation);
  if (!made.why_not.empty()) return made;
  std::optional<OwnWave> own = own_wave(simulation, reduction);
  if (!own) {
    made.why_not = "the caisson's weight in water is not known";
    return made;
  }
  const PressureModel& pressures = *reduction.pressures;
  Making making(simulation, pressures, std::move(*own));
  for (const SlipsTo slips : {SlipsTo::right, SlipsTo::left}) add_circles(making, slips);
  if (making.family.circles.empty()) {
    made.why_not = "no circle under the base has a factor";
    return made;
  }
  made.model = CircleModel{making.family, circle_readings(making.family, simulation, pressures), 0.};
  made.model->gap = gap_of(making, made.model->pressures,
                           sampled_loads(simulation.scene(), simulation.system(), simulation.scene().output_times));
  made.seconds = watch.seconds();
  return made;
}

}  // namespace upbead
