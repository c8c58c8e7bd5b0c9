// Water of one depth in front of a rigid upright wall, as in tests/reference/ref6_water.json: the ground of the wall
// is left out, and the wall can move only along x.
#pragma once

#include <complex>
#include <memory>
#include <string>
#include <vector>

#include "record.h"
#include "reference.h"
#include "scenes.h"

namespace upbead::test {

struct ReservoirShape {
  double depth = 15., length = 45.;                   ///< m
  int cells = 8;                                      ///< over the depth; squares along the reservoir
  PressureCondition far = PressureCondition::sealed;  ///< sealed, open or absorbing
  PressureCondition level = PressureCondition::open;  ///< open or surface_waves
  int degree = 2;                                     ///< of phi
};

/// The pressure p = phi' on the wall reads "force" (N/m, landward), "moment" (N m/m, about the wall's foot) and, at
/// heights that were asked for, "probes/y0/pressure", ...
class Reservoir {
 public:
  Reservoir(const ReservoirShape& shape, const Fluid& fluid, const std::vector<double>& heights = {});

  /// The water alone. Its load is the velocity (m/s) of the wall towards the water.
  System water(const TimeFunction& velocity) const;
  /// The water and the wall, which has a mass (kg/m), on a dashpot (Pa s) and a spring (Pa), under a landward force
  /// (N/m). Also reads "displacement" (m, landward) and "support", k x + c_d x' (N/m).
  System with_wall(double mass, double dashpot, double spring, const TimeFunction& force) const;

 private:
  System with_readings() const;

  std::unique_ptr<Mesh> mesh_;
  std::unique_ptr<Compiled> compiled_;
  double wall_centre_ = 0.;
};

/// The water of a table's entry: rho, and c unless it is incompressible.
Fluid incompressible_water(const Json& entry);
Fluid compressible_water(const Json& entry);

/// The reading per unit of the wall's acceleration at a frequency (rad/s; 0: slow motion), complex.
std::complex<double> per_acceleration(const System& water, double omega, const std::string& reading);

/// Force on the wall over rho a h^2, by modes: `length` infinite where it is not positive.
std::complex<double> modal_force(double depth, double length, double speed_of_sound, double omega,
                                 PressureCondition far);

}  // namespace upbead::test
