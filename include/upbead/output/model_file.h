// A reduced model in one HDF5 file.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "upbead/base/error.h"
#include "upbead/base/numbered_warning.h"
#include "upbead/base/still_water.h"
#include "upbead/dynamics/modal_model.h"
#include "upbead/dynamics/nested_models.h"
#include "upbead/dynamics/reduced_system.h"
#include "upbead/rupture/circle_family.h"

namespace upbead {

struct GroundModel;  // dynamics/ground_model.h

/// A load of the case that the model was made from.
struct ModelLoad {
  std::string name;
  std::string unit;      ///< of f_k: N/m or Pa
  double peak = 0.;      ///< largest |f_k| of the case
  double duration = 0.;  ///< shortest time in which it rises and falls in the case (s)
  /// Of one unit, on the caisson about its bottom's middle, overturning landward positive (unit of f_k times m); none
  /// in files of before it.
  std::optional<double> moment{};
};

/// The table [sliding] of the case.
struct ModelSliding {
  double friction = 0.;          ///< mu
  double submerged_weight = 0.;  ///< W' (N/m)
  double drag = 0.;              ///< F_D over velocity (N s/m2)
  std::string uplift = "none";  ///< in_phase, held (of P), computed (pore pressure), history (of the case's wave alone)
  double uplift_per_force = 0.;  ///< of in_phase and held: U over P
  double lag = 0.;               ///< by which U comes after P (s)
  double push = 0.;              ///< of still water at two levels, which F_T does not have (N/m); dW' is in W'
};

/// What stands on the base at rest, and how a prescribed uplift presses.
struct ModelBase {
  double width = 0.;                    ///< B (m)
  double weight = 0.;                   ///< W' (N/m)
  double weight_moment = 0.;            ///< W' e_0 about the middle, overturning landward positive (N m/m)
  double uplift_moment_per_force = 0.;  ///< of a prescribed uplift (m)
  double push = 0., push_moment = 0.;   ///< of still water at two levels (N/m, N m/m); W' and W' e_0 have their part
};

/// The scene with a caisson that slips on its ground as a whole.
struct ModelSlip {
  ReducedSystem system;     ///< of reduce_slip(): its last load is F_T, its last readings are s and s'
  double error = 0.;        ///< of its forces between nested models, over their largest values
  double glued_error = 0.;  ///< of F_T without slip: difference from the bonded model, over its peak
  int vectors = 0, solves = 0;
};

/// Everything that `respond` needs, and where it came from.
struct ReducedModelFile {
  std::string title;
  std::string case_text;  ///< the effective case (TOML), all defaults spelled out
  ModalModel modes;
  std::vector<ModelLoad> loads;   ///< as in modes.load_name
  double caisson_mass = 0.;       ///< with fill, W/g (kg/m); 0 where there is no caisson
  double end = 0.;                ///< [time] end of the case (s)
  double highest_frequency = 0.;  ///< up to which the transfer function has been checked (Hz)
  double tolerance = 0.;          ///< that was asked for, relative
  double error = 0.;              ///< measured, of the history of F_T over its peak (nested models)
  double error_peak = 0.;         ///< measured, of peak F_T
  /// Of F_T alone, with the loads of `modes`; none in files of before 1.1, and where they cannot be made.
  std::optional<NestedModels> nested;
  std::optional<double> error_march;    ///< of the history, against a march, where one was made
  std::optional<ModelSliding> sliding;  ///< none where the case has no such table
  std::optional<StillWater> still;      ///< of sea and harbour at two levels; none where they are at one
  std::optional<ModelBase> base;        ///< none where W' is not known, or the file is of an older version
  std::optional<ModelSlip> slip;        ///< none without `sliding`, or where it could not be computed
  /// Slip circles under the caisson; none where no region has a strength, and in files of before them.
  std::optional<CircleModel> circles;
  /// Slip and lift node by node; null where the case's caisson is bonded, and in files of before them.
  std::shared_ptr<const GroundModel> contact;
  int unknowns = 0, solves = 0, factorisations = 0;
  NumberedWarnings warnings;  ///< of its scene, whatever the wave, as a run tells them; none in files of before them
};

/// The bytes of the file. Throws NumericsError where a number is not finite.
std::string model_file(const ReducedModelFile& model);

/// Reads such a file. Throws InputError where it cannot be read, is not a reduced model, or is incomplete.
ReducedModelFile read_model_file(const std::string& path);

}  // namespace upbead
