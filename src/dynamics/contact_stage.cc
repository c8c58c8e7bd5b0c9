#include "dynamics/contact_stage.h"

#include <algorithm>
#include <utility>

#include "system/part.h"

namespace upbead::detail {

namespace {

constexpr std::size_t kept_problems = 3;  // as many as matrices are kept

}  // namespace

ContactStage::ContactStage(const System& system)
    : system_(system),
      interface_(*system.interface),
      n_(interface_.n_nodes()),
      scale_(interface_.normal_force.cwiseAbs().maxCoeff()),
      gaps_(interface_),
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
  gaps_.open(now_.status);
  gap_.resize(0);
}

void ContactStage::add_load(double time, double inside, Vector& f) {
  if (!gaps_.act()) return;
  gap_ = gaps_.at(time, inside);
  if (counts_for_prescribed(system_)) f.segment(system_.first_opening(), n_) += gap_;
}

bool ContactStage::all_stick() const {
  return std::all_of(now_.status.begin(), now_.status.end(),
                     [](ContactState contact) { return contact == ContactState::stick; });
}

ContactStage::Condensed& ContactStage::condensed(const EffectiveMatrix& E, double g) {
  const auto found = condensed_.find(g);
  if (found != condensed_.end()) return found->second;
  if (condensed_.size() == kept_problems) condensed_.clear();
  std::optional<Border> border = E.border_of_last(2 * n_);
  n_solves_ += border ? n_ : 2 * n_;  // with a border only half of each solve is done
  ContactProblem problem(E.condensed_on_last(2 * n_, border), interface_.friction);
  return condensed_.emplace(g, Condensed{std::move(border), std::move(problem)}).first->second;
}

/// First guess of the motion: nodes that stick go on sticking, all other nodes move without acceleration. So the
/// forces of the guess have the size of the true ones, on which tolerances depend.
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

/// Sets rates and positions directly, without the round-off of computing them from accelerations: a node that sticks
/// has exactly the rate 0, a closed one exactly the opening 0.
void ContactStage::set_motions(const Vector& motion, double g, DirkStage& stage) const {
  stage.v.tail(2 * n_).head(n_) = g * motion.head(n_);
  stage.x.tail(2 * n_).head(n_) = stage.x_explicit.tail(2 * n_).head(n_) + g * g * motion.head(n_);
  stage.x.tail(n_) = g * g * motion.tail(n_);
  stage.v.tail(n_) = (stage.x.tail(n_) - stage.x_explicit.tail(n_)) / g;
}

InterfaceForces ContactStage::forces(const Vector& residual) const {
  return {-residual.head(n_), interface_.normal_force + residual.tail(n_)};
}

/// Counts changes since the last stage. False where a node closed and the step has to stop there.
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

/// Moves the free unknowns with the interface, whose motion has changed since they were solved for.
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

/// Goes from the point of the guess to the one that obeys the law. False: the step must not go on.
bool ContactStage::decide(const std::function<ContactProblem&()>& problem, ContactPoint& point) {
  std::vector<ContactState> status(static_cast<std::size_t>(n_), ContactState::stick);
  if (!point.motion.isZero(0.) || !ContactProblem::holds(point.forces, interface_.friction, scale_)) {
    if (stop_ == StopAt::release) return false;
    status = now_.status;
    ContactProblem& law = problem();
    const int before = law.n_fallbacks();
    point = law.solve(point, scale_, status);
    n_fallbacks_ += law.n_fallbacks() - before;
  }
  return note(status);
}

bool ContactStage::solve_whole(const EffectiveMatrix& E, double g, DirkStage& stage, ContactPoint& point) {
  const Vector guess = point.motion;
  E.solve(stage.rhs, stage.a);
  point.forces = forces(E.residual_of_last(2 * n_, stage.rhs, stage.a));
  if (!decide([&]() -> ContactProblem& { return condensed(E, g).problem; }, point)) return false;
  if (point.motion != guess) correct(E, g, point.motion, stage);
  return true;
}

bool ContactStage::solve_by_halves(const EffectiveMatrix& E, double g, DirkStage& stage, ContactPoint& point) {
  Condensed& here = condensed(E, g);
  const Border& border = *here.border;
  point.forces = forces(E.begin(border, stage.rhs, stage.a));
  if (!decide([&]() -> ContactProblem& { return here.problem; }, point)) return false;
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

bool ContactStage::solve(CondensedStage& E, double g, DirkStage& stage) {
  ContactPoint point{first_guess(g, stage), {}};
  set_accelerations(point.motion, g, stage);
  ++n_solves_;
  point.forces = forces(E.begin(stage));
  if (!decide([&]() -> ContactProblem& { return E.problem(); }, point)) return false;
  set_accelerations(point.motion, g, stage);
  E.finish(stage);
  now_.forces = point.forces;
  stage.move(g);
  set_motions(point.motion, g, stage);
  return true;
}

}  // namespace upbead::detail
