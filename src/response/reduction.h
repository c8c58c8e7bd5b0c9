// The reduced model of a compiled scene.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fem/compile.h"
#include "upbead/dynamics/reduce.h"
#include "upbead/response/findings.h"

namespace upbead {

/// Times at which a reduced model responds to a scene: steps of at most a 32nd of the loads' shortest duration, or
/// the case's own steps where straight lines between them reproduce the loads; they include all kinks, and the
/// samples of measured records. Throws NumericsError where loads that the case's steps do not see need more than 10^6
/// times.
std::vector<double> response_times(const Scene& scene, const System& system);

/// The scene's own loads at those times, and at other times that are asked for.
SampledLoads sampled_loads(const Scene& scene, const System& system, const std::vector<double>& others = {});

/// The indices of enough times of a series to find the extremes of quantities that move with the loads: about 16 in
/// the shortest `duration` (s).
std::vector<Eigen::Index> looks_at(const std::vector<double>& time, double duration);

/// The purpose of a model.
struct ReductionTargets {
  bool only_shear = false;          ///< F_T, and `states` where they are asked for; not all readings
  bool each_load = false;           ///< any history of each load, not only the scene's loads together
  std::optional<int> most_vectors;  ///< per independent load, in place of the default
  bool pressures = false;           ///< known everywhere, not only at probes: Reduction::pressures
  bool states = false;              ///< all unknowns known everywhere: Reduction::states
  /// The forces on an elastic caisson balance to round-off, not only to the model's error: its rigid motions are
  /// kept, which takes half as many vectors again.
  bool balanced = false;
  /// Readings besides F_T must meet 10 or 20 times this tolerance; that of the scene where none is given.
  std::optional<double> tolerance_of_others = std::nullopt;
  /// Vectors per independent load at the first comparison, in place of the default: more where a solve costs less than
  /// the eigenvalues of a comparison.
  std::optional<int> first_vectors = std::nullopt;
};

/// The shift of a scene's Krylov space (1/s): 1.25 times 2 pi over the shortest duration of its loads, 1.75 times where
/// a soil has no material damping. Measured in docs/reduced.md.
double krylov_shift(const Scene& scene);

/// The options with which reduce_scene() reduces a scene.
ReduceOptions reduce_options(const Scene& scene, const CompiledScene& compiled, const ReductionTargets& targets);

/// Reduces a scene for all its loads, at krylov_shift. The history of F_T must meet the scene's tolerance; all other
/// readings, unless only F_T is wanted, 10 times the tolerance, or 20 times where a soil is not damped. Without a
/// caisson all readings must meet the tolerance. The tolerance holds for the smaller of two nested models; the larger
/// one, which is kept, is better where the space converges quickly, and about as good where it does not. `progress`:
/// called with 0 to 1 after every solve. `room`: see reduce(). Throws NumericsError.
Reduction reduce_scene(const Scene& scene, const CompiledScene& compiled, const ReductionTargets& targets,
                       const std::function<void(double)>& progress = {}, BasisRoom* room = nullptr);

/// Name of the reading with the largest error; "" where there is none.
std::string worst_reading(const Reduction& reduction);

/// "; least certain of all else is NAME, by 4.4 % of its largest value, less than its tolerance of 5 %"; "" where all
/// is exact.
std::string told_of_others(const Reduction& reduction);

/// Throws NumericsError, with the error reached, where the nested models differ too much.
void require_converged(const Reduction& reduction);

/// The same for F_T alone; other readings may still differ too much.
void require_shear_converged(const Reduction& reduction);

/// The readings besides F_T that have not converged, in the order of the readings; none for a model that has
/// converged.
std::vector<InexactReading> inexact_readings(const Reduction& reduction);

/// Largest difference of F_T between the model and a march with the same steps, over its peak: the true error of the
/// model under the scene's own loads. Takes as long as a march with steps of a 32nd of the duration.
double error_against_march(const Reduction& reduction, const Scene& scene, const CompiledScene& compiled);

/// The model's response to the scene's own loads, in the form of a march's response, but without an account of
/// energy.
Response respond(const Reduction& reduction, const Scene& scene, const System& system);

}  // namespace upbead
