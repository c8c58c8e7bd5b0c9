#include "sliding/coupled_slip.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "base/root.h"
#include "base/text.h"
#include "dynamics/slip_path.h"
#include "dynamics/slip_steps.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

/// The most changes of phase that are followed within one piece of the finest steps, and in all.
constexpr int most_changes = 12, most_in_all = 200000;
constexpr int stretches_between_drops = 64;
/// Share of the energy that friction takes in a step, which the bends within the step may make wrong.
constexpr double tolerable = 0.01;
/// The longest slip after the wave, as a multiple of the length of the wave's samples.
constexpr double longest_tail = 10.;
/// How often a step may be halved.
constexpr double most_halvings = 12.;
/// Share of the friction that may depend on the ground pulling at the bottom.
constexpr double tolerable_pull = 0.01;
/// Share of the energy that counts as round-off of the modes.
constexpr double round_off = 1e-6;

enum class SlipEvent {
  none,
  starts,  ///< |F_T| reaches mu N'
  stops,   ///< s' = 0
  lifts,   ///< N' = 0, falling
  lands    ///< N' = 0, rising
};

struct TimedEvent {
  SlipEvent event = SlipEvent::none;
  double time = 0.;  ///< from the start of the stretch (s)
};

/// Root of f with f(from) >= 0 > f(to): the end with f < 0 of the last bracket, or a number next to it.
template <class Function>
double root(const Function& f, double from, double to) {
  return root_bracket(f, from, to, 46).second;
}

/// The time at which f, which is negative at `length`, becomes negative; 0 where it is negative from the start.
template <class Function>
double crossing(const Function& f, double length) {
  return f(0.) > 0. ? root(f, 0., length) : 0.;
}

/// The same where f(0) is zero up to round-off, and f may rise before it falls.
template <class Function>
double return_to_zero(const Function& f, double length) {
  constexpr int halvings = 24;
  for (int i = 0; i < halvings; ++i, length *= 0.5)
    if (f(0.5 * length) > 0.) return root(f, 0.5 * length, length);
  return 0.;
}

/// The event that the readings of one time show: N', and F_T of a phase that sticks or s' of one that slips.
SlipEvent event_at(ContactState contact, double friction, double watched, double normal) {
  switch (contact) {
    case ContactState::stick:
      return std::abs(watched) > friction * normal ? SlipEvent::starts : SlipEvent::none;
    case ContactState::open:
      return normal > 0. ? SlipEvent::lands : SlipEvent::none;
    default:
      if (normal < 0.) return SlipEvent::lifts;
      return direction(contact) * watched < 0. ? SlipEvent::stops : SlipEvent::none;
  }
}

/// The event that shows at the end of a path or at its start, and its time. `fresh`: the phase has begun with the
/// path, so that s', or |F_T| - mu N', is zero up to round-off.
TimedEvent first_event(const SlipPath& path, ContactState contact, double friction, bool fresh) {
  const double length = path.length();
  const SlipCurve normal = path.reading(row_normal), watched = path.reading(SlipSteps::watched_row(contact));
  const SlipEvent at_end = event_at(contact, friction, watched(length), normal(length));
  if (!fresh)  // loads may have jumped
    if (const SlipEvent at_once = event_at(contact, friction, watched(0.), normal(0.)); at_once != SlipEvent::none)
      return {at_once, 0.};
  if (contact == ContactState::stick || contact == ContactState::open) {
    const auto margin = [&](double t) {
      return contact == ContactState::stick ? friction * normal(t) - std::abs(watched(t)) : -normal(t);
    };
    return at_end == SlipEvent::none ? TimedEvent() : TimedEvent{at_end, crossing(margin, length)};
  }
  TimedEvent first;
  if (normal(length) < 0.) first = {SlipEvent::lifts, crossing(normal, length)};
  const auto speed = [&](double t) { return direction(contact) * watched(t); };
  if (speed(length) < 0.) {
    const double stop = fresh ? return_to_zero(speed, length) : crossing(speed, length);
    if (first.event == SlipEvent::none || stop < first.time) first = {SlipEvent::stops, stop};
  }
  return first;
}

/// A stretch of time on which all loads are straight.
struct LoadStretch {
  double length = 0.;  ///< s
  Eigen::VectorXd begin, end;
};

