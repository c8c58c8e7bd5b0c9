#include "dynamics/yielding.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "algebra/fixed_point.h"
#include "dynamics/contact_stage.h"
#include "dynamics/dirk.h"
#include "dynamics/scheme_base.h"
#include "system/part.h"
#include "upbead/base/error.h"

namespace upbead {

namespace detail {

namespace {

/// Solves a stage under the internal force: the rows q of p with q = p(x(E^-1 (rhs + q))), so that the residual of the
/// fixed point is that of the equation of motion. Where the system has an interface, x(q) obeys the law of contact
/// under that q: at the fixed point both laws hold.
class YieldingStage : public StageLaw {
 public:
  YieldingStage(const System& system, InternalForce& force, const YieldingOptions& options)
      : system_(system),
        layout_(layout_of(system)),
        force_(force),
        tolerance_(options.tolerance),
        least_(std::max(round_off * options.weight, std::numeric_limits<double>::min())),
        q_(Vector::Zero(n_rows())),
        x_(system.size()),
        solver_(n_rows(), [this](const Vector& q, Vector& p) { evaluate(q, p); }) {
    if (system.interface) contact_.emplace(system);
  }

  /// p in the rows at the end of a stage.
  struct Known {
    double time = 0.;
    Vector q;
  };
  /// What a failed step restores, besides the state.
  struct Memory {
    Known last, before;
    double work = 0.;
    InterfaceState interface;
  };

  void start(const State& state) {
    q_.setZero();
    last_ = before_ = {state.time, q_};
    largest_ = 0.;
    n_stages_ = n_evaluations_ = 0;
    work_ = 0.;
    if (contact_) contact_->start(state);
  }
  /// Begins a step of the march, which may take several steps of the scheme.
  void begin_step() {
    if (contact_) contact_->begin_step(StopAt::never);
  }
  /// Whether a step stops where a node closes.
  void stop_at_impact(bool stops) { stops_ = stops; }
  void add_load(double time, double inside, Vector& f) override {
    if (contact_) contact_->add_load(time, inside, f);
  }
  bool solve(const EffectiveMatrix& E, double g, DirkStage& stage) override;
  const Vector* force_on_prescribed() const override { return &on_prescribed_; }

  /// Work of the force since start() (J/m).
  double work() const { return work_; }
  Memory memory() const { return {last_, before_, work_, contact_ ? contact_->now() : InterfaceState()}; }
  void recall(const Memory& memory) {
    last_ = memory.last;
    before_ = memory.before;
    work_ = memory.work;
    if (contact_) contact_->restore(memory.interface);
  }
  double largest() const { return largest_; }
  void recall_largest(double largest) { largest_ = largest; }
  /// Null without an interface.
  const ContactStage* contact() const { return contact_ ? &*contact_ : nullptr; }
  /// Whether the last stage that was not solved stopped at an impact; else failure() says why, if that is known.
  bool met_impact() const { return met_impact_; }
  const std::string& failure() const { return failure_; }
  int n_stages() const { return n_stages_; }
  int n_evaluations() const { return n_evaluations_; }

 private:
  int n_rows() const { return static_cast<int>(force_.rows().size()); }
  void guess(double time);
  void evaluate(const Vector& q, Vector& p);
  void move(const Vector& q);
  void take_work(const DirkStage& stage);
  double of_displacements(const Vector& force) const;
  double scale(double g);

