#include "dynamics/contact.h"

#include <algorithm>
#include <map>
#include <optional>
#include <stdexcept>

#include "dynamics/contact_problem.h"
#include "dynamics/dirk.h"
#include "dynamics/scheme_base.h"

namespace upbead {

namespace detail {

namespace {

/// What a step shall not go on with.
enum class StopAt {
  release,  ///< a node slips or opens
  impact,   ///< a node closes
  never,
};

/// What the nodes do at one time, and what they did in the steps that led there.
struct InterfaceState {
  std::vector<ContactState> status;
  InterfaceForces forces;
  bool slipped = false;  ///< a node, in this step
  bool opened = false;   ///< a node, in this step
  int impacts = 0;       ///< nodes that closed, in this step
};

/// Solves stages under the law of contact (ContactProblem). In a stage the free unknowns follow those of the interface
/// linearly, so that its forces do as well: D is E condensed on the interface, for motions q = (slip rate / g,
/// opening / g^2).
class ContactStage : public StageLaw {
  /// Of one E: the law halfway through a solve, where that can be halted, so that a stage takes one solve; else after
  /// it, and a second one follows.
  struct Condensed {
    std::optional<Border> border;
    ContactProblem problem;
  };

 public:
  explicit ContactStage(const System& system);
  void start(const State& state);
  void begin_step(StopAt stop);
  bool solve(const EffectiveMatrix& E, double g, DirkStage& stage) override;

  const InterfaceState& now() const { return now_; }
  /// Goes back to what was before.
  void restore(const InterfaceState& before) { now_ = before; }
  /// Whether all nodes stick.
  bool all_stick() const;
  int n_solves() const { return n_solves_; }
  int n_fallbacks() const;

 private:
  Vector first_guess(double g, const DirkStage& stage) const;
  Condensed& condensed(const EffectiveMatrix& E, double g);
  InterfaceForces forces(const Vector& residual) const;
  bool decide(const EffectiveMatrix& E, double g, ContactPoint& point);
  bool solve_whole(const EffectiveMatrix& E, double g, DirkStage& stage, ContactPoint& point);
  bool solve_by_halves(const EffectiveMatrix& E, double g, DirkStage& stage, ContactPoint& point);
  void set_accelerations(const Vector& motion, double g, DirkStage& stage) const;
  void set_motions(const Vector& motion, double g, DirkStage& stage) const;
  void correct(const EffectiveMatrix& E, double g, const Vector& motion, DirkStage& stage);
  bool note(const std::vector<ContactState>& status);