/// The motion of a caisson, its phase, and the results so far.
class CoupledRun {
 public:
  /// Starts from rest under N_0 = `normal` (N/m). Model and levels, each with half the step of the one before, must
  /// outlive the object.
  CoupledRun(const SlipModel& model, const std::vector<SlipLevel>& levels, double normal)
      : model_(model), levels_(levels), last_{0., normal, 0.} {
    result_.least_normal = normal;
    const Eigen::VectorXd at_rest = Eigen::VectorXd::Zero(phase().from_state.cols());
    z_ = next_ = modal_state(phase(), at_rest);
  }

  /// Moves through a stretch; `is_step`: it is as long as the longest steps. `jumps`: the loads jump at its
  /// beginning.
  void pass(const LoadStretch& stretch, bool is_step, bool jumps) {
    if (++n_stretches_ % stretches_between_drops == 0) flush_denormals(z_);
    if (jumps) {
      last_ = reading_now(stretch.begin);
      const double watched = stuck() ? last_.shear : last_.velocity;
      const SlipEvent at_once = event_at(contact_, model_.friction, watched, last_.normal);
      if (at_once != SlipEvent::none) change(at_once, stretch.begin);
    }
    if (is_step)
      pass_step(stretch, 0);
    else
      pass_rest(stretch, 0);
  }

  bool stuck() const { return contact_ == ContactState::stick; }
  /// Records the readings of the present time under these loads.
  void record(const Eigen::VectorXd& load, Eigen::Index column, CoupledHistory& history) const {
    history.shear[column] = last_.shear;
    history.normal[column] = last_.normal;
    history.velocity[column] = last_.velocity;
    history.slip[column] = slip_;
    for (Eigen::Index i = 0; i < history.outputs.rows(); ++i)
      history.outputs(i, column) =
          read(z_, first_row_wanted + static_cast<int>(i), load) + model_.share_of_slip[i] * slip_;
  }
  /// The results; a slip that has not ended counts.
  CoupledSliding result() const {
    CoupledSliding result = result_;
    result.slip.residual = slip_;
    return result;
  }

 private:
  /// Readings at one time.
  struct Reading {
    double shear = 0., normal = 0., velocity = 0.;
  };

