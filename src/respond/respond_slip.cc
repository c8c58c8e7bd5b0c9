#include "respond/respond_slip.h"

#include <algorithm>

#include "response/slip_law.h"
#include "upbead/base/error.h"
#include "upbead/sliding/block.h"

namespace upbead {

bool pushes_seaward_alone(const Eigen::RowVectorXd& P) {
  return pushes_seaward_alone(P.maxCoeff(), P.minCoeff());
}

Eigen::RowVectorXd uplift_of_force(const ModelSliding& sliding, const std::vector<double>& time,
                                   const Eigen::RowVectorXd& force) {
  const Eigen::RowVectorXd P = pushes_seaward_alone(force) ? Eigen::RowVectorXd(-force) : force;
  Eigen::Index largest = 0;
  const double peak = std::max(P.maxCoeff(&largest), 0.);
  const double peak_time = time[static_cast<std::size_t>(largest)];
  Eigen::RowVectorXd U(P.size());
  for (Eigen::Index i = 0; i < P.size(); ++i) {
    const double t = time[static_cast<std::size_t>(i)] - sliding.lag;
    const double then = sliding.lag > 0. ? (t < time.front() ? 0. : value_at(time, P, t)) : P[i];
    const bool over = sliding.uplift == "held" && t > peak_time;
    U[i] = sliding.uplift_per_force * (over ? peak : std::max(then, 0.));
  }
  return U;
}

namespace {

/// W' less the uplift after the wave: one that is held stays, unless it lifts the caisson, which slides_on tells.
double normal_after(const ModelSliding& sliding, const Eigen::RowVectorXd& U) {
  const double weight = sliding.submerged_weight;
  const bool stays = sliding.uplift == "held" && U.size() > 0 && U[U.size() - 1] < weight;
  return weight - (stays ? U[U.size() - 1] : 0.);
}

}  // namespace

double sliding_distance(const ModelSliding& sliding, double mass, const std::vector<double>& time,
                        const Eigen::RowVectorXd& shear, const Eigen::RowVectorXd& U) {
  const Eigen::RowVectorXd F_T = shear.array() + sliding.push;
  Eigen::RowVectorXd R = Eigen::RowVectorXd::Constant(F_T.size(), sliding.submerged_weight);
  if (U.size() > 0) R = (R - U).cwiseMax(0.);
  R *= sliding.friction;
  // the caisson rests until F_T first exceeds R; skipping that time saves the work for most waves
  Eigen::Index start = 0;
  while (start < F_T.size() && std::abs(F_T[start]) <= R[start]) ++start;
  if (start == F_T.size()) return 0.;
  const auto rest = std::max<Eigen::Index>(start - 1, 0);
  const std::vector<double> left(time.begin() + rest, time.end());
  History resistance{left, {R.begin() + rest, R.end()}};
  resistance.time.push_back(left.back());
  resistance.value.push_back(sliding.friction * normal_after(sliding, U));
  return slide(mass, {left, {F_T.begin() + rest, F_T.end()}}, resistance, sliding.drag).residual;
}

namespace {

SlipModel joined_model(const ReducedModelFile& model, const ModelSliding& sliding, double damping_time) {
  const UpliftKind uplift = sliding.uplift == "computed" ? UpliftKind::computed : UpliftKind::prescribed;
  const ReducedSystem& system = model.slip->system;
  SlipModel slip = slip_model(system, slip_law(system, sliding.friction, uplift), damping_time);
  for (SlipPhase& phase : slip.phases) {
    join_pore_pressures(phase.modes);
    std::vector<std::string> names = phase.modes.load_name;
    names.pop_back();  // N_0
    if (names != model.modes.load_name)
      throw InputError(Place(), "the part /slip of the model has other loads than the model",
                       "make it again with 'upbead reduce'");
  }
  return slip;
}

/// Lets the loads jump to zero at the end, and adds a step of rest.
SampledLoads with_rest(SampledLoads loads, double step, double normal) {
  const Eigen::Index n = loads.begin.cols();
  loads.time.push_back(loads.time.back() + step);
  for (Eigen::MatrixXd* part : {&loads.begin, &loads.end}) {
    part->conservativeResize(Eigen::NoChange, n + 1);
    part->col(n).setZero();
    (*part)(part->rows() - 1, n) = normal;
  }
  return loads;
}

CoupledSliding slide(const CoupledSlip& slip, const WaveSamples& loads, const WaveGrid& grid, bool batch,
                     const ModelSliding& sliding, const Eigen::RowVectorXd& prescribed) {
  const Eigen::Index K = loads.rows(), N = loads.cols();
  const double after = normal_after(sliding, prescribed);
  Eigen::RowVectorXd normal = Eigen::RowVectorXd::Constant(N, sliding.submerged_weight);
  if (prescribed.size() > 0) normal -= prescribed;
  if (batch) {
    WaveSamples all = WaveSamples::Zero(K + 1, N + 1);
    all.topLeftCorner(K, N) = loads;
    all.row(K) << normal, after;
    return slip.slide(all);
  }
  return slip.slide(with_rest(with_load(with_jumps(loads, grid), normal), slip.step(), after));
}

}  // namespace

WaveSlips::WaveSlips(const ReducedModelFile& model, const ModelSliding& sliding)
    : model_(joined_model(model, sliding, 0.)) {
  if (model_.damping_time > 0.) more_damped_ = joined_model(model, sliding, 2. * model_.damping_time);
}

std::shared_ptr<const WaveSlip> WaveSlips::of_step(double step) {
  std::shared_ptr<const WaveSlip>& slip = made_[step];
  if (slip) return slip;
  std::optional<CoupledSlip> more;
  if (more_damped_) more.emplace(*more_damped_, step);
  slip = std::make_shared<const WaveSlip>(WaveSlip{CoupledSlip(model_, step), std::move(more)});
  return slip;
}

SlipOfWave slip_of_wave(const WaveSlip& slip, const WaveSamples& loads, const WaveGrid& grid, bool batch,
                        const ModelSliding& sliding, const Eigen::RowVectorXd& prescribed) try {
  const auto slid_by = [&](const CoupledSlip& model) { return slide(model, loads, grid, batch, sliding, prescribed); };
  const CoupledSliding slid = slid_by(slip.slip);
  std::string why_not = why_no_distance(slid);
  if (why_not.empty() && slip.more_damped && slid.slip.path > 0.)
    why_not = why_no_distance(slid, slid_by(*slip.more_damped));
  if (!why_not.empty()) return {std::nullopt, why_not};
  return {CoupledWave{slid.slip.residual, slid.slip.largest, static_cast<int>(slid.slip.slips.size()), slid.dissipated,
                      slid.lifted_time},
          ""};
} catch (const NumericsError& error) {
  return {std::nullopt, error.what()};
}

}  // namespace upbead
