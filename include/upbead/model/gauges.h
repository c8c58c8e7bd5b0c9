// Pressures measured by transducers along a wall or a bottom.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "upbead/base/numbered_warning.h"
#include "upbead/model/load.h"

namespace upbead {

/// How the pressure continues beyond the first and the last transducer.
enum class Beyond {
  constant,  ///< the transducer's pressure, to the end of the wall
  none,      ///< no pressure
  to_zero,   ///< linearly to zero at a stated place
};

/// Pressures at places that ascend (heights y of a wall, x of a bottom), linear between them and in time.
struct Gauges {
  std::vector<std::string> name;              ///< of each
  std::vector<double> place;                  ///< of each (m)
  bool over_x = false;                        ///< whether the places of a load are x, as along a bed
  std::vector<double> time;                   ///< s, ascending; t = 0 is the run's
  std::vector<std::vector<double>> pressure;  ///< of each over time (Pa)
  std::array<Beyond, 2> beyond{Beyond::constant, Beyond::constant};  ///< below the first, above the last
  std::array<double, 2> zero_at{0., 0.};                             ///< where the pressure is zero (m), for to_zero
  std::vector<double> load_cell;                                     ///< force over time (N/m); may be empty

  std::size_t count() const { return place.size(); }
};

/// The share of transducer i in the pressure at every place, as a Load::shape: 1 at its place, 0 at those of its
/// neighbours.
std::vector<std::array<double, 2>> share(const Gauges& gauges, std::size_t i);

/// Force and its moment about place 0 over time.
struct Resultant {
  std::vector<double> force;   ///< N/m
  std::vector<double> moment;  ///< N m/m
};

/// Integrals of the pressure from place `from` to `to` (m).
Resultant resultant(const Gauges& gauges, double from, double to);

/// Estimated errors of the force and of its arm, when the force is largest: the pressure is known at some places only.
/// Each is a third of the change that leaving out every other transducer makes (Richardson's rule for the trapezoids
/// between them). `force` is relative, `arm` is over the length of the row. 0 for fewer than three transducers. Where
/// the largest force is less than a tenth of the integral of |p|, pressures cancel: the error is over that tenth, when
/// the integral is largest, and there is no arm.
struct InterpolationError {
  double force = 0., arm = 0.;
  double time = 0.;  ///< of the largest force (s)
  bool has_resultant = true;
};
InterpolationError interpolation_error(const Gauges& gauges);

/// Warnings of each transducer's record (record.h), of several that are sampled too coarsely only the one with the
/// steepest rise; warnings of transducers that look exchanged; and
///   gauges_too_sparse   the interpolation error of the force exceeds 5 %
///   load_cell_differs   the largest force by the load cell and that of `total` differ by more than 10 %
/// `name`: of the load; `total`: force by the transducers over time (N/m); `end`: of the run (s), where it is known.
NumberedWarnings gauge_warnings(const std::string& name, const Gauges& gauges, const std::vector<double>& total,
                                const std::optional<double>& end = {});

}  // namespace upbead