  static constexpr double round_off = 1e-6;  ///< with a tolerance of 1e-6: 1e-12 of the weights
  const System& system_;
  Layout layout_;
  InternalForce& force_;
  double tolerance_, least_;
  double largest_ = 0.;  ///< largest norm so far of loads or soil forces: the tolerance is a share of it (N/m)
  Known last_, before_;  ///< the last two stages: the next one starts on the line through them
  Vector q_;
  double work_ = 0.;
  Vector x_, rhs_, solved_with_, on_prescribed_;
  const EffectiveMatrix* E_ = nullptr;
  DirkStage* stage_ = nullptr;
  DirkStage given_;  ///< the stage before it is solved, with contact
  double g_ = 0.;
  FixedPoint solver_;
  std::optional<ContactStage> contact_;
  InterfaceState interface_before_;
  bool stops_ = false, met_impact_ = false;
  std::string failure_;
  int n_stages_ = 0, n_evaluations_ = 0;
};

void YieldingStage::guess(double time) {
  q_ = last_.q;
  if (last_.time > before_.time) q_ += (time - last_.time) / (last_.time - before_.time) * (last_.q - before_.q);
}

/// Computes x under q.
void YieldingStage::move(const Vector& q) {
  const std::vector<int>& rows = force_.rows();
  const auto add = [&](Vector& rhs) {
    for (std::size_t i = 0; i < rows.size(); ++i)
      if (rows[i] >= 0) rhs[rows[i]] += q[static_cast<Eigen::Index>(i)];
  };
  if (contact_) {
    stage_->rhs = given_.rhs;
    stage_->x = given_.x;
    add(stage_->rhs);
    contact_->restore(interface_before_);
    contact_->solve(*E_, g_, *stage_);
    x_ = stage_->x;
  } else {
    rhs_ = stage_->rhs;
    add(rhs_);
    E_->solve(rhs_, stage_->a);
    x_ = stage_->x + g_ * g_ * stage_->a;
  }
  solved_with_ = q;
}

/// A strain or a motion for which no law has an answer ends this stage, not the march: a shorter step may succeed.
void YieldingStage::evaluate(const Vector& q, Vector& p) {
  try {
    move(q);
    force_.evaluate(x_, p);
  } catch (const NumericsError& error) {
    failure_ = error.what();
    p.setConstant(n_rows(), std::nan(""));
  }
}

/// Of a force of which each process has the rows for which it counts.
double YieldingStage::of_displacements(const Vector& force) const {
  double sum = 0.;
  for (int i = 0; i < system_.n_free(); ++i)
    if (system_.field[i] == Field::displacement) sum += force[i] * force[i];
  return std::sqrt(layout_.sum(sum));
}

/// Norm of the forces that the tolerance is a share of. Where neither loads nor soil have exerted any so far, it is
/// that of the motions and pressures given at boundaries, on ground that has not moved.
double YieldingStage::scale(double g) {
  const DirkStage& stage = *stage_;
  largest_ = std::max({largest_, of_displacements(*stage.load), force_.exerted()});
  const int n = system_.n_prescribed;
  if (largest_ > least_ || n == 0) return std::max(largest_, least_);
  Vector a = Vector::Zero(system_.size()), v = a, x = a;
  a.tail(n) = stage.a.tail(n);
  v.tail(n) = stage.v_predicted.tail(n) + g * a.tail(n);
  x.tail(n) = stage.x.tail(n) + g * g * a.tail(n);
  const Vector force = system_.M * a + system_.C * v + system_.K * x;
  return std::max(least_, of_displacements(layout_.counted(values_of(system_, force))));
}

bool YieldingStage::solve(const EffectiveMatrix& E, double g, DirkStage& stage) {
  E_ = &E;
  g_ = g;
  stage_ = &stage;
  met_impact_ = false;
  failure_.clear();
  if (contact_) {
    given_ = stage;
    interface_before_ = contact_->now();
  }
  guess(stage.time);
  const FixedPointReport report = solver_.solve(q_, tolerance_ * scale(g));
  ++n_stages_;
  n_evaluations_ += report.evaluations;
  if (!report.converged) return false;
  if (solved_with_ != q_) move(q_);  // the mixing may end on a q that was not evaluated
  met_impact_ = stops_ && contact_->now().impacts > interface_before_.impacts;
  if (met_impact_) return false;
  if (!contact_) stage.move(g);
  before_ = std::move(last_);
  last_ = {stage.time, q_};
  take_work(stage);
  return true;
}

void YieldingStage::take_work(const DirkStage& stage) {
  const std::vector<int>& rows = force_.rows();
  on_prescribed_ = Vector::Zero(system_.n_prescribed);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i] < 0) continue;
    const double force = q_[static_cast<Eigen::Index>(i)];
    work_ += stage.weight * force * stage.v[rows[i]];
    if (rows[i] >= system_.n_free()) on_prescribed_[rows[i] - system_.n_free()] = force;
  }
}

