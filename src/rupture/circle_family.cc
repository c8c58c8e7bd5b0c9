#include "upbead/rupture/circle_family.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "rupture/ground_loads.h"
#include "rupture/slip_circle.h"

namespace upbead {

namespace {

/// Whether the resultant stands on the base.
bool resultant_stands(double force, double moment, double width) {
  return force > 0. && std::abs(moment) < 0.499 * width * force;
}

/// The share of a slice that is under the strip.
double share_under(const StripLoad& strip, const FamilySlice& s) {
  const double from = std::max(strip.from, s.x - 0.5 * s.width), to = std::min(strip.to, s.x + 0.5 * s.width);
  return std::max(0., to - from) / s.width;
}

std::optional<double> factor_under(const FamilyCircle& circle, const StripLoad& strip, double force,
                                   const double* readings) {
  const double trifle = 1e-9 * (strip.to - strip.from);
  if (circle.from > strip.from + trifle || circle.to < strip.to - trifle) return std::nullopt;
  const double side = circle.landward ? 1. : -1.;
  double moment = circle.weight_moment + side * (force * (circle.x - 0.5 * (strip.from + strip.to)) +
                                                 strip.horizontal * (circle.y - strip.level));
  if (readings) moment += readings[circle.slices.size()];
  Slices slices;
  slices.list.resize(circle.slices.size());
  for (std::size_t i = 0; i < circle.slices.size(); ++i) {
    const FamilySlice& s = circle.slices[i];
    Slice& slice = slices.list[i];
    slice.width = s.width;
    slice.base = {0., s.sine, s.cosine};
    slice.cohesion = s.cohesion;
    slice.friction = s.friction;
    slice.normal = s.weight + strip.at_from * share_under(strip, s) + (readings ? readings[i] : 0.);
  }
  const FigureSafety found = safety_of(slices, moment / circle.radius, [](const Slice&) { return 1.; });
  return found.why == NoFactor::none ? std::optional(found.factor) : std::nullopt;
}

}  // namespace

std::size_t CircleFamily::n_readings() const {
  std::size_t n = 0;
  for (const FamilyCircle& circle : circles) n += circle.n_readings();
  return n;
}

std::optional<double> factor_of(const CircleFamily& family, std::size_t circle, const BaseLoad& load,
                                const double* readings) {
  const auto strip = effective_strip(load.force, load.moment, load.shear, family.left, family.right, family.level);
  return strip ? factor_under(family.circles[circle], *strip, load.force, readings) : std::nullopt;
}

std::optional<FamilyFactor> least_factor(const CircleFamily& family, const BaseLoad& load, const double* readings) {
  if (!resultant_stands(load.force, load.moment, family.right - family.left)) return FamilyFactor{0., 0};
  const auto strip = effective_strip(load.force, load.moment, load.shear, family.left, family.right, family.level);
  if (!strip) return FamilyFactor{0., 0};
  std::optional<FamilyFactor> least;
  for (std::size_t i = 0; i < family.circles.size(); ++i) {
    const FamilyCircle& circle = family.circles[i];
    const bool goes = may_slip(load.shear, load.moment, circle.landward ? SlipsTo::right : SlipsTo::left);
    const auto factor = goes ? factor_under(circle, *strip, load.force, readings) : std::nullopt;
    if (factor && (!least || *factor < least->factor)) least = FamilyFactor{*factor, i};
    if (readings) readings += circle.n_readings();
  }
  return least;
}

std::vector<std::size_t> moments_that_may_govern(const std::vector<double>& force, const std::vector<double>& moment,
                                                 const std::vector<double>& shear, double width) {
  const std::vector<std::function<double(std::size_t)>> measures{
      [&](std::size_t i) { return shear[i]; },
      [&](std::size_t i) { return -shear[i]; },
      [&](std::size_t i) { return std::abs(moment[i]) / force[i]; },
      [&](std::size_t i) { return std::abs(shear[i]) / force[i]; },
      [&](std::size_t i) { return -force[i]; },
  };
  std::set<std::size_t> rows;
  for (const auto& measure : measures) {
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < force.size(); ++i)
      if (resultant_stands(force[i], moment[i], width) && (!best || measure(i) > measure(*best))) best = i;
    if (best) rows.insert(*best);
  }
  return {rows.begin(), rows.end()};
}

std::optional<CircleOfWave> circle_of_wave(
    const CircleFamily& family, const std::vector<double>& force, const std::vector<double>& moment,
    const std::vector<double>& shear,
    const std::function<Eigen::MatrixXd(const std::vector<std::size_t>& moments)>& readings) {
  const double width = family.right - family.left;
  if (const auto leaves = first_without_stand(force, moment, width)) return CircleOfWave{0., *leaves, 0, false};
  std::vector<std::size_t> moments = moments_that_may_govern(force, moment, shear, width);
  if (moments.empty() || moments.front() != 0) moments.insert(moments.begin(), 0);
  const Eigen::MatrixXd computed = readings(moments);
  std::optional<CircleOfWave> least;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    const std::size_t t = moments[i];
    const BaseLoad load{force[t], shear[t], moment[t]};
    for (const bool by_computed : {false, true}) {
      const double* pressures = by_computed ? computed.col(static_cast<Eigen::Index>(i)).data() : nullptr;
      const auto found = least_factor(family, load, pressures);
      if (found && (!least || found->factor < least->factor))
        least = CircleOfWave{found->factor, t, found->circle, by_computed};
    }
  }
  return least;
}

std::optional<std::size_t> first_without_stand(const std::vector<double>& force, const std::vector<double>& moment,
                                               double width) {
  for (std::size_t i = 0; i < force.size(); ++i)
    if (!resultant_stands(force[i], moment[i], width)) return i;
  return std::nullopt;
}

}  // namespace upbead
