// One step of a diagonally implicit Runge-Kutta scheme for a System.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "dynamics/effective_matrix.h"
#include "dynamics/energy_meter.h"
#include "dynamics/products.h"
#include "upbead/system/system.h"

namespace upbead::detail {

/// Evaluates the loads of a system, each on the smooth piece that contains a given time.
class LoadSum {
 public:
  explicit LoadSum(const System& system) : system_(system) {}

  /// f_k(t) of every load, on the piece that contains the time `inside`.
  void evaluate(double t, double inside, std::vector<double>& f) const;
  /// sum_k b_k f_k.
  void sum(const std::vector<double>& f, Vector& b) const;
  /// The velocities of the prescribed unknowns (the tail of `v`) under the load values f; zero where no load
  /// prescribes.
  void prescribe(const std::vector<double>& f, Vector& v) const;

 private:
  const System& system_;
};

/// A stage while it is solved: with g = h gamma, v = v_predicted + g a and x = x_explicit + g v.
struct DirkStage {
  Vector v_predicted;
  Vector x_explicit;  ///< of the prescribed unknowns
  Vector x;           ///< x_explicit + g v_predicted before move()
  Vector v;           ///< valid after move()
  Vector a;           ///< prescribed unknowns (tail): given; free ones: those of the last stage, until solved
  Vector rhs;         ///< f - C v_predicted - K x before move(), so that E a = rhs
  const Vector* load = nullptr;  ///< f
  double weight = 0.;            ///< of the stage in the step, h b_i (s)
  double time = 0.;              ///< s

  /// Sets x and v from a.
  void move(double g) {
    v = v_predicted + g * a;
    x += g * g * a;
  }
};

/// Determines the prescribed unknowns of a stage that no load moves.
class StageLaw {
 public:
  virtual ~StageLaw() = default;
  /// Adds to the loads of a stage at a time, on the piece that contains the time `inside`.
  virtual void add_load(double /*time*/, double /*inside*/, Vector& /*f*/) {}
  /// Solves the stage and moves it. False: the step must not go on.
  virtual bool solve(const EffectiveMatrix& E, double g, DirkStage& stage) = 0;
  /// The force, besides the loads, on the prescribed unknowns of the solved stage; null: none.
  virtual const Vector* force_on_prescribed() const { return nullptr; }
};

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

/// Steps of one tableau.
class Steps {
 public:
  Steps() = default;
  Steps(const Steps&) = delete;
  Steps& operator=(const Steps&) = delete;
  virtual ~Steps() = default;
  /// Advances `state` by h with the loads of the piece that contains the time `inside`; `meter` may be null. One
  /// solve for each stage, or as many as `law` needs. False where the law gives up: then `state` is as before, but
  /// the account of energy is not.
  virtual bool step(State& state, double h, double inside, EffectiveMatrices& matrices, EnergyMeter* meter,
                    StageLaw* law) = 0;
  virtual int n_stages() const = 0;
  /// Load values at the end of the last step.
  virtual const std::vector<double>& load() const = 0;
};

/// Stages of x' = v, v' = a with M a_i + C v_i + K x_i = f_i, solved for accelerations: with g = h gamma,
///   v_i = vhat + g a_i,  x_i = xhat + g v_i,  (M + g C + g^2 K) a_i = f_i - C vhat - K (xhat + g vhat).
class Dirk : public Steps {
 public:
  Dirk(const System& system, Tableau tableau);
  /// Shares the copies of C and K with another Dirk of the same system.
  Dirk(const Dirk& other, Tableau tableau) : Dirk(other.system_, std::move(tableau), other.damping_and_stiffness_) {}

  bool step(State& state, double h, double inside, EffectiveMatrices& matrices, EnergyMeter* meter,
            StageLaw* law) override;
  int n_stages() const override { return static_cast<int>(c_.size()); }
  const std::vector<double>& load() const override { return load_; }

 private:
  Dirk(const System& system, Tableau tableau, std::shared_ptr<const SymmetricPair> damping_and_stiffness);
  void predict(const State& state, double h, int stage);
  void account(double h, EnergyMeter& meter);

  const System& system_;
  LoadSum loads_;
  std::shared_ptr<const SymmetricPair> damping_and_stiffness_;
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