  const System& system_;
  const Interface& interface_;
  int n_;
  double scale_;  ///< largest normal force at rest
  InterfaceState now_;
  StopAt stop_ = StopAt::never;
  std::map<double, Condensed> condensed_;  ///< by g
  int fallbacks_of_dropped_ = 0;
  int n_solves_ = 0;
  Vector no_load_, correction_;
};

constexpr std::size_t kept_problems = 3;  // as many as matrices are kept

ContactStage::ContactStage(const System& system)
    : system_(system),
      interface_(*system.interface),
      n_(interface_.n_nodes()),
      scale_(interface_.normal_force.cwiseAbs().maxCoeff()),
      no_load_(system.size()),
      correction_(system.size()) {
  start(at_rest(system));
}

void ContactStage::start(const State& state) {
  now_ = {};
  now_.status.assign(static_cast<std::size_t>(n_), ContactState::stick);
  now_.forces = {Vector::Zero(n_), interface_.normal_force};
  for (int i = 0; i < n_; ++i) {
    const double slip_rate = state.v[system_.first_slip() + i];
    ContactState& contact = now_.status[i];
    if (slip_rate != 0.) contact = slip_rate > 0. ? ContactState::slip_landward : ContactState::slip_seaward;
    if (state.x[system_.first_opening() + i] > 0.) contact = ContactState::open;
  }
}

void ContactStage::begin_step(StopAt stop) {
  stop_ = stop;
  now_.slipped = now_.opened = false;
  now_.impacts = 0;
}

bool ContactStage::all_stick() const {
  return std::all_of(now_.status.begin(), now_.status.end(),
                     [](ContactState contact) { return contact == ContactState::stick; });
}

int ContactStage::n_fallbacks() const {
  int n = fallbacks_of_dropped_;
  for (const auto& [g, condensed] : condensed_) n += condensed.problem.n_fallbacks();
  return n;
}

ContactStage::Condensed& ContactStage::condensed(const EffectiveMatrix& E, double g) {
  const auto found = condensed_.find(g);
  if (found != condensed_.end()) return found->second;
  if (condensed_.size() == kept_problems) {
    fallbacks_of_dropped_ = n_fallbacks();
    condensed_.clear();
  }
  std::optional<Border> border = E.border_of_last(2 * n_);
  n_solves_ += border ? n_ : 2 * n_;  // of the halves one is done
  ContactProblem problem(E.condensed_on_last(2 * n_, border), interface_.friction);
  return condensed_.emplace(g, Condensed{std::move(border), std::move(problem)}).first->second;
}

/// Nodes that stuck go on so; the others move as if nothing accelerated them. So the forces of the guess are of the
/// size of the true ones, which is what tolerances rest on.
Vector ContactStage::first_guess(double g, const DirkStage& stage) const {
  Vector motion = Vector::Zero(2 * n_);
  for (int i = 0; i < n_; ++i) {
    const ContactState contact = now_.status[i];
    if (contact != ContactState::stick) motion[i] = stage.v_predicted[system_.first_slip() + i] / g;
    if (contact == ContactState::open) motion[n_ + i] = std::max(stage.x[system_.first_opening() + i], 0.) / (g * g);
  }
  return motion;
}

void ContactStage::set_accelerations(const Vector& motion, double g, DirkStage& stage) const {
  const auto v_predicted = stage.v_predicted.tail(2 * n_);
  const Vector opening_rate = (g * g * motion.tail(n_) - stage.x_explicit.tail(n_)) / g;
  stage.a.tail(2 * n_).head(n_) = (g * motion.head(n_) - v_predicted.head(n_)) / g;
  stage.a.tail(n_) = (opening_rate - v_predicted.tail(n_)) / g;
}

/// Without the round-off of going through accelerations: what sticks has the rate 0., what is closed the opening 0.
void ContactStage::set_motions(const Vector& motion, double g, DirkStage& stage) const {
  stage.v.tail(2 * n_).head(n_) = g * motion.head(n_);
  stage.x.tail(2 * n_).head(n_) = stage.x_explicit.tail(2 * n_).head(n_) + g * g * motion.head(n_);
  stage.x.tail(n_) = g * g * motion.tail(n_);
  stage.v.tail(n_) = (stage.x.tail(n_) - stage.x_explicit.tail(n_)) / g;
}

InterfaceForces ContactStage::forces(const Vector& residual) const {
  return {-residual.head(n_), interface_.normal_force + residual.tail(n_)};
}

/// Compares with the last stage.
bool ContactStage::note(const std::vector<ContactState>& status) {
  bool impact = false;
  for (std::size_t i = 0; i < status.size(); ++i) {
    const ContactState before = now_.status[i], after = status[i];
    const bool closed = before == ContactState::open && after != ContactState::open;
    now_.impacts += closed;
    impact = impact || closed;
    now_.opened = now_.opened || after == ContactState::open;
    now_.slipped = now_.slipped || direction(after) != 0.;
  }
  now_.status = status;
  return stop_ != StopAt::impact || !impact;
}

/// The free unknowns follow the interface from the motion that they were solved with to another one.
void ContactStage::correct(const EffectiveMatrix& E, double g, const Vector& motion, DirkStage& stage) {
  const Vector before = stage.a.tail(2 * n_);
  set_accelerations(motion, g, stage);
  correction_.tail(system_.n_prescribed).setZero();
  correction_.tail(2 * n_) = stage.a.tail(2 * n_) - before;
  no_load_.setZero();
  E.solve(no_load_, correction_);
  ++n_solves_;
  stage.a.head(system_.n_free()) += correction_.head(system_.n_free());
}

/// From the point of the guess to the one that obeys the law. False: the step shall not go on.
bool ContactStage::decide(const EffectiveMatrix& E, double g, ContactPoint& point) {
  std::vector<ContactState> status(static_cast<std::size_t>(n_), ContactState::stick);
  if (!point.motion.isZero(0.) || !ContactProblem::holds(point.forces, interface_.friction, scale_)) {
    if (stop_ == StopAt::release) return false;
    status = now_.status;
    point = condensed(E, g).problem.solve(point, scale_, status);
  }
  return note(status);
}

bool ContactStage::solve_whole(const EffectiveMatrix& E, double g, DirkStage& stage, ContactPoint& point) {
  const Vector guess = point.motion;
  E.solve(stage.rhs, stage.a);
  point.forces = forces(E.residual_of_last(2 * n_, stage.rhs, stage.a));
  if (!decide(E, g, point)) return false;
  if (point.motion != guess) correct(E, g, point.motion, stage);
  return true;
}

bool ContactStage::solve_by_halves(const EffectiveMatrix& E, double g, DirkStage& stage, ContactPoint& point) {
  const Border& border = *condensed(E, g).border;
  point.forces = forces(E.begin(border, stage.rhs, stage.a));
  if (!decide(E, g, point)) return false;
  const Vector before = stage.a.tail(2 * n_);
  set_accelerations(point.motion, g, stage);
  const Vector change = stage.a.tail(2 * n_) - before;
  stage.a.tail(2 * n_) = before;
  E.finish(border, change, stage.rhs, stage.a);
  return true;
}

bool ContactStage::solve(const EffectiveMatrix& E, double g, DirkStage& stage) {
  ContactPoint point{first_guess(g, stage), {}};
  set_accelerations(point.motion, g, stage);
  ++n_solves_;
  const bool halves = stop_ != StopAt::release && condensed(E, g).border;
  if (!(halves ? solve_by_halves(E, g, stage, point) : solve_whole(E, g, stage, point))) return false;
  now_.forces = forces(E.residual_of_last(2 * n_, stage.rhs, stage.a));
  stage.move(g);
  set_motions(point.motion, g, stage);
  return true;
}

/// Three tableaux with the same gamma share one matrix: order 4 while all nodes stick; order 2 while some move; four
/// steps of backward Euler where one closes, as velocities jump there and later stages of a higher order would make the
/// node bounce. A step that meets what its tableau is not made for is done anew with the next one.
class FrictionalContact : public SchemeBase {
 public:
  FrictionalContact(const System& system, const SchemeOptions& options);
  std::string name() const override { return "contact"; }
  int order() const override { return 2; }
  int solves_per_step() const override { return glued_.n_stages(); }
  void start(const State& state) override;
  void advance(State& state, double h) override;
  bool leap(State& state, double h) override;
  const ContactReport* contact() const override { return &report_; }
  SchemeMemory memory() const override;
  void recall(const SchemeMemory& memory) override;