/// With contact two tableaux of the same gamma share a matrix, as those of FrictionalContact do: order 2 where no node
/// closes, four steps of backward Euler where one does, as velocities jump there.
class YieldingDirk : public SchemeBase {
 public:
  YieldingDirk(const System& system, InternalForce& force, const YieldingOptions& options)
      : SchemeBase(system, SchemeOptions{SchemeKind::sdirk4, 0., true, options.refined}),
        force_(force),
        smooth_(system, friction_tableau()),
        impact_(smooth_, euler_tableau()),
        stage_(system, force, options) {
    start(at_rest(system));
  }

  void start(const State& state) override {
    SchemeBase::start(state);
    stage_.start(state);
    report_ = {};
    stored_ = force_.stored_beside_elastic();
    fallbacks_before_ = has_contact() ? stage_.contact()->n_fallbacks() : 0;
    if (has_contact()) contact_ = {stage_.contact()->now().forces};
  }
  std::string name() const override { return has_contact() ? "yielding, contact" : "yielding"; }
  int order() const override { return 2; }
  int solves_per_step() const override { return smooth_.n_stages(); }
  void advance(State& state, double h) override;
  SchemeMemory memory() const override;
  void recall(const SchemeMemory& memory) override;
  const YieldingReport* yielding() const override { return &report_; }
  const ContactReport* contact() const override { return has_contact() ? &contact_ : nullptr; }
  const Vector* added_to_readings() const override { return &force_.added_to_readings(); }

 private:
  enum class Outcome { done, impact, unsolved };

  bool has_contact() const { return system_.interface.has_value(); }
  Outcome attempt(Dirk& dirk, State& state, double h, double inside);
  void advance_halving(State& state, double h, double inside, int depth);
  void advance_through_impact(State& state, double h, double inside, int depth);
  void halve(State& state, double h, int depth, const std::function<void(double part)>& half);
  bool settled(const State& state) const;
  void commit(const Vector& x, double work);
  void report_contact();

  InternalForce& force_;
  Dirk smooth_, impact_;
  YieldingStage stage_;
  YieldingReport report_;
  ContactReport contact_;
  int fallbacks_before_ = 0;
  double stored_ = 0.;  ///< stored by the force, besides the elastic K (J/m)
};

void YieldingDirk::advance(State& state, double h) {
  const int before = stage_.n_evaluations();
  stage_.begin_step();
  advance_halving(state, h, state.time + 0.5 * h, 0);
  n_solves_ += stage_.n_evaluations() - before;
  report_.evaluations += stage_.n_evaluations() - before;
  balanced_ = {state, end_load_};
  if (has_contact()) report_contact();
}

void YieldingDirk::commit(const Vector& x, double work) {
  const double dissipated = force_.commit(x), stored = force_.stored_beside_elastic();
  report_.dissipated += dissipated;
  meter()->add_yielding(work, dissipated, stored_, stored);
  stored_ = stored;
}

/// Takes a step with a tableau. Where it fails, all is as before except the counts.
YieldingDirk::Outcome YieldingDirk::attempt(Dirk& dirk, State& state, double h, double inside) {
  const State before = state;
  const YieldingStage::Memory stage_before = stage_.memory();
  const EnergyAccount account_before = energy();
  const int stages_before = stage_.n_stages();
  stage_.stop_at_impact(has_contact() && &dirk == &smooth_);
  const bool done = dirk.step(state, h, inside, matrices_, meter(), &stage_);
  report_.stages += stage_.n_stages() - stages_before;
  if (done) {
    commit(state.x, stage_.work() - stage_before.work);
    end_load_ = dirk.load();
    return Outcome::done;
  }
  state = before;
  stage_.recall(stage_before);
  meter()->restore(account_before);
  return stage_.met_impact() ? Outcome::impact : Outcome::unsolved;
}

/// Whether no velocity is about to jump: a node that has closed in the last stage still has the rate at which it did.
bool YieldingDirk::settled(const State& state) const {
  if (!has_contact()) return true;
  const int n = system_.interface->n_nodes();
  return ((state.x.tail(n).array() > 0.) || (state.v.tail(n).array() == 0.)).all();
}

