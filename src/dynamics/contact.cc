#include "dynamics/contact.h"

#include <stdexcept>

#include "dynamics/contact_stage.h"
#include "dynamics/ground_steps.h"
#include "dynamics/scheme_base.h"

namespace upbead {

namespace detail {

namespace {

/// Three tableaux with the same gamma share one matrix: order 4 while all nodes stick; order 2 while some slip or
/// open; four steps of backward Euler where a node closes, as velocities jump there and the later stages of a scheme
/// of higher order would make the node bounce. A step that meets an event for which its tableau is not made is
/// repeated with the next tableau.
class FrictionalContact : public SchemeBase {
 public:
  FrictionalContact(const System& system, const SchemeOptions& options, const GroundMatrices* ground,
                    std::shared_ptr<GroundStages> stages);
  std::string name() const override { return "contact"; }
  int order() const override { return 2; }
  int solves_per_step() const override { return bonded_->n_stages(); }
  void start(const State& state) override;
  void advance(State& state, double h) override;
  bool leap(State& state, double h) override;
  const ContactReport* contact() const override { return &report_; }
  SchemeMemory memory() const override;
  void recall(const SchemeMemory& memory) override;

 private:
  void make_steps(const GroundMatrices* ground, std::shared_ptr<GroundStages> shared);
  bool attempt(Steps& steps, int n, StopAt stop, State& state, double h);
  bool settled(const State& state) const;
  void end_step(const State& state);
  void report();

  ContactStage stage_;
  std::unique_ptr<Steps> bonded_, moving_, impact_;
  ContactReport report_;
  int fallbacks_before_ = 0;
  int steps_at_rest_ = 0;  ///< number of steps since a node moved or a leap failed
};

const System& checked(const System& system) {
  if (!system.interface || system.interface->n_nodes() == 0)
    throw std::invalid_argument("contact needs a system with an interface");
  return system;
}

FrictionalContact::FrictionalContact(const System& system, const SchemeOptions& options, const GroundMatrices* ground,
                                     std::shared_ptr<GroundStages> stages)
    : SchemeBase(checked(system), options), stage_(system) {
  make_steps(ground, std::move(stages));
  report_.forces = stage_.now().forces;
}

void FrictionalContact::make_steps(const GroundMatrices* ground, std::shared_ptr<GroundStages> shared) {
  if (ground == nullptr) {
    auto first = std::make_unique<Dirk>(system_, sdirk4_tableau());
    moving_ = std::make_unique<Dirk>(*first, friction_tableau());
    impact_ = std::make_unique<Dirk>(*first, euler_tableau());
    bonded_ = std::move(first);
    return;
  }
  if (!shared) shared = std::make_shared<GroundStages>();
  shared->motion = {};
  const auto steps = [&](Tableau tableau) {
    return std::make_unique<GroundSteps>(system_, *ground, std::move(tableau), stage_, shared);
  };
  bonded_ = steps(sdirk4_tableau());
  moving_ = steps(friction_tableau());
  impact_ = steps(euler_tableau());
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

/// Takes the step as n equal steps of a tableau; where one of them stops, all but the number of solves is as before.
bool FrictionalContact::attempt(Steps& steps, int n, StopAt stop, State& state, double h) {
  const State before = state;
  const InterfaceState stage_before = stage_.now();
  const EnergyAccount account_before = energy();
  stage_.begin_step(stop);
  for (int i = 0; i < n; ++i)
    if (!steps.step(state, h / n, before.time + 0.5 * h, matrices_, meter(), &stage_)) {
      state = before;
      stage_.restore(stage_before);
      if (meter() != nullptr) meter()->restore(account_before);
      return false;
    }
  state.time = before.time + h;
  end_load_ = steps.load();
  return true;
}

/// Whether no velocity is about to jump: a node that has closed in the last stage still has the rate at which it
/// closed.
bool FrictionalContact::settled(const State& state) const {
  const int n = system_.interface->n_nodes();
  return ((state.x.tail(n).array() > 0.) || (state.v.tail(n).array() == 0.)).all();
}

void FrictionalContact::advance(State& state, double h) {
  const bool is_settled = settled(state);
  if (!(is_settled && stage_.all_stick() && attempt(*bonded_, 1, StopAt::release, state, h)) &&
      !(is_settled && attempt(*moving_, 1, StopAt::impact, state, h)))
    attempt(*impact_, 4, StopAt::never, state, h);
  end_step(state);
}

/// A step of order 4 in place of several short ones. Where it fails, a node is about to move, so no other is tried
/// for some steps.
bool FrictionalContact::leap(State& state, double h) {
  constexpr int wait = 2;
  if (steps_at_rest_ < wait) return false;
  if (attempt(*bonded_, 1, StopAt::release, state, h)) {
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
  report_.gap = stage_.gap();
  report_.slip_steps += now.slipped;
  report_.open_steps += now.opened;
  report_.impacts += now.impacts;
  report_.fallbacks = stage_.n_fallbacks() - fallbacks_before_;
}

}  // namespace

}  // namespace detail

std::unique_ptr<Scheme> make_contact_scheme(const System& system, bool account_energy, bool refined) {
  return std::make_unique<detail::FrictionalContact>(
      system, SchemeOptions{SchemeKind::sdirk4, 0., account_energy, refined}, nullptr, nullptr);
}

std::unique_ptr<Scheme> make_contact_scheme(const System& system, const GroundMatrices& ground,
                                            std::shared_ptr<detail::GroundStages> stages) {
  return std::make_unique<detail::FrictionalContact>(system, SchemeOptions{SchemeKind::sdirk4, 0., true, false},
                                                     &ground, std::move(stages));
}

}  // namespace upbead
