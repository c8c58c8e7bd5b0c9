// A System with an interface on few coordinates: the motions of its nodes as they are, and of all else the directions
// in which it answers these and the loads.
#pragma once

#include <memory>
#include <vector>

#include "algebra/factorisation.h"
#include "dynamics/carried_motions.h"
#include "dynamics/ground_matrices.h"
#include "dynamics/projection.h"
#include "upbead/dynamics/krylov.h"
#include "upbead/dynamics/march.h"

namespace upbead {

/// What the system answers about a real shift s to several starts at once: T(s)^-1 b of loads, or what follows a motion
/// of the interface. T(s_0) r_j = -s_0 (2 s_0 M + C) r_{j-1} - s_0^2 M r_{j-2}, see SecondOrderKrylov.
/// The system must outlive it.
class MomentTrain {
 public:
  MomentTrain(const System& system, double shift);
  ~MomentTrain();

  /// r_0 of motions of the prescribed unknowns, a column each.
  Eigen::MatrixXd follow(const Eigen::MatrixXd& motions);
  /// r_0 of right-hand sides, a column each.
  Eigen::MatrixXd answer(const Eigen::MatrixXd& loads);
  /// The next moments of all columns; `mass_before`: M times those before `now`, empty after r_0; then of `now`.
  Eigen::MatrixXd next(const Eigen::MatrixXd& now, Eigen::MatrixXd& mass_before);
  int n_solves() const { return n_solves_; }
  const SparseMatrix& matrix() const { return T_; }

 private:
  Eigen::MatrixXd solved(const Eigen::MatrixXd& rhs);

  const System& system_;
  double shift_;
  int n_free_;
  SparseMatrix T_;
  Factorisation factors_;
  int n_solves_ = 0;
};

/// Keeps what a march of few coordinates goes through: x, x' and x'', a column a step.
class Motions : public MarchObserver {
 public:
  void see(const State& state, int step, int n_steps) override;
  Eigen::Map<const Eigen::MatrixXd> x() const { return columns(x_); }
  Eigen::Map<const Eigen::MatrixXd> v() const { return columns(v_); }
  Eigen::Map<const Eigen::MatrixXd> a() const { return columns(a_); }

 private:
  Eigen::Map<const Eigen::MatrixXd> columns(const std::vector<double>& values) const;

  Eigen::Index n_ = 0;
  std::vector<double> x_, v_, a_;
};

/// A system of few coordinates, with its interface; it has no matrices but those of `ground`, and no readings. Of use
/// as long as its space lives, also where that is extended.
struct InterfaceModel {
  System system;
  GroundMatrices ground;
  Eigen::MatrixXd position, velocity, acceleration, feedthrough;  ///< of the readings of the whole system
  const FieldBasis& displacements;  ///< of the space, whose first `n_displacements` directions are the model's
  Eigen::Index n_displacements;
  FieldBasis phi;
  const CarriedMotions& carried;
  Eigen::MatrixXd to_bases;  ///< coordinates of the bases from the free ones of the system

  /// The response of the whole system's readings, from a march that these motions are of.
  Response read(Response response, const Motions& motions) const;
  /// Of the coordinates of phi, a row for each column of its basis.
  Eigen::MatrixXd pressures(const Motions& motions) const;
  /// The whole state.
  State whole(const State& state) const;
};

/// Component mode synthesis [Craig and Bampton 1968] of a System whose interface is all that is not linear. u with W
/// and phi have directions of their own, so that the signs of M, C and K are kept; coordinates of rigid bodies are kept
/// as they are, so that forces on them balance to round-off. Motions of the nodes carry with them what the ground does
/// near them, see CarriedMotions. Motions of low degree, of more degrees at each level, and the loads have as many
/// moments as the level says, about two shifts; of these the directions that count, by proper orthogonal decomposition,
/// belong to the coordinates. Levels are nested.
class InterfaceSpace {
 public:
  /// `shift`: as of a Krylov space of the loads; `exact`, `kept`: see SecondOrderKrylov. The system must outlive it.
  /// `of_loads`: directions of the free unknowns in which these answer the loads, the first ones foremost, a column
  /// each; empty: moments of the loads are made.
  InterfaceSpace(const System& system, double shift, const std::vector<int>& exact, const std::vector<Vector>& kept,
                 Eigen::MatrixXd of_loads = {});
  ~InterfaceSpace();

  static constexpr int n_levels = 3;
  /// The model of the present level, at first the lowest.
  InterfaceModel model() const;
  /// Goes to the next level.
  void extend();
  int n_solves() const;

 private:
  struct MomentSeries {
    MomentTrain* train;
    const int* orders;  ///< moments at each level
    bool of_loads;
    Eigen::MatrixXd start, now, mass_before;  ///< loads or motions, their latest moments, and see MomentTrain::next
    int done;
  };

  void start();
  Eigen::MatrixXd loads_of_level() const;
  Eigen::MatrixXd normalised(Eigen::MatrixXd first) const;
  void take_level();
  void add(FieldBasis& basis, const std::vector<Eigen::MatrixXd>& columns);
  Eigen::MatrixXd exact_motions() const;

  const System& system_;
  double shift_;
  std::vector<bool> own_;
  Eigen::MatrixXd of_loads_;
  MomentTrain slow_;
  FieldBases bases_;                 ///< of all but the motions of the interface
  Eigen::Index n_own_[2], n_exact_;  ///< unknowns that are coordinates; these of displacements with directions kept
  MomentTrain fast_;
  CarriedMotions carried_;
  std::vector<MomentSeries> series_;
  std::unique_ptr<Projection> projection_;
  OfMatrices coupling_;  ///< of the bases' coordinates with the motions of the interface
  Eigen::Index n_projected_[2] = {0, 0};
  int level_ = -1;
};

}  // namespace upbead