 private:
  bool attempt(Dirk& dirk, int n, StopAt stop, State& state, double h);
  bool settled(const State& state) const;
  void end_step(const State& state);
  void report();

  Dirk glued_, moving_, impact_;
  ContactStage stage_;
  ContactReport report_;
  int fallbacks_before_ = 0;
  int steps_at_rest_ = 0;  ///< since a node moved or a leap failed
};

const System& checked(const System& system) {
  if (!system.interface || system.interface->n_nodes() == 0)
    throw std::invalid_argument("contact needs a system with an interface");
  if (system.is_divided()) throw std::invalid_argument("contact is not done on several processes");
  return system;
}

FrictionalContact::FrictionalContact(const System& system, const SchemeOptions& options)
    : SchemeBase(checked(system), options),
      glued_(system, sdirk4_tableau()),
      moving_(glued_, friction_tableau()),
      impact_(glued_, euler_tableau()),
      stage_(system) {
  report_.forces = stage_.now().forces;
}

void FrictionalContact::start(const State& state) {
  SchemeBase::start(state);
  stage_.start(state);
  fallbacks_before_ = stage_.n_fallbacks();
  report_ = {stage_.now().forces};
  steps_at_rest_ = 0;
}

SchemeMemory FrictionalContact::memory() const {
  throw std::invalid_argument("a march with contact keeps no checkpoints");
}

void FrictionalContact::recall(const SchemeMemory&) {
  throw std::invalid_argument("a march with contact keeps no checkpoints");
}

/// The step by n equal steps of a tableau; where they stop, all is as before but for the solves.
bool FrictionalContact::attempt(Dirk& dirk, int n, StopAt stop, State& state, double h) {
  const State before = state;
  const InterfaceState stage_before = stage_.now();
  const EnergyAccount account_before = energy();
  stage_.begin_step(stop);
  for (int i = 0; i < n; ++i)
    if (!dirk.step(state, h / n, before.time + 0.5 * h, matrices_, meter(), &stage_)) {
      state = before;
      stage_.restore(stage_before);
      if (meter() != nullptr) meter()->restore(account_before);
      return false;
    }
  state.time = before.time + h;
  end_load_ = dirk.load();
  return true;
}

/// Whether no velocity is about to jump: a node that has closed in the last stage still has the rate at which it did.
bool FrictionalContact::settled(const State& state) const {
  const int n = system_.interface->n_nodes();
  return ((state.x.tail(n).array() > 0.) || (state.v.tail(n).array() == 0.)).all();
}

void FrictionalContact::advance(State& state, double h) {
  const bool is_settled = settled(state);
  if (!(is_settled && stage_.all_stick() && attempt(glued_, 1, StopAt::release, state, h)) &&
      !(is_settled && attempt(moving_, 1, StopAt::impact, state, h)))
    attempt(impact_, 4, StopAt::never, state, h);
  end_step(state);
}

/// A step of order 4 needs no short ones. Where it failed, a node is about to move: not again for a while.
bool FrictionalContact::leap(State& state, double h) {
  constexpr int wait = 2;
  if (steps_at_rest_ < wait) return false;
  if (attempt(glued_, 1, StopAt::release, state, h)) {
    end_step(state);
    return true;
  }
  steps_at_rest_ = 0;
  return false;
}

void FrictionalContact::end_step(const State& state) {
  n_solves_ = stage_.n_solves();
  const InterfaceState& now = stage_.now();
  steps_at_rest_ = now.slipped || now.opened ? 0 : steps_at_rest_ + 1;
  balanced_.state = state;
  balanced_.load = end_load_;
  report();
}

void FrictionalContact::report() {
  const InterfaceState& now = stage_.now();
  report_.forces = now.forces;
  report_.slip_steps += now.slipped;
  report_.open_steps += now.opened;
  report_.impacts += now.impacts;
  report_.fallbacks = stage_.n_fallbacks() - fallbacks_before_;
}

}  // namespace

}  // namespace detail

std::unique_ptr<Scheme> make_contact_scheme(const System& system, bool account_energy, bool refined) {
  return std::make_unique<detail::FrictionalContact>(system,
                                                     SchemeOptions{SchemeKind::sdirk4, 0., account_energy, refined});
}

}  // namespace upbead