  const SlipPhase& phase() const { return model_.phase(contact_); }
  const SlipSteps& steps(std::size_t level) const { return levels_[level].steps[static_cast<std::size_t>(contact_)]; }
  std::size_t finest() const { return levels_.size() - 1; }
  double read(const ModalState& z, int row, const Eigen::VectorXd& load) const {
    const Eigen::Index M = phase().modes.n_modes();
    const auto weights = phase().modes.reading.row(row);
    return phase().modes.feedthrough.row(row).dot(load) + weights.real().dot(z.re.head(M).matrix()) -
           weights.imag().dot(z.im.head(M).matrix());
  }
  Reading reading(double watched, double normal) const {
    if (stuck()) return {watched, normal, 0.};
    return {direction(contact_) * model_.friction * normal, normal, watched};
  }
  Reading reading_now(const Eigen::VectorXd& load) const {
    return reading(read(z_, SlipSteps::watched_row(contact_), load), read(z_, row_normal, load));
  }
  /// Moves through one step of a level.
  void pass_step(const LoadStretch& stretch, std::size_t level) {
    const SlipStep step = steps(level).advance(z_, stretch.begin, stretch.end, next_);
    const Reading now = reading(step.watched, step.normal);
    const SlipWithin within = stuck() ? SlipWithin() : steps(level).within(z_, next_, stretch.begin, stretch.end);
    if (is_quiet(within, stretch.length, now, level)) {
      result_.available += within.work;
      std::swap(z_, next_);
      return advance(stretch.length, now, within.distance);
    }
    if (stuck() || level == finest()) return follow(stretch, level);
    const Eigen::VectorXd middle = 0.5 * (stretch.begin + stretch.end);
    pass_step({0.5 * stretch.length, stretch.begin, middle}, level + 1);
    pass_step({0.5 * stretch.length, middle, stretch.end}, level + 1);
  }
  /// Moves through a stretch of any length in the longest steps that fit, from a level on.
  void pass_rest(LoadStretch rest, std::size_t level) {
    const Eigen::VectorXd slope = (rest.end - rest.begin) / rest.length;
    while (level < levels_.size()) {
      const double length = levels_[level].length;
      if (rest.length < length * (1. - 1e-12)) {
        ++level;
        continue;
      }
      const Eigen::VectorXd begin = rest.begin;
      rest.begin += length * slope;
      rest.length -= length;
      pass_step({length, begin, rest.begin}, level);
    }
    if (rest.length > 1e-12 * levels_.back().length) follow(rest, finest());
  }
  /// Whether no change of phase can occur in a step. Adds to `uncertain` what the bends within the step make
  /// uncertain.
  bool is_quiet(const SlipWithin& within, double length, const Reading& end, std::size_t level) {
    if (stuck()) return event_at(contact_, model_.friction, end.shear, end.normal) == SlipEvent::none;
    const double way = direction(contact_), sign = way == 0. ? -1. : 1.;
    const double speed = std::max(std::abs(last_.velocity), std::abs(end.velocity));
    const double of_normal = within.normal.slow + within.normal.fast,
                 of_speed = within.velocity.slow + within.velocity.fast;
    const double shear = std::max(std::abs(last_.shear), std::abs(end.shear));
    const double uncertain = length * (std::abs(way) * model_.friction * of_normal * (speed + of_speed) +
                                       0.5 * std::abs(end.shear - last_.shear) * of_speed);
    if (level < finest()) {
      if (!within.normal.stays_positive(sign * last_.normal, sign * end.normal)) return false;
      if (way != 0. && !within.velocity.stays_positive(way * last_.velocity, way * end.velocity)) return false;
      if (uncertain > tolerable * length * shear * speed) return false;
    } else if (event_at(contact_, model_.friction, end.velocity, end.normal) != SlipEvent::none) {
      return false;
    }
    result_.uncertain += uncertain + within.work_error;
    return true;
  }
  /// Moves through a stretch no longer than a step of a level, from one change of phase to the next.
  void follow(LoadStretch stretch, std::size_t level) {
    const Eigen::VectorXd slope = (stretch.end - stretch.begin) / stretch.length;
    for (int changes = 0;; ++changes) {
      const SlipPath path(phase(), z_, stretch.begin, slope, stretch.length);
      TimedEvent found;
      if (changes < most_changes)
        found = first_event(path, contact_, model_.friction, fresh_);
      else
        ++result_.n_passed_over;
      const double passed = found.event == SlipEvent::none ? stretch.length : found.time;
      SlipPath::Place place = path.at(passed);
      const Eigen::VectorXd begin = stretch.begin;
      stretch.begin += passed * slope;
      stretch.length -= passed;
      if (!stuck()) result_.available += steps(level).work_of_piece(z_, place.z, begin, stretch.begin, passed);
      z_ = std::move(place.z);
      advance(passed, reading_now(stretch.begin), stuck() ? 0. : place.distance);
      if (found.event == SlipEvent::none) return;
      change(found.event, stretch.begin);
      if (!(stretch.length > 0.)) return;
      if (level < finest()) return pass_rest(stretch, level + 1);
    }
  }
  /// Adds a step to the results: F_T and s' count as straight over the step, but the distance is exact.
  void advance(double length, const Reading& now, double moved) {
    time_ += length;
    slip_ += moved;
    if (length > 0.) fresh_ = false;
    if (slipping_) {
      now_.distance += moved;
      if (std::abs(now.velocity) > std::abs(now_.peak_velocity)) now_.peak_velocity = now.velocity;
      if (std::abs(slip_) > std::abs(result_.slip.largest)) result_.slip.largest = slip_;
      result_.dissipated += 0.5 * (last_.shear + now.shear) * moved +
                            length / 12. * (now.shear - last_.shear) * (now.velocity - last_.velocity);
      const double impulse = 0.5 * length * (last_.normal + now.normal);
      (impulse > 0. ? result_.pressed : result_.pulled) += std::abs(impulse);
    }
    if (contact_ == ContactState::open) result_.lifted_time += length;
    if (std::abs(now.shear) > std::abs(result_.peak_shear)) result_.peak_shear = now.shear;
    result_.least_normal = std::min(result_.least_normal, now.normal);
    last_ = now;
  }
  void change(SlipEvent event, const Eigen::VectorXd& load) {
    if (++result_.n_changes > most_in_all)
      throw NumericsError("the caisson would stick, slip and lift more than " + std::to_string(most_in_all) +
                          " times: friction feeds a vibration of the ground");
    Eigen::VectorXd state = energy_state(phase(), z_);
    switch (event) {
      case SlipEvent::starts:
        begin_slip(state);
        return enter(last_.shear > 0. ? ContactState::slip_landward : ContactState::slip_seaward, state, load);
      case SlipEvent::stops:
        state[state.size() - 1] = 0.;
        return rest(state, load);
      case SlipEvent::lifts:
        return enter(ContactState::open, state, load);
      default:
        if (last_.velocity == 0.) return rest(state, load);
        return enter(last_.velocity > 0. ? ContactState::slip_landward : ContactState::slip_seaward, state, load);
    }
  }
  /// After s' = 0: the caisson sticks, or slips the way it is pushed.
  void rest(const Eigen::VectorXd& state, const Eigen::VectorXd& load) {
    enter(ContactState::stick, state, load);
    if (event_at(ContactState::stick, model_.friction, last_.shear, last_.normal) == SlipEvent::none)
      return end_slip(state);
    enter(last_.shear > 0. ? ContactState::slip_landward : ContactState::slip_seaward, state, load);
  }
  void enter(ContactState contact, const Eigen::VectorXd& state, const Eigen::VectorXd& load) {
    contact_ = contact;
    z_ = modal_state(phase(), state);
    next_ = z_;
    last_ = reading_now(load);
    fresh_ = true;
    const double way = direction(contact);
    if (way == 0.) return;
    if (way_ * way < 0.) {  // it turns without sticking in between
      end_slip(state);
      begin_slip(state);
    }
    way_ = way;
  }
  void begin_slip(const Eigen::VectorXd& state) {
    slipping_ = true;
    way_ = 0.;
    now_ = {time_, time_, 0., 0.};
    energy_ = 0.5 * state.squaredNorm();
  }
  void end_slip(const Eigen::VectorXd& state) {
    slipping_ = false;
    way_ = 0.;
    now_.stop = time_;
    result_.available += energy_ - 0.5 * state.squaredNorm();
    if (now_.distance == 0.) return;
    result_.slip.path += std::abs(now_.distance);
    result_.slip.slips.push_back(now_);
  }

