#include "respond_slip.h"

#include "joined_loads.h"
#include "response/slip_law.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

SlipModel joined_model(const ReducedModelFile& model, const ModelSliding& sliding, double damping_time) {
  const SlipUplift uplift = sliding.uplift == "computed" ? SlipUplift::computed : SlipUplift::none;
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

/// Jumps to zero loads at the end, and goes on for a step.
void append_rest(SampledLoads& loads, double step, double buoyant_weight) {
  const Eigen::Index n = loads.begin.cols();
  loads.time.push_back(loads.time.back() + step);
  for (Eigen::MatrixXd* part : {&loads.begin, &loads.end}) {
    part->conservativeResize(Eigen::NoChange, n + 1);
    part->col(n).setZero();
    (*part)(part->rows() - 1, n) = buoyant_weight;
  }
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

namespace {

CoupledSliding slide(const CoupledSlip& slip, const WaveSamples& loads, const WaveGrid& grid, bool batch,
                     double buoyant_weight, const Eigen::RowVectorXd& prescribed) {
  const Eigen::Index K = loads.rows(), N = loads.cols();
  Eigen::RowVectorXd normal = Eigen::RowVectorXd::Constant(N, buoyant_weight);
  if (prescribed.size() > 0) normal -= prescribed;
  if (batch) {
    WaveSamples all = WaveSamples::Zero(K + 1, N + 1);
    all.topLeftCorner(K, N) = loads;
    all.row(K) << normal, buoyant_weight;
    return slip.slide(all);
  }
  SampledLoads all = with_jumps(loads, grid);
  all.begin.conservativeResize(K + 1, Eigen::NoChange);
  all.end.conservativeResize(K + 1, Eigen::NoChange);
  all.begin.row(K) = normal.head(N - 1);
  all.end.row(K) = normal.tail(N - 1);
  append_rest(all, slip.step(), buoyant_weight);
  return slip.slide(all);
}

}  // namespace

SlipOfWave slip_of_wave(const WaveSlip& slip, const WaveSamples& loads, const WaveGrid& grid, bool batch,
                        double buoyant_weight, const Eigen::RowVectorXd& prescribed) try {
  const auto slid_by = [&](const CoupledSlip& model) {
    return slide(model, loads, grid, batch, buoyant_weight, prescribed);
  };
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
