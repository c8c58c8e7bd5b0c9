#include "upbead/sliding/coupled_slip.h"

#include <stdexcept>
#include <utility>

#include "coupled_run.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

using detail::CoupledRun;

/// A slip may last so many times as long as the wave's samples.
constexpr double longest_tail = 10.;

std::array<SlipSteps, 4> steps_of(const SlipModel& model, double step) {
  const auto of = [&](BottomState contact) { return SlipSteps(model.phase(contact), contact, step); };
  return {of(BottomState::stuck), of(BottomState::forward), of(BottomState::backward), of(BottomState::lifted)};
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

CoupledSlip::CoupledSlip(SlipModel model, double step)
    : model_(std::move(model)), step_(step), steps_(steps_of(model_, step)) {}

CoupledSliding CoupledSlip::slide(const Eigen::Ref<const WaveSamples>& loads, CoupledHistory* history) const {
  require(loads.rows() == model_.n_loads() && loads.cols() > 0);
  const double normal = loads(loads.rows() - 1, 0);
  CoupledRun run(model_, steps_, normal);
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
  CoupledRun run(model_, steps_, normal);
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
