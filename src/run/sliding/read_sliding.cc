#include "read_sliding.h"

#include <algorithm>
#include <cmath>

#include "../accuracy/slip_error.h"
#include "../derived.h"
#include "base/stopwatch.h"
#include "case_sliding.h"
#include "fem/caisson_readings.h"
#include "loose_scene.h"
#include "response/reduction.h"
#include "sliding/coupled_slip.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

/// Times of the response, four to each: a slip starts and ends between them.
std::vector<double> fine_times(const std::vector<double>& time) {
  constexpr int parts = 4;
  std::vector<double> fine{time.front()};
  for (std::size_t i = 1; i < time.size(); ++i)
    for (int j = 1; j <= parts; ++j)
      fine.push_back(j == parts ? time[i] : time[i - 1] + (time[i] - time[i - 1]) * j / parts);
  return fine;
}

/// The scene's loads, and W' less a prescribed uplift.
SampledLoads loads_of_slip(const Scene& scene, const CompiledScene& compiled) {
  std::vector<TimeFunction> histories;
  for (const SystemLoad& load : compiled.system.loads) histories.push_back(load.history);
  SampledLoads loads = sample(histories, fine_times(response_times(scene, compiled.system)));
  const Eigen::Index K = loads.begin.rows();
  for (Eigen::MatrixXd* part : {&loads.begin, &loads.end}) {
    part->conservativeResize(K + 1, Eigen::NoChange);
    part->row(K).setConstant(scene.sliding->buoyant_weight);
  }
  if (!scene.sliding->uplift || scene.sliding->uplift->kind != UpliftKind::prescribed) return loads;
  const TimeFunction U = prescribed_uplift(scene, compiled, loads.time);
  const SampledLoads uplift = sample({U}, loads.time);
  loads.begin.row(K) -= uplift.begin.row(0);
  loads.end.row(K) -= uplift.end.row(0);
  return loads;
}

CoupledHistoryTable table(const std::vector<double>& time, const CoupledHistory& history) {
  const auto list = [](const auto& row) { return std::vector<double>(row.begin(), row.end()); };
  return {time,
          list(history.shear),
          list(history.normal),
          list(history.velocity),
          list(history.slip),
          list(history.wanted.row(0))};
}

void require_none(const std::string& why_no_distance) {
  if (!why_no_distance.empty()) throw NumericsError(why_no_distance);
}

void slide(const Simulation& simulation, Run& run, const std::function<void(double)>& progress) {
  const SlidingChoice& choice = *simulation.scene.sliding;
  const CompiledScene loose = compile_loose(simulation);
  const SlipReduction reduction = reduce_loose(simulation.scene, loose, run.response.ends, progress);
  const SlipLaw law = slip_law(reduction.system, choice.friction, slip_uplift(choice), {reading::displacement_x});
  const SampledLoads loads = loads_of_slip(simulation.scene, loose);
  CoupledHistory history;
  const SlipModel model = slip_model(reduction.system, law);
  const double step = loads.time[1] - loads.time[0];
  const CoupledSliding slid = CoupledSlip(model, step).slide(loads, &history);
  require_none(why_no_distance(slid));
  double effect = 0.;
  if (model.damping_time > 0.) {
    const SlipModel more = slip_model(reduction.system, law, 2. * model.damping_time);
    const CoupledSliding other = CoupledSlip(more, step).slide(loads);
    require_none(why_no_distance(slid, other));
    effect = std::abs(other.slip.residual - slid.slip.residual);
  }
  run.summary.sliding->coupled = CoupledSummary{slid.slip,
                                                slid.dissipated,
                                                slid.peak_shear,
                                                slid.least_normal,
                                                slid.lifted_time,
                                                reduction.n_vectors,
                                                reduction.error.history,
                                                reduction.glued_error,
                                                model.growth,
                                                model.damping_time,
                                                effect,
                                                {}};
  run.coupled = table(loads.time, history);
}

}  // namespace

void read_sliding(const Simulation& simulation, Run& run, const std::function<void(double)>& progress) {
  run.summary.sliding = sliding_of(simulation.given, *simulation.compiled, run.response);
  run.coupled.reset();
  if (!run.summary.sliding) return;
  SlidingSummary& sliding = *run.summary.sliding;
  if (sliding.history.with_normal_force.slips.empty()) {
    const ShearResponse& response = *run.summary.response;
    sliding.coupled.emplace();
    sliding.coupled->peak_shear = std::max(response.peak_shear, -response.peak_shear_seaward);
    sliding.coupled->least_normal = sliding.history.least_normal_force;
    return;
  }
  sliding.why_not_coupled = why_no_slip(simulation);
  if (!sliding.why_not_coupled.empty()) return;
  const Stopwatch watch;
  try {
    slide(simulation, run, progress);
    run.summary.timing.march += watch.seconds();
  } catch (const NumericsError& error) {
    sliding.why_not_coupled = error.what();
    sliding.coupled_failed = true;
  }
}

Run with_sliding(const Run& run, const Scene& given, const std::function<void(double)>& progress) {
  Run other = run;
  const auto simulation = std::make_shared<const Simulation>(with_given(*run.simulation, given));
  check_sliding(*simulation);
  other.simulation = simulation;
  read_sliding(*simulation, other, progress);
  if (other.summary.error)
    estimate_slip_error(other);
  else
    tell_why_no_slip_error(other);
  return other;
}

NumberedWarnings slip_warnings(const SlidingSummary& sliding) {
  if (!sliding.coupled_failed) return {};
  return {{"no_coupled_slip", sliding.history.ratio, 1., "1",
           "the bonded caisson reaches its friction, but how far it slips as a whole on its ground is not told: " +
               sliding.why_not_coupled + "; sliding_history, and contact node by node (kind = \"friction\"), tell S"}};
}

std::vector<Skipped> skipped(const SlidingSummary& sliding) {
  const std::string what = "slip of the caisson with its ground";
  if (!sliding.why_not_coupled.empty()) return {{what, sliding.why_not_coupled}};
  if (sliding.coupled && sliding.coupled->vectors == 0)
    return {{what, "|F_T| stays below mu N' at all times: the glued caisson does not slip"}};
  return {};
}

}  // namespace upbead
