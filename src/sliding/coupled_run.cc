#include "coupled_run.h"

#include <cmath>

namespace upbead::detail {

namespace {

/// Changes of phase that are followed within one stretch.
constexpr int most_changes = 12;
constexpr int stretches_between_drops = 64;

}  // namespace

CoupledRun::CoupledRun(const SlipModel& model, const std::array<SlipSteps, 4>& steps, double normal)
    : model_(model), steps_(steps), last_{0., normal, 0.} {
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
  if (is_step && !jumps) {
    const SlipStep step = steps().advance(z_, stretch.begin, stretch.end, next_);
    if (event_at(contact_, model_.friction, step.watched, step.normal) == SlipEvent::none) {
      std::swap(z_, next_);
      advance(stretch.length, reading(step.watched, step.normal), stuck() ? 0. : step.distance);
      return;
    }
  }
  follow(stretch);
}

void CoupledRun::follow(LoadStretch stretch) {
  const Eigen::VectorXd slope = (stretch.end - stretch.begin) / stretch.length;
  bool fresh = false;
  for (int changes = 0;; ++changes) {
    const SlipPath path(phase(), z_, stretch.begin, slope, stretch.length);
    TimedEvent found;
    if (changes < most_changes)
      found = first_event(path, contact_, model_.friction, fresh);
    else
      ++result_.n_passed_over;
    const double passed = found.event == SlipEvent::none ? stretch.length : found.time;
    SlipPath::Place place = path.at(passed);
    z_ = std::move(place.z);
    stretch.begin += passed * slope;
    stretch.length -= passed;
    advance(passed, reading_now(stretch.begin), stuck() ? 0. : place.distance);
    if (found.event == SlipEvent::none) return;
    change(found.event, stretch.begin);
    ++result_.n_changes;
    if (!(stretch.length > 0.)) return;
    fresh = true;
  }
}

/// Straight lines of F_T and s' over the step, but for the exact distance.
void CoupledRun::advance(double length, const Reading& now, double moved) {
  time_ += length;
  slip_ += moved;
  if (slipping_) {
    now_.distance += moved;
    if (std::abs(now.velocity) > std::abs(now_.peak_velocity)) now_.peak_velocity = now.velocity;
    if (std::abs(slip_) > std::abs(result_.slip.largest)) result_.slip.largest = slip_;
    result_.dissipated += 0.5 * (last_.shear + now.shear) * moved +
                          length / 12. * (now.shear - last_.shear) * (now.velocity - last_.velocity);
  }
  if (contact_ == BottomState::lifted) result_.lifted_time += length;
  if (std::abs(now.shear) > std::abs(result_.peak_shear)) result_.peak_shear = now.shear;
  result_.least_normal = std::min(result_.least_normal, now.normal);
  last_ = now;
}

void CoupledRun::change(SlipEvent event, const Eigen::VectorXd& load) {
  Eigen::VectorXd state = energy_state(phase(), z_);
  switch (event) {
    case SlipEvent::starts:
      begin_slip();
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
  if (event_at(BottomState::stuck, model_.friction, last_.shear, last_.normal) == SlipEvent::none) return end_slip();
  enter(last_.shear > 0. ? BottomState::forward : BottomState::backward, state, load);
}

void CoupledRun::enter(BottomState contact, const Eigen::VectorXd& state, const Eigen::VectorXd& load) {
  contact_ = contact;
  z_ = modal_state(phase(), state);
  next_ = z_;
  last_ = reading_now(load);
  const double way = direction(contact);
  if (way == 0.) return;
  if (way_ * way < 0.) {  // a turn without rest
    end_slip();
    begin_slip();
  }
  way_ = way;
}

void CoupledRun::begin_slip() {
  slipping_ = true;
  way_ = 0.;
  now_ = {time_, time_, 0., 0.};
}

void CoupledRun::end_slip() {
  slipping_ = false;
  way_ = 0.;
  now_.stop = time_;
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
