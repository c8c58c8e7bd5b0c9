// One step of a diagonally implicit Runge-Kutta scheme for a System.
#pragma once

#include "dirk_stage.h"
#include "effective_matrix.h"
#include "energy_meter.h"
#include "load_sum.h"
#include "symmetric_pair.h"

namespace upbead::detail {

/// A lower triangular tableau with one value on the diagonal, whose last row holds the weights (stiffly accurate).
struct Tableau {
  Eigen::MatrixXd a;
  Vector c() const { return a.rowwise().sum(); }
  Vector b() const { return a.row(a.rows() - 1).transpose(); }
  double gamma() const { return a(0, 0); }
  /// m_ij = b_i a_ij + b_j a_ji - b_i b_j (Burrage & Butcher 1979): the energy that the scheme itself takes.
  Eigen::MatrixXd stability() const;
};

/// Backward Euler.
Tableau euler_tableau();
/// Hairer & Wanner, Solving Ordinary Differential Equations II, table IV.6.5: order 4, 5 stages, L-stable.
Tableau sdirk4_tableau();
/// Order 2, 3 stages, L-stable; all weights are positive, so that a friction that takes power in every stage takes
/// energy over the step. With w = 1/(1 - z/4) the stability function is R(z) = w^3 + w^2 - w.
Tableau friction_tableau();

/// Stages of x' = v, v' = a with M a_i + C v_i + K x_i = f_i, solved for accelerations: with g = h gamma,
///   v_i = vhat + g a_i,  x_i = xhat + g v_i,  (M + g C + g^2 K) a_i = f_i - C vhat - K (xhat + g vhat).
class Dirk {
 public:
  Dirk(const System& system, Tableau tableau);

  /// Advances `state` by h with the loads of the piece that holds the time `inside`; `meter` may be null. One solve per
  /// stage, or what `law` needs. False where the law gives up: then `state` is as before, the account is not.
  bool step(State& state, double h, double inside, EffectiveMatrices& matrices, EnergyMeter* meter,
            StageLaw* law = nullptr);
  int n_stages() const { return static_cast<int>(c_.size()); }
  /// Load values at the end of the last step.
  const std::vector<double>& load() const { return load_; }

 private:
  void predict(const State& state, double h, int stage);
  void account(double h, EnergyMeter& meter);

  const System& system_;
  LoadSum loads_;
  SymmetricPair damping_and_stiffness_;
  Tableau tableau_;
  Vector b_, c_;
  Eigen::MatrixXd stability_;
  std::vector<double> load_;
  Eigen::MatrixXd V_, A_;  ///< stages, one per column
  DirkStage now_;
  Vector f_;
  VectorBlock block_;
};

}  // namespace upbead::detail
