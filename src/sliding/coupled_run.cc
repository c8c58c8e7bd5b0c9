#include "coupled_run.h"

#include <cmath>

#include "upbead/base/error.h"

namespace upbead::detail {

namespace {

/// Changes of phase that are followed within one piece of the finest steps, and in all.
constexpr int most_changes = 12, most_in_all = 200000;
constexpr int stretches_between_drops = 64;
/// Of what friction takes in a step, that its bends may make wrong.
constexpr double tolerable = 0.01;

}  // namespace

CoupledRun::CoupledRun(const SlipModel& model, const std::vector<SlipLevel>& levels, double normal)
    : model_(model), levels_(levels), last_{0., normal, 0.} {
  result_.least_normal = normal;
  const Eigen::VectorXd at_rest = Eigen::VectorXd::Zero(phase().from_state.cols());
  z_ = next_ = modal_state(phase(), at_rest);
}

double CoupledRun::read(const ModalState& z, int row, const Eigen::VectorXd& load) const {
  const Eigen::Index M = phase().modes.n_modes();
  const auto weights = phase().modes.reading.row(row);
  return phase().modes.feedthrough.row(row).dot(load) + weights.real().dot(z.re.head(M).matrix()) -
         weights.imag().dot(z.im.head(M).matrix());
}

CoupledRun::Reading CoupledRun::reading(double watched, double normal) const {
  if (stuck()) return {watched, normal, 0.};
  return {direction(contact_) * model_.friction * normal, normal, watched};
}

CoupledRun::Reading CoupledRun::reading_now(const Eigen::VectorXd& load) const {
  return reading(read(z_, SlipSteps::watched_row(contact_), load), read(z_, row_normal, load));
}

void CoupledRun::pass(const LoadStretch& stretch, bool is_step, bool jumps) {
  if (++n_stretches_ % stretches_between_drops == 0) drop_what_is_gone(z_);
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

void CoupledRun::pass_step(const LoadStretch& stretch, std::size_t level) {
  const SlipStep step = levels_[level].steps[state()].advance(z_, stretch.begin, stretch.end, next_);
  const Reading now = reading(step.watched, step.normal);
  if (is_quiet(stretch, now, level)) {
    if (!stuck()) result_.available += levels_[level].within[state()].work(z_, next_, stretch.begin, stretch.end);
    std::swap(z_, next_);
    return advance(stretch.length, now, stuck() ? 0. : step.distance);
  }
  if (stuck() || level == finest()) return follow(stretch, level);
  const Eigen::VectorXd middle = 0.5 * (stretch.begin + stretch.end);
  pass_step({0.5 * stretch.length, stretch.begin, middle}, level + 1);
  pass_step({0.5 * stretch.length, middle, stretch.end}, level + 1);
}

void CoupledRun::pass_rest(LoadStretch rest, std::size_t level) {
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

bool CoupledRun::is_quiet(const LoadStretch& stretch, const Reading& end, std::size_t level) {
  if (stuck()) return event_at(contact_, model_.friction, end.shear, end.normal) == SlipEvent::none;
  const SlipBends bends = levels_[level].within[state()].bends(z_, stretch.begin, stretch.end);
  const double way = direction(contact_), sign = way == 0. ? -1. : 1.;
  const double speed = std::max(std::abs(last_.velocity), std::abs(end.velocity));
  const double of_normal = bends.normal.slow + bends.normal.fast, of_speed = bends.velocity.slow + bends.velocity.fast;
  const double shear = std::max(std::abs(last_.shear), std::abs(end.shear));
  const double uncertain = stretch.length * (std::abs(way) * model_.friction * of_normal * (speed + of_speed) +
                                             0.5 * std::abs(end.shear - last_.shear) * of_speed);
  if (level < finest()) {
    if (!bends.normal.stays_positive(sign * last_.normal, sign * end.normal)) return false;
    if (way != 0. && !bends.velocity.stays_positive(way * last_.velocity, way * end.velocity)) return false;
    if (uncertain > tolerable * stretch.length * shear * speed) return false;
  } else if (event_at(contact_, model_.friction, end.velocity, end.normal) != SlipEvent::none) {
    return false;
  }
  result_.uncertain += uncertain + bends.work;
  return true;
}

void CoupledRun::follow(LoadStretch stretch, std::size_t level) {
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
    if (!stuck())
      result_.available += levels_[level].within[state()].work_of_piece(z_, place.z, begin, stretch.begin, passed);
    z_ = std::move(place.z);
    advance(passed, reading_now(stretch.begin), stuck() ? 0. : place.distance);
    if (found.event == SlipEvent::none) return;
    change(found.event, stretch.begin);
    if (!(stretch.length > 0.)) return;
    if (level < finest()) return pass_rest(stretch, level + 1);
  }
}

/// Straight lines of F_T and s' over the step, but for the exact distance.
void CoupledRun::advance(double length, const Reading& now, double moved) {
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
  if (contact_ == BottomState::lifted) result_.lifted_time += length;
  if (std::abs(now.shear) > std::abs(result_.peak_shear)) result_.peak_shear = now.shear;
  result_.least_normal = std::min(result_.least_normal, now.normal);
  last_ = now;
}

void CoupledRun::change(SlipEvent event, const Eigen::VectorXd& load) {
  if (++result_.n_changes > most_in_all)
    throw NumericsError("the caisson would stick, slip and lift more than " + std::to_string(most_in_all) +
                        " times: friction feeds a vibration of the ground");
  Eigen::VectorXd state = energy_state(phase(), z_);
  switch (event) {
    case SlipEvent::starts:
      begin_slip(state);
      return enter(last_.shear > 0. ? BottomState::forward : BottomState::backward, state, load);
    case SlipEvent::stops:
      state[state.size() - 1] = 0.;
      return rest(state, load);
    case SlipEvent::lifts:
      return enter(BottomState::lifted, state, load);
    default:
      if (last_.velocity == 0.) return rest(state, load);
      return enter(last_.velocity > 0. ? BottomState::forward : BottomState::backward, state, load);
  }
}

void CoupledRun::rest(const Eigen::VectorXd& state, const Eigen::VectorXd& load) {
  enter(BottomState::stuck, state, load);
  if (event_at(BottomState::stuck, model_.friction, last_.shear, last_.normal) == SlipEvent::none)
    return end_slip(state);
  enter(last_.shear > 0. ? BottomState::forward : BottomState::backward, state, load);
}

void CoupledRun::enter(BottomState contact, const Eigen::VectorXd& state, const Eigen::VectorXd& load) {
  contact_ = contact;
  z_ = modal_state(phase(), state);
  next_ = z_;
  last_ = reading_now(load);
  fresh_ = true;
  const double way = direction(contact);
  if (way == 0.) return;
  if (way_ * way < 0.) {  // a turn without rest
    end_slip(state);
    begin_slip(state);
  }
  way_ = way;
}

void CoupledRun::begin_slip(const Eigen::VectorXd& state) {
  slipping_ = true;
  way_ = 0.;
  now_ = {time_, time_, 0., 0.};
  energy_ = 0.5 * state.squaredNorm();
}

void CoupledRun::end_slip(const Eigen::VectorXd& state) {
  slipping_ = false;
  way_ = 0.;
  now_.stop = time_;
  result_.available += energy_ - 0.5 * state.squaredNorm();
  if (now_.distance == 0.) return;
  result_.slip.path += std::abs(now_.distance);
  result_.slip.slips.push_back(now_);
}

void CoupledRun::record(const Eigen::VectorXd& load, Eigen::Index column, CoupledHistory& history) const {
  history.shear[column] = last_.shear;
  history.normal[column] = last_.normal;
  history.velocity[column] = last_.velocity;
  history.slip[column] = slip_;
  for (Eigen::Index i = 0; i < history.wanted.rows(); ++i)
    history.wanted(i, column) =
        read(z_, first_row_wanted + static_cast<int>(i), load) + model_.share_of_slip[i] * slip_;
}

CoupledSliding CoupledRun::result() const {
  CoupledSliding result = result_;
  result.slip.residual = slip_;
  return result;
}

}  // namespace upbead::detail
