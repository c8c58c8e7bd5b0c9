// A System with an interface on few coordinates: the motions of its nodes as they are, and of all else the directions
// in which it answers these and the loads.
#pragma once

#include <memory>
#include <vector>

#include "algebra/factorisation.h"
#include "dynamics/projection.h"
#include "upbead/dynamics/krylov.h"
#include "upbead/dynamics/march.h"

namespace upbead {

/// What the system answers about a real shift s to several starts at once: T(s)^-1 b of loads, or what follows a motion
/// of the interface. T(s_0) r_j = -s_0 (2 s_0 M + C) r_{j-1} - s_0^2 M r_{j-2}, see SecondOrderKrylov.
class MomentTrain {
 public:
  MomentTrain(const System& system, double shift);
  ~MomentTrain();
  MomentTrain(MomentTrain&&) noexcept;

  /// r_0 of motions of the prescribed unknowns, a column each.
  Eigen::MatrixXd follow(const Eigen::MatrixXd& motions);
  /// r_0 of right-hand sides, a column each.
  Eigen::MatrixXd answer(const Eigen::MatrixXd& loads);
  /// The next moments of all columns; `before` is empty after r_0.
  Eigen::MatrixXd next(const Eigen::MatrixXd& now, const Eigen::MatrixXd& before);
  int n_solves() const { return n_solves_; }

 private:
  Eigen::MatrixXd solved(const Eigen::MatrixXd& rhs);

  int n_free_;
  SparseMatrix T_, with_now_, with_before_;
  Factorisation factors_;
  int n_solves_ = 0;
};

/// A system of few coordinates, with its interface; x, x' and x'' of its coordinates are its readings.
struct InterfaceModel {
  System system;
  Eigen::MatrixXd position, velocity, acceleration, feedthrough;  ///< of the readings of the whole system
  FieldBasis displacements, phi;                                  ///< numbered as the coordinates of `system`

  /// The response of the whole system's readings.
  Response read(Response response) const;
  /// The whole state; `only_phi`: all else stays 0.
  State whole(const State& state, bool only_phi) const;
};

/// Component mode synthesis [Craig and Bampton 1968] of a System whose interface is all that is not linear. u with W
/// and phi have directions of their own, so that the signs of M, C and K are kept; coordinates of rigid bodies are kept
/// as they are, so that forces on them balance to round-off. A motion of a node of the interface carries with it what
/// the ground does in its neighbourhood: the answer at four times the shift to its part of high degree along the
/// interface. Motions of low degree, and the loads, have as many moments as the level says, about two shifts; of these
/// the directions that count, by proper orthogonal decomposition, belong to the coordinates. Levels are nested.
class InterfaceSpace {
 public:
  /// `shift`: as of a Krylov space of the loads; `exact`, `kept`: see SecondOrderKrylov. The system must outlive it.
  InterfaceSpace(const System& system, double shift, const std::vector<int>& exact, const std::vector<Vector>& kept);
  ~InterfaceSpace();

  static constexpr int n_levels = 3;
  /// The model of the present level, at first the lowest.
  InterfaceModel model() const;
  /// Goes to the next level.
  void extend();
  int n_solves() const;

 private:
  struct Series {
    MomentTrain* train;
    const int* orders;  ///< moments at each level
    Eigen::MatrixXd now, before;
    int order = 1;  ///< moments that are made
  };

  void start_motions();
  void start_loads();
  void carry(const Eigen::MatrixXd& local);
  void begin(MomentTrain& train, const int* orders, Eigen::MatrixXd first);
  void take_level();
  void add(FieldBasis& basis, const std::vector<Eigen::MatrixXd>& columns);

  const System& system_;
  double shift_;
  std::vector<bool> own_;  ///< unknowns that are coordinates themselves
  FieldBases bases_;
  Eigen::Index n_own_[2];
  MomentTrain slow_, fast_;
  std::vector<Series> series_;
  std::unique_ptr<Projection> projection_, radiating_;
  System radiation_;
  int level_ = -1;
};

}  // namespace upbead