  const SlipModel& model_;
  const std::vector<SlipLevel>& levels_;
  ContactState contact_ = ContactState::stick;
  ModalState z_, next_;
  int n_stretches_ = 0;
  bool fresh_ = false;  ///< the phase has just begun
  Reading last_;
  double time_ = 0.;
  double slip_ = 0.;  ///< s
  bool slipping_ = false;
  double way_ = 0.;  ///< direction of the present slip: 1 forward, -1 backward, 0 not known yet
  Slip now_;
  double energy_ = 0.;  ///< stored when the present slip began (J/m)
  CoupledSliding result_;
};

template <class Make>
auto of_all_phases(const Make& make) {
  return std::array{make(ContactState::stick), make(ContactState::slip_landward), make(ContactState::slip_seaward),
                    make(ContactState::open)};
}

/// The highest frequency of any phase (rad/s).
double fastest(const SlipModel& model) {
  double omega = 0.;
  for (const SlipPhase& phase : model.phases)
    if (phase.modes.n_modes() > 0) omega = std::max(omega, phase.modes.pole.imag().maxCoeff());
  return omega;
}

/// Levels whose step is half that of the level before, down to a radian of the fastest oscillation.
std::vector<SlipLevel> levels_of(const SlipModel& model, double step) {
  const Eigen::MatrixXd rows = load_rows(model);
  const double halvings = std::clamp(std::ceil(std::log2(fastest(model) * step)), 0., most_halvings);
  std::vector<SlipLevel> levels;
  for (int i = 0; i <= static_cast<int>(halvings); ++i, step *= 0.5)
    levels.push_back({step, of_all_phases([&](ContactState s) { return SlipSteps(model.phase(s), s, rows, step); })});
  return levels;
}

/// Prepares a history of n times, at rest at the first.
void prepare(const SlipModel& model, Eigen::Index n, double normal, CoupledHistory& history) {
  for (Eigen::RowVectorXd* row : {&history.shear, &history.normal, &history.velocity, &history.slip}) row->setZero(n);
  history.outputs.setZero(model.share_of_slip.size(), n);
  history.normal[0] = normal;
}

