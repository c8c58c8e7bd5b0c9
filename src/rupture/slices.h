// Slices of ground that slips, without shear between them: Bishop (1955) for circles, Janbu (1954) for other lines.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "rupture/ground_loads.h"
#include "rupture/section.h"

namespace upbead {

constexpr double least_m_alpha = 0.2;  ///< below which a slice's m_alpha is too small for the method

/// Why a figure has no factor of safety.
enum class NoFactor {
  none,
  nothing_drives,  ///< the loads do not move it that way
  outside,         ///< it leaves the section, or the surface is below it
  uncut,           ///< it would cut what may not fail, or splits the strip
  steep,  ///< m_alpha of a slice is below 0.2, where the method fails: Whitman and Bailey (1967), Use of computers for
          ///< slope stability analysis, J. Soil Mech. Found. Div. ASCE 93(SM4)
};

struct FigureSafety {
  double factor = std::numeric_limits<double>::infinity();  ///< F
  NoFactor why = NoFactor::none;
  double driving = 0.;        ///< force along the figure; of a circle the moment over its radius (N/m)
  double least_m = 1.;        ///< least m_alpha
  double from = 0., to = 0.;  ///< x of its ends on the surface (m)
};

/// The line below the ground that slips, at one x: height, and slope, positive where it descends the way it slips.
struct BasePoint {
  double y = 0.;                  ///< m
  double sine = 0., cosine = 1.;  ///< of the slope's angle alpha
};

/// A slice; forces per length along x, those of its middle.
struct Slice {
  double x = 0., width = 0.;  ///< m
  BasePoint base;
  double cohesion = 0., friction = 0.;  ///< c' (Pa), tan phi'
  double normal = 0.;                   ///< w + q - u: what the base would bear without shear (Pa)
  double vertical = 0.;                 ///< w + q, downwards (Pa)
  double horizontal = 0.;               ///< to larger x (Pa)
  double horizontal_moment = 0.;        ///< of that about y = 0: force times height (N/m)
};

struct Slices {
  std::vector<Slice> list;
  NoFactor why = NoFactor::none;
};

/// About n slices of the ground between x = from and x = to above the line; none is partly under the strip, or across
/// one of the `kinks` of the line. `line`: none where it is not defined. The horizontal force of the strip is not in
/// them.
Slices slices_of(const GroundSection& section, const GroundLoads& loads,
                 const std::function<std::optional<BasePoint>(double x)>& line, double from, double to, int n,
                 const std::vector<double>& kinks = {});

/// F = sum [(c' + (w + q - u) tan phi') b weight/m_alpha]/driving, m_alpha = cos alpha (1 + tan alpha tan phi'/F),
/// where the driving force (N/m) is positive; `weight` of each slice: 1 for circles, 1/cos alpha for forces along x. A
/// base that would pull bears nothing.
FigureSafety safety_of(const Slices& slices, double driving, const std::function<double(const Slice&)>& weight);

}  // namespace upbead
