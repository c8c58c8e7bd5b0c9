#include "dynamics/yielding.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "algebra/fixed_point.h"
#include "dynamics/dirk.h"
#include "dynamics/scheme_base.h"
#include "upbead/base/error.h"

namespace upbead {

namespace detail {

namespace {

/// Solves a stage under the internal force: the rows q of p with q = p(x(E^-1 (rhs + q))), so that the residual of the
/// fixed point is that of the equation of motion.
class YieldingStage : public StageLaw {
 public:
  YieldingStage(const System& system, InternalForce& force, double tolerance)
      : system_(system),
        force_(force),
        tolerance_(tolerance),
        q_(Vector::Zero(n_rows())),
        x_(system.size()),
        solver_(n_rows(), [this](const Vector& q, Vector& p) { evaluate(q, p); }) {}

  void start() {
    q_.setZero();
    largest_ = 0.;
    n_stages_ = n_evaluations_ = 0;
    work_ = 0.;
  }
  bool solve(const EffectiveMatrix& E, double g, DirkStage& stage) override;
  const Vector* force_on_prescribed() const override { return &on_prescribed_; }

  const Vector& force() const { return q_; }
  /// Done by the force since start() (J/m).
  double work() const { return work_; }
  void restore(const Vector& q, double work) {
    q_ = q;
    work_ = work;
  }
  int n_stages() const { return n_stages_; }
  int n_evaluations() const { return n_evaluations_; }

 private:
  int n_rows() const { return static_cast<int>(force_.rows().size()); }
  void evaluate(const Vector& q, Vector& p);
  void take_work(const DirkStage& stage);

  const System& system_;
  InternalForce& force_;
  double tolerance_;
  double largest_ = 0.;  ///< norm of loads or of what the soil exerts, so far: the tolerance is a share of it (N/m)
  Vector q_;             ///< of the last stage, which the next begins with
  double work_ = 0.;
  Vector x_, rhs_, solved_with_, on_prescribed_;
  const EffectiveMatrix* E_ = nullptr;
  DirkStage* stage_ = nullptr;
  double g_ = 0.;
  FixedPoint solver_;
  int n_stages_ = 0, n_evaluations_ = 0;
};

void YieldingStage::evaluate(const Vector& q, Vector& p) {
  rhs_ = stage_->rhs;
  const std::vector<int>& rows = force_.rows();
  for (std::size_t i = 0; i < rows.size(); ++i) rhs_[rows[i]] += q[static_cast<Eigen::Index>(i)];
  E_->solve(rhs_, stage_->a);
  solved_with_ = q;
  x_ = stage_->x + g_ * g_ * stage_->a;
  force_.evaluate(x_, p);
}

bool YieldingStage::solve(const EffectiveMatrix& E, double g, DirkStage& stage) {
  E_ = &E;
  g_ = g;
  stage_ = &stage;
  double sum = 0.;
  for (int i = 0; i < system_.n_free(); ++i)
    if (system_.field[i] == Field::displacement) sum += (*stage.load)[i] * (*stage.load)[i];
  largest_ = std::max({largest_, std::sqrt(sum), force_.exerted()});
  const FixedPointReport report = solver_.solve(q_, tolerance_ * largest_);
  ++n_stages_;
  n_evaluations_ += report.evaluations;
  if (!report.converged) return false;
  if (Vector p(n_rows()); solved_with_ != q_) evaluate(q_, p);  // the mixing may end on a q of its own
  stage.move(g);
  take_work(stage);
  return true;
}

void YieldingStage::take_work(const DirkStage& stage) {
  const std::vector<int>& rows = force_.rows();
  on_prescribed_ = Vector::Zero(system_.n_prescribed);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double force = q_[static_cast<Eigen::Index>(i)];
    work_ += stage.weight * force * stage.v[rows[i]];
    if (rows[i] >= system_.n_free()) on_prescribed_[rows[i] - system_.n_free()] = force;
  }
}

class YieldingDirk : public SchemeBase {
 public:
  YieldingDirk(const System& system, InternalForce& force, const YieldingOptions& options)
      : SchemeBase(checked(system), SchemeOptions{SchemeKind::sdirk4, 0., true, options.refined}),
        force_(force),
        dirk_(system, friction_tableau()),
        stage_(system, force, options.tolerance) {}

  void start(const State& state) override {
    SchemeBase::start(state);
    stage_.start();
    report_ = {};
    stored_ = force_.stored_beside_elastic();
  }
  std::string name() const override { return "yielding"; }
  int order() const override { return 2; }
  int solves_per_step() const override { return dirk_.n_stages(); }
  void advance(State& state, double h) override {
    advance_halving(state, h, state.time + 0.5 * h, 0);
    n_solves_ = report_.evaluations = stage_.n_evaluations();
    report_.stages = stage_.n_stages();
    end_load_ = dirk_.load();
    balanced_ = {state, end_load_};
  }
  SchemeMemory memory() const override {
    throw std::invalid_argument("a march of soil that yields keeps no checkpoints");
  }
  void recall(const SchemeMemory&) override { memory(); }
  const YieldingReport* yielding() const override { return &report_; }
  const Vector* added_to_readings() const override { return &force_.added_to_readings(); }

 private:
  static const System& checked(const System& system) {
    if (system.is_divided()) throw std::invalid_argument("soil that yields is not done on several processes");
    return system;
  }
  void advance_halving(State& state, double h, double inside, int depth);
  void commit(const Vector& x, double work);

  InternalForce& force_;
  Dirk dirk_;
  YieldingStage stage_;
  YieldingReport report_;
  double stored_ = 0.;  ///< by the force, beside the elastic K (J/m)
};

void YieldingDirk::commit(const Vector& x, double work) {
  const double dissipated = force_.commit(x), stored = force_.stored_beside_elastic();
  report_.dissipated += dissipated;
  meter()->add_yielding(work, dissipated, stored_, stored);
  stored_ = stored;
}

void YieldingDirk::advance_halving(State& state, double h, double inside, int depth) {
  constexpr int most = 10;
  const State before = state;
  const Vector force_before = stage_.force();
  const double work_before = stage_.work();
  const EnergyAccount account_before = energy();
  if (dirk_.step(state, h, inside, matrices_, meter(), &stage_)) return commit(state.x, stage_.work() - work_before);
  if (depth == most)
    throw NumericsError("the soil found no equilibrium at t = " + std::to_string(before.time) +
                        " s, with steps down to " + std::to_string(h) + " s: it may have failed");
  state = before;
  stage_.restore(force_before, work_before);
  meter()->restore(account_before);
  ++report_.cut_steps;
  advance_halving(state, 0.5 * h, inside, depth + 1);
  advance_halving(state, before.time + h - state.time, inside, depth + 1);
}

}  // namespace

}  // namespace detail

std::unique_ptr<Scheme> make_yielding_scheme(const System& system, InternalForce& force,
                                             const YieldingOptions& options) {
  return std::make_unique<detail::YieldingDirk>(system, force, options);
}

}  // namespace upbead
