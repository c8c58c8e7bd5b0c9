// Reduces a System to modes, and measures how wrong they are.
#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "upbead/dynamics/krylov.h"
#include "upbead/dynamics/modal_model.h"
#include "upbead/dynamics/modal_response.h"
#include "upbead/dynamics/reduced_system.h"
#include "upbead/dynamics/state_model.h"
#include "upbead/system/system.h"

namespace upbead {

struct ReduceOptions {
  double shift = 0.;          ///< s_0 of the Krylov space (1/s); see reduce_scene
  std::vector<int> exact;     ///< unknowns that are coordinates themselves
  std::vector<Vector> kept;   ///< directions of displacements that are kept, see SecondOrderKrylov
  bool each_load = true;      ///< measure the error under each load alone, too
  SampledLoads training;      ///< histories under which the error is measured
  std::vector<int> measured;  ///< readings that must meet `tolerance`; the others `tolerance_of_others`
  double tolerance = 1e-3;    ///< of a reading's history, over its largest value
  double tolerance_of_others = 5e-2;
  double tolerance_of_states = 5e-2;  ///< where they are kept: of their largest energy
  int first_vectors = 24;             ///< per independent load, at the first comparison
  int max_vectors = 100;              ///< per independent load
  bool keep_pressures = false;        ///< see Reduction::pressures; not where `model` is given
  /// See Reduction::states, which must meet `tolerance_of_states`; not where `model` is given.
  bool keep_states = false;
  /// Makes the models that are compared, where these are not of modal_model(); their loads are those of the training
  /// histories.
  std::function<ModalModel(const ReducedSystem&)> model;
  /// Called after every solve with an estimate of the part done, 0 to 1; may be empty.
  std::function<void(double)> progress;
};

/// Keeps what reductions of one System have in common: src/dynamics/basis.h.
class BasisRoom;

/// How far two nested models lie apart.
struct NestedError {
  double history = 0.;         ///< of the measured readings, see of_reading
  double peak = 0.;            ///< of their largest and least values
  double others = 0.;          ///< of all other readings, see of_reading
  double states = 0.;          ///< see energy_distance(); only where all readings meet their tolerance
  Eigen::VectorXd of_reading;  ///< largest difference over time, over the reading's largest value, by reading
};

/// The pressures of a reduced scene everywhere, not only at the points that were asked for.
struct PressureModel {
  FieldBasis basis;  ///< of phi
  ModalModel model;  ///< readings: the velocity of each coordinate of the basis, without its units
};

/// A model, and what is known of its error.
struct Reduction {
  ModalModel model;
  ReducedSystem system;  ///< that the model is made of
  /// For the error of the measured readings, and of the others.
  double tolerance = 0., tolerance_of_others = 0.;
  std::vector<int> measured;
  NestedError error;  ///< difference from the last smaller model: about that one's error, above this one's
  /// The frequency (rad/s) up to which H(1/T + i omega) of all measured readings changed by less than 4 times
  /// `tolerance` of its largest value; T is the end of the training histories. A history of length T cannot resolve
  /// resonances narrower than 1/T.
  double omega = 0.;
  bool converged = false;  ///< also where the space is exhausted: then the model is exact
  int n_vectors = 0, n_solves = 0, n_independent_loads = 0;
  int n_spared = 0;  ///< of these solves, those that an earlier reduction had done
  double factorise_seconds = 0.;
  std::optional<PressureModel> pressures;            ///< where they are kept
  std::optional<StateModel> states;                  ///< where they are kept
  std::vector<std::pair<int, NestedError>> history;  ///< by number of vectors, as the space grew
};

/// Grows a Krylov space until two nested models agree on the training histories: under all loads together and, where
/// asked for, under each alone. Stops unconverged where the next comparison would need more than max_vectors. Transfer
/// functions at other real shifts are no substitute: there the models agree long before their histories do. Throws
/// NumericsError as SecondOrderKrylov and modal_model do. `room`, of this System alone: a basis that is kept there is
/// taken from there, and left there; the result is the same to the last bit.
Reduction reduce(const System& system, const ReduceOptions& options, BasisRoom* room = nullptr);

/// The velocities of all unknowns of phi, from a series of the model: a row per basis.unknown, a column per time.
Eigen::MatrixXd phi_velocities(const FieldBasis& basis, const Eigen::MatrixXd& coordinates);

/// The frequency (rad/s), at most `largest`, up to which H(decay + i omega) of both models agrees, see
/// Reduction::omega.
double agreed_frequency(const ModalModel& coarse, const ModalModel& fine, const std::vector<int>& readings,
                        double tolerance, double decay, double largest);

}  // namespace upbead