void YieldingDirk::halve(State& state, double h, int depth, const std::function<void(double)>& half) {
  constexpr int most = 10;
  const double begin = state.time;
  if (depth == most)
    throw NumericsError("the soil found no equilibrium at t = " + std::to_string(begin) + " s, with steps down to " +
                        std::to_string(h) + " s: it may have failed" +
                        (stage_.failure().empty() ? "" : " (" + stage_.failure() + ")"));
  ++report_.cut_steps;
  half(0.5 * h);
  half(begin + h - state.time);
}

void YieldingDirk::advance_halving(State& state, double h, double inside, int depth) {
  const Outcome outcome = settled(state) ? attempt(smooth_, state, h, inside) : Outcome::impact;
  if (outcome == Outcome::impact) {
    constexpr int n = 4;  // of the same gamma
    const double begin = state.time;
    for (int i = 0; i < n; ++i) advance_through_impact(state, begin + (i + 1) * h / n - state.time, inside, depth);
  } else if (outcome == Outcome::unsolved) {
    halve(state, h, depth, [&](double part) { advance_halving(state, part, inside, depth + 1); });
  }
}

void YieldingDirk::advance_through_impact(State& state, double h, double inside, int depth) {
  if (attempt(impact_, state, h, inside) == Outcome::done) return;
  halve(state, h, depth, [&](double part) { advance_through_impact(state, part, inside, depth + 1); });
}

void YieldingDirk::report_contact() {
  const InterfaceState& now = stage_.contact()->now();
  contact_.forces = now.forces;
  contact_.gap = stage_.contact()->gap();
  contact_.slip_steps += now.slipped;
  contact_.open_steps += now.opened;
  contact_.impacts += now.impacts;
  contact_.fallbacks = stage_.contact()->n_fallbacks() - fallbacks_before_;
}

SchemeMemory YieldingDirk::memory() const {
  if (has_contact() || system_.is_divided())
    throw std::invalid_argument("soil that yields keeps no checkpoints with contact, nor on several processes");
  SchemeMemory memory = SchemeBase::memory();
  const YieldingStage::Memory stage = stage_.memory();
  memory.history = {stage.work,
                    stage.last.time,
                    stage.before.time,
                    stage_.largest(),
                    stored_,
                    report_.dissipated,
                    static_cast<double>(report_.stages),
                    static_cast<double>(report_.evaluations),
                    static_cast<double>(report_.cut_steps)};
  for (const std::vector<double>& more :
       {std::vector<double>(stage.last.q.begin(), stage.last.q.end()),
        std::vector<double>(stage.before.q.begin(), stage.before.q.end()), force_.memory()})
    memory.history.insert(memory.history.end(), more.begin(), more.end());
  return memory;
}

void YieldingDirk::recall(const SchemeMemory& memory) {
  SchemeBase::recall(memory);
  const auto n = static_cast<std::size_t>(force_.rows().size());
  constexpr std::size_t n_numbers = 9;
  if (memory.history.size() < n_numbers + 2 * n) throw NumericsError("the checkpoint does not belong to this soil");
  const double* from = memory.history.data();
  YieldingStage::Memory stage = stage_.memory();
  for (double* number : {&stage.work, &stage.last.time, &stage.before.time}) *number = *from++;
  stage_.recall_largest(*from++);
  stored_ = *from++;
  report_.dissipated = *from++;
  for (int* count : {&report_.stages, &report_.evaluations, &report_.cut_steps}) *count = static_cast<int>(*from++);
  for (Vector* q : {&stage.last.q, &stage.before.q}) {
    *q = Eigen::Map<const Vector>(from, static_cast<Eigen::Index>(n));
    from += n;
  }
  stage_.recall(stage);
  force_.recall({from, memory.history.data() + memory.history.size()});
}

}  // namespace

}  // namespace detail

std::unique_ptr<Scheme> make_yielding_scheme(const System& system, InternalForce& force,
                                             const YieldingOptions& options) {
  return std::make_unique<detail::YieldingDirk>(system, force, options);
}

}  // namespace upbead
