#include "sliding/coupled_slip.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "base/text.h"
#include "coupled_run.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

using detail::CoupledRun;

/// A slip may last so many times as long as the wave's samples.
constexpr double longest_tail = 10.;

/// Of a step, as often as it may be halved.
constexpr double most_halvings = 12.;
/// Of the friction, that would be lacking without the pull of the ground.
constexpr double tolerable_pull = 0.01;
/// Of the energy, that is round-off of the modes.
constexpr double round_off = 1e-6;

template <class Make>
auto of_all_phases(const Make& make) {
  return std::array{make(BottomState::stuck), make(BottomState::forward), make(BottomState::backward),
                    make(BottomState::lifted)};
}

/// The fastest oscillation of any phase (rad/s).
double fastest(const SlipModel& model) {
  double omega = 0.;
  for (const SlipPhase& phase : model.phases)
    if (phase.modes.n_modes() > 0) omega = std::max(omega, phase.modes.pole.imag().maxCoeff());
  return omega;
}

/// Each half of the last, down to a radian of the fastest oscillation.
std::vector<SlipLevel> levels_of(const SlipModel& model, double step) {
  const Eigen::MatrixXd rows = load_rows(model);
  const double halvings = std::clamp(std::ceil(std::log2(fastest(model) * step)), 0., most_halvings);
  std::vector<SlipLevel> levels;
  for (int i = 0; i <= static_cast<int>(halvings); ++i, step *= 0.5)
    levels.push_back({step, of_all_phases([&](BottomState s) { return SlipSteps(model.phase(s), s, step); }),
                      of_all_phases([&](BottomState s) { return SlipWithinStep(model.phase(s), rows, step); })});
  return levels;
}

/// A history of n times, at rest at the first.
void prepare(const SlipModel& model, Eigen::Index n, double normal, CoupledHistory& history) {
  for (Eigen::RowVectorXd* row : {&history.shear, &history.normal, &history.velocity, &history.slip}) row->setZero(n);
  history.wanted.setZero(model.share_of_slip.size(), n);
  history.normal[0] = normal;
}

/// Follows the slip that is under way to its stop.
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
           " % of the impulse that it presses with; contact node by node tells what happens then (kind = \"friction\")";
  return "";
}

std::string why_no_distance(const CoupledSliding& s, const CoupledSliding& more) {
  constexpr double tolerable_effect = 0.01;
  const double effect = std::abs(s.slip.residual - more.slip.residual);
  if (effect <= tolerable_effect * s.slip.path) return "";
  return "friction feeds vibrations of the ground, and the damping that keeps them small decides on S: twice as much "
         "of "
         "it moves S by " +
         significant(effect) + " m; give the ground its damping";
}

CoupledSlip::CoupledSlip(SlipModel model, double step)
    : model_(std::move(model)), step_(step), levels_(levels_of(model_, step)) {}

CoupledSliding CoupledSlip::slide(const Eigen::Ref<const WaveSamples>& loads, CoupledHistory* history) const {
  require(loads.rows() == model_.n_loads() && loads.cols() > 0);
  const double normal = loads(loads.rows() - 1, 0);
  CoupledRun run(model_, levels_, normal);
  if (history) prepare(model_, loads.cols(), normal, *history);
  detail::LoadStretch stretch{step_, loads.col(0), loads.col(0)};
  for (Eigen::Index n = 1; n < loads.cols(); ++n) {
    stretch.begin.swap(stretch.end);
    stretch.end = loads.col(n);
    run.pass(stretch, true, n == 1);
    if (history) run.record(stretch.end, n, *history);
  }
  come_to_rest(run, stretch.end, step_, loads.cols());
  return run.result();
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
    run.pass({length, loads.begin.col(i), loads.end.col(i)}, is_step, jumps);
    if (history) run.record(loads.end.col(i), i + 1, *history);
  }
  come_to_rest(run, loads.end.col(n - 1), step_, n);
  return run.result();
}

}  // namespace upbead
