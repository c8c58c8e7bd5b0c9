// Units as laboratories write them.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace upbead {

/// A unit, described by the SI unit of the same quantity: 1 of this unit = `factor` SI units.
struct Unit {
  std::string si;  ///< "s", "m", "m/s", "m/s2", "rad", "Pa", "N/m", "N m/m", "Hz" or "1"
  double factor = 1.;
};

/// kPa, kN/m2, kN/m^2, kN/m², mm, ms, Gal, tf/m, ... ; blanks, ^ and * do not matter. None for an unknown unit.
/// Weights (kgf, tf, g, mH2O) with standard gravity, 9.80665 m/s2 (CGPM 1901), and water of 1000 kg/m3.
std::optional<Unit> unit_of(const std::string& text);

/// Known units of the quantity with that SI unit, for messages: "Pa, kPa, MPa, bar, ...".
std::string units_like(const std::string& si);

}  // namespace upbead