/// Follows a slip that has not ended until it stops.
void come_to_rest(CoupledRun& run, const Eigen::VectorXd& load, double step, Eigen::Index n_steps) {
  const auto most = static_cast<Eigen::Index>(longest_tail * static_cast<double>(n_steps)) + 1;
  for (Eigen::Index n = 0; n < most && !run.stuck(); ++n) run.pass({step, load, load}, true, false);
  if (!run.stuck()) throw NumericsError("the loads at the end of a wave never let the caisson come to rest");
}

void require(bool fits) {
  if (!fits) throw std::invalid_argument("a wave's loads do not fit the slip model, N_0 with them, or their times");
}

}  // namespace

std::string why_no_distance(const CoupledSliding& s) {
  if (!std::isfinite(s.slip.residual + s.slip.largest + s.dissipated + s.available + s.peak_shear + s.least_normal))
    return "its motion grows beyond all numbers";
  if (s.n_passed_over > 0)
    return "the caisson sticks, slips and lifts too fast to be followed (" + std::to_string(s.n_passed_over) +
           " times)";
  if (s.dissipated > s.available + s.uncertain + round_off * std::abs(s.available) || s.dissipated < -s.uncertain)
    return "friction would take " + significant(s.dissipated) + " J/m" + " of " + significant(s.available) + " J/m" +
           " that the loads and the ground have given: its energies do not balance";
  if (s.pulled > tolerable_pull * s.pressed)
    return "N' falls to " + significant(s.least_normal) + " N/m" + " and is below zero for " +
           significant(s.lifted_time) +
           " s in all: the bottom would part from the ground, which here pulls at it with " +
           significant(100. * s.pulled / std::max(s.pressed, 1e-300)) +
           " % of the impulse that it presses with; contact node by node computes what happens then (kind = "
           "\"friction\")";
  return "";
}

std::string why_no_distance(const CoupledSliding& s, const CoupledSliding& more) {
  constexpr double tolerable_effect = 0.01;
  const double effect = std::abs(s.slip.residual - more.slip.residual);
  if (effect <= tolerable_effect * s.slip.path) return "";
  return "friction feeds vibrations of the ground, and the damping that keeps them small decides on S: twice as much "
         "of it moves S by " +
         significant(effect) + " m; give the ground its damping";
}

CoupledSlip::CoupledSlip(SlipModel model, double step)
    : model_(std::move(model)), step_(step), levels_(levels_of(model_, step)) {}

CoupledSliding CoupledSlip::slide(const Eigen::Ref<const WaveSamples>& loads, CoupledHistory* history) const {
  require(loads.cols() > 1);
  const Eigen::Index n = loads.cols() - 1;
  SampledLoads sampled{std::vector<double>(static_cast<std::size_t>(n + 1)), loads.leftCols(n), loads.rightCols(n)};
  for (std::size_t i = 0; i < sampled.time.size(); ++i) sampled.time[i] = static_cast<double>(i) * step_;
  return slide(sampled, history);
}

CoupledSliding CoupledSlip::slide(const SampledLoads& loads, CoupledHistory* history) const {
  const auto n = static_cast<Eigen::Index>(loads.time.size()) - 1;
  const auto fits = [&](const Eigen::MatrixXd& f) { return f.rows() == model_.n_loads() && f.cols() == n; };
  require(n > 0 && fits(loads.begin) && fits(loads.end));
  const double normal = loads.begin(loads.begin.rows() - 1, 0);
  CoupledRun run(model_, levels_, normal);
  if (history) prepare(model_, n + 1, normal, *history);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double length = loads.time[i + 1] - loads.time[i];
    const bool is_step = std::abs(length - step_) <= 1e-12 * loads.time[i + 1];
    const bool jumps = i == 0 || loads.begin.col(i) != loads.end.col(i - 1);
    run.pass({is_step ? step_ : length, loads.begin.col(i), loads.end.col(i)}, is_step, jumps);
    if (history) run.record(loads.end.col(i), i + 1, *history);
  }
  come_to_rest(run, loads.end.col(n - 1), step_, n);
  return run.result();
}

}  // namespace upbead
