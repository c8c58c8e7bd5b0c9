// The ground under a caisson in which slip circles are sought, what presses on it at a moment, and the least circle.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "findings/ground_section.h"
#include "findings/pressure_map.h"
#include "rupture/circle_search.h"
#include "rupture/slip_block.h"
#include "upbead/sliding/base_pressure.h"

namespace upbead {

using PressureAt = std::function<double(double x, double y)>;  ///< excess pore pressure (Pa); empty: none

/// A moment, and what the base presses on the ground with.
struct BaseMoment {
  std::optional<double> time;                  ///< s; none: at rest
  double force = 0., shear = 0., moment = 0.;  ///< N', F_T (N/m), M' (N m/m)
};

/// The base of the caisson, and the ground in which circles are sought: four widths to each side.
struct CircleGround {
  explicit CircleGround(const Simulation& simulation);

  GroundSection section;
  double left = 0., right = 0., level = 0.;  ///< of the base (m)
  double from = 0., to = 0.;                 ///< ends of the ground where circles may meet its surface (m)
  std::function<double(double)> surcharge;   ///< Pa at x
};

/// The weights of [initial.surcharge] on the ground over x, each between its ends (Pa); empty where there are none.
std::function<double(double)> surcharge_of(const Simulation& simulation);

/// Points a 40th of the base's width apart.
PointGrid grid_of(const CircleGround& ground);

/// All of the ground that leaves the whole strip on the part that slips.
CircleRange range_beside(const CircleGround& ground, const StripLoad& strip);

/// Circles that slip one way under the loads of a moment, loads_of(); none where may_slip() says that they cannot.
std::optional<CircleSearch> search_one_way(const CircleGround& ground, const GroundLoads& loads,
                                           const BaseMoment& moment, SlipsTo slips, const SearchOptions& options);

/// Why circles cannot be sought in a scene; "" where they can, as far as the base is known.
std::string why_no_circles_in(const Simulation& simulation);

/// The moments of largest F_T both ways, |M'/N'| and F_T/N', and of least N', each once, while the resultant stands on
/// the base. `shear`: F_T at these times.
std::vector<BaseMoment> moments_to_look_at(const EffectiveBase& base, const std::vector<double>& shear,
                                           const std::vector<double>& time);

/// What presses on the ground at a moment; none where the resultant leaves the base.
std::optional<GroundLoads> loads_of(const CircleGround& ground, const BaseMoment& moment, const PressureAt& pressure);

struct LookedFor {
  std::optional<SlipCircleFound> least;
  int tried = 0, steep = 0;  ///< circles
};

/// The least circle of one moment. It slips to where the base is pushed or its resultant stands, and both ways where
/// these differ or neither is known.
LookedFor least_circle(const CircleGround& ground, const BaseMoment& moment, const PressureAt& pressure,
                       const SearchOptions& options = {});

/// The least circle of all moments: a rough search leaves out those that are a quarter safer than the worst.
LookedFor least_of_moments(const CircleGround& ground, const std::vector<BaseMoment>& moments,
                           const std::function<PressureAt(double time)>& pressure_at);

/// The least block of a moment on planes down to two widths below the base, that slips where the circle does.
std::optional<FoundBlock> least_block(const CircleGround& ground, const SlipCircleFound& circle,
                                      const PressureAt& pressure);

/// The circle by itself at a moment: its safety, and what drives it.
FigureSafety safety_at(const CircleGround& ground, const SlipCircleFound& circle, const BaseMoment& moment,
                       const PressureAt& pressure, int n_slices = 400);

/// The same of the circle whose ends move outward as far as the loaded width of that moment needs, through the same
/// middle of its arc.
FigureSafety widened_safety_at(const CircleGround& ground, SlipCircleFound circle, const BaseMoment& moment,
                               const PressureAt& pressure);

/// Its slices at the moment that it was found for.
SlipCircleSlices slices_at(const CircleGround& ground, const SlipCircleFound& circle, const PressureAt& pressure,
                           int n_slices);

}  // namespace upbead
