// What numbers physical quantities have in practice, and the unit in which a number was probably meant that is outside.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "upbead/base/numbered_warning.h"

namespace upbead {

/// A unit, or another quantity, in which a number may have been given.
struct MeantUnit {
  const char* name;
  double factor;                     ///< the number in SI is factor times the one that was given; or
  double (*bent)(double) = nullptr;  ///< this
  double in_si(double value) const { return bent ? bent(value) : factor * value; }
};

/// Generous bounds: outside them a unit was mistaken, or the scene is no breakwater. And narrower, common bounds, by
/// which the unit is guessed: the first one in which the number is common.
struct Quantity {
  const char* unit;
  double low, high, common_low, common_high;
  std::vector<MeantUnit> meant;
  const char* usual = "";  ///< "sand has 1e7 to 3e8"
  bool tells_all = false;  ///< whether all units are told in which it is common
};

/// The cure of a number that was given in another unit; `meant`: in SI.
std::string cure_of_unit(const MeantUnit& unit, double meant);

/// Warning implausible: `value` of the key is outside the bounds; names the unit that is probably meant. A number that
/// is zero or infinite is none of a unit.
std::optional<NumberedWarning> implausible(const std::string& key, double value, const Quantity& quantity);

/// The quantity of which this one is a share. `meant`: units in place of its own.
Quantity of(Quantity share, double whole, const char* unit, const char* usual, std::vector<MeantUnit> meant = {});

/// Whether a load is a power of ten: one of unit size, whose response is a ratio.
bool is_unit_load(double value);

/// Adds that warning, where there is one.
void judge(const std::string& key, const std::optional<double>& value, const Quantity& quantity,
           NumberedWarnings& list);

/// The quantities, each with its source.
namespace quantities {
extern const Quantity modulus, soil_modulus, density, grain_density, water_density, water_modulus, grain_modulus,
    viscosity, atmosphere, stress_scale, conductivity, darcy_conductivity, permeability, porosity_of_soil,
    porosity_of_coarse, porosity, damping, reference_strain, threshold_strain, smallest_damping, largest_damping,
    tortuosity, friction, pressure_factor, shear_ratio, caisson_modulus, cyclic_resistance, rest_coefficient, slope,
    friction_angle, cohesion, surcharge, sliding_limit, settlement_limit, tilt_limit, safety_limit, strength_limit,
    ratio_limit, pressure_limit, load_duration, frequency, wave_height, wave_period, wave_angle, depth, bed_slope,
    storm_duration, level, stiffness, load_on_weight, gravity, velocity;
}  // namespace quantities

}  // namespace upbead
