// A load by regular waves that run along a curve, or stand on it: p = a cos(k x - omega t) at the bed.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "input/schema.h"
#include "upbead/model/load.h"

namespace upbead {

enum class TrainCourse { landward, seaward, stands };

/// The table [loads.NAME.train] as written.
struct WaveTrain {
  std::optional<double> amplitude;  ///< a (Pa); or height and depth
  std::optional<double> height;     ///< H (m)
  std::optional<double> depth;      ///< h (m)
  double period = 0.;               ///< T (s)
  std::optional<double> length;     ///< L (m); none: computed from T and h
  TrainCourse course = TrainCourse::landward;
  double crest = 0.;             ///< x of a crest at t = 0, or of an antinode (m)
  std::optional<double> growth;  ///< time in which it grows from rest (s); none: T
};

TableSchema<WaveTrain> wave_train_schema();

/// What is missing, or contradicts another key, at keys relative to the table.
Diagnostics diagnose(const WaveTrain& train);

/// Makes NAME.cosine and, of waves that run, NAME.sine, pressures whose sum is the wave, with what they have in common
/// from `load`:
/// a cos(k x -/+ omega t) = a (cos kx cos omega t +/- sin kx sin omega t). Linear theory: a = rho g H/(2 cosh kh),
/// omega^2 = g k tanh kh (Goda 2000, eq. 2.1 f.); it grows as sin^2 within `growth`.
std::map<std::string, Load> train_loads(const std::string& name, const Load& load, const WaveTrain& train,
                                        double density, double gravity);

}  // namespace upbead
