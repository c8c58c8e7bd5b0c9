#include "run/sliding/coupled_sliding.h"

#include <cmath>

#include "base/stopwatch.h"
#include "base/text.h"
#include "fem/caisson/readings.h"
#include "response/reduction.h"
#include "response/slip_law.h"
#include "response/slip_reduction.h"
#include "run/accuracy/accuracy.h"
#include "run/accuracy/side_by_side.h"
#include "run/derived.h"
#include "run/sliding/case_sliding.h"
#include "run/sliding/slip_ahead.h"
#include "sliding/coupled_slip.h"
#include "system/part.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

/// reduce_slip() of the scene with an interface, on one process, for the uplift of its [sliding]. Throws
/// NumericsError also where the model does not meet the tolerance.
SlipReduction reduce_sliding(const Simulation& simulation, SlipAhead* ahead, const Series& bonded,
                             const std::function<void(double)>& progress) {
  SlipReduction reduction = sliding_space(simulation, ahead)->reduce(bonded, progress);
  constexpr double tolerable = 0.02;  // error of forces: an undamped scene would need many vectors for less
  if (!reduction.converged && !(reduction.error.history <= tolerable))
    throw NumericsError("the forces of its reduced model are uncertain by " + percent(reduction.error.history) +
                        " of their peaks, where " + percent(tolerable) + " are tolerable");
  return reduction;
}

/// The times of the response, each interval in four parts: a slip starts and ends within an interval.
std::vector<double> fine_times(const std::vector<double>& time) {
  constexpr int parts = 4;
  std::vector<double> fine{time.front()};
  for (std::size_t i = 1; i < time.size(); ++i)
    for (int j = 1; j <= parts; ++j)
      fine.push_back(j == parts ? time[i] : time[i - 1] + (time[i] - time[i - 1]) * j / parts);
  return fine;
}

/// The scene's loads, and W' minus a prescribed uplift.
SampledLoads loads_of_slip(const Scene& scene, const CompiledScene& compiled) {
  const std::vector<double> time = fine_times(response_times(scene, compiled.system));
  const double weight = scene.sliding->submerged_weight;
  TimeFunction normal({}, {[weight](double) { return weight; }});
  if (scene.sliding->uplift && scene.sliding->uplift->kind == UpliftKind::prescribed)
    normal = sum(normal, scaled(sampled_uplift(scene, compiled, time), -1.));
  std::vector<TimeFunction> histories = load_histories(compiled.system);
  histories.push_back(normal);
  return sample(histories, time);
}

CoupledHistoryTable table(const std::vector<double>& time, const CoupledHistory& history) {
  const auto list = [](const auto& row) { return std::vector<double>(row.begin(), row.end()); };
  return {time,
          list(history.shear),
          list(history.normal),
          list(history.velocity),
          list(history.slip),
          list(history.outputs.row(0))};
}

void require_none(const std::string& why_no_distance) {
  if (!why_no_distance.empty()) throw NumericsError(why_no_distance);
}

ModelSlip model_slip(const Simulation& simulation, const Reduction& bonded,
                     const std::function<void(double)>& progress) {
  const Scene& s = simulation.scene();
  const Response response = respond(bonded, s, simulation.compiled()->system);
  SlipReduction reduction = reduce_sliding(simulation, nullptr, response.ends, progress);
  // whether slip is well posed must show here, and not only when waves are computed
  slip_model(reduction.system, slip_law(reduction.system, s.sliding->friction, slip_uplift(*s.sliding)));
  return {std::move(reduction.system), reduction.error.history, reduction.bonded_error, reduction.n_vectors,
          reduction.n_solves};
}

/// S by a model; throws NumericsError where the model gives no distance.
double slip_of(const Scene& scene, const ReducedSystem& system, const SampledLoads& loads) {
  const SlidingChoice& choice = *scene.sliding;
  const SlipModel model = slip_model(system, slip_law(system, choice.friction, slip_uplift(choice)));
  const CoupledSliding slid = CoupledSlip(model, loads.time[1] - loads.time[0]).slide(loads);
  require_none(why_no_distance(slid));
  return slid.slip.residual;
}

/// Cells half as large, with the basis of F_T on them where it was kept.
Simulation finer_than(const Simulation& simulation, const CellsCompared& cells) {
  return cells.finer ? *cells.finer : with_halved_cells(simulation, false);
}

}  // namespace

std::optional<SlipCompared> compare_slip(const Simulation& simulation, const CellsCompared& cells) {
  constexpr double enough = 0.1;  // of the tolerance
  const Series& bonded = cells.reduced->own.ends;
  Scene scene = simulation.scene();
  scene.tolerance = whole_tolerance(simulation);
  const SampledLoads loads = loads_of_slip(scene, *simulation.compiled());
  const auto slip = [&](const GrowingModel& model) { return slip_of(scene, model.system(), loads); };
  const auto read = [&](const GrowingModel& model) -> Answers { return {Eigen::VectorXd::Constant(1, slip(model))}; };
  const auto options = [&](const Simulation& on) {
    return slip_options(scene, *on.compiled(), slip_uplift(*scene.sliding), bonded);
  };
  const Layout among = layout_of(simulation.system());
  try {
    GrowingModel own(basis_for_slip(simulation), options(simulation));
    SlipCompared compared;
    {
      const Simulation finer = finer_than(simulation, cells);
      GrowingModel better(basis_for_slip(finer), options(finer));
      std::optional<GrowingModel> other;
      if (cells.coarse) other.emplace(basis_for_slip(*cells.coarse), options(*cells.coarse));
      const auto found = grow_side_by_side(other ? *other : own, better, read, enough * scene.tolerance, among);
      if (!found) return std::nullopt;
      compared.coarse = found->coarse[0][0];
      compared.finer = found->finer[0][0];
    }
    grow_to_its_end(own, among);
    compared.own = slip(own);
    return compared;
  } catch (const NumericsError&) {
    return std::nullopt;
  }
}

CoupledSummary slide_as_whole(const Simulation& simulation, SlipAhead* ahead, const Series& bonded,
                              const std::function<void(double)>& progress) {
  const Stopwatch watch;
  const SlidingChoice& choice = *simulation.scene().sliding;
  const SlipReduction reduction = reduce_sliding(simulation, ahead, bonded, progress);
  const SlipLaw law = slip_law(reduction.system, choice.friction, slip_uplift(choice), {reading::displacement_x});
  const SampledLoads loads = loads_of_slip(simulation.scene(), *simulation.compiled());
  CoupledHistory history;
  const SlipModel model = slip_model(reduction.system, law);
  const double step = loads.time[1] - loads.time[0];
  const CoupledSliding slid = CoupledSlip(model, step).slide(loads, &history);
  require_none(why_no_distance(slid));
  CoupledSummary out;
  if (model.damping_time > 0.) {
    const SlipModel more = slip_model(reduction.system, law, 2. * model.damping_time);
    const CoupledSliding other = CoupledSlip(more, step).slide(loads);
    require_none(why_no_distance(slid, other));
    out.damping_effect = std::abs(other.slip.residual - slid.slip.residual);
  }
  out.slip = slid.slip;
  out.dissipated = slid.dissipated;
  out.peak_shear = slid.peak_shear;
  out.least_normal = slid.least_normal;
  out.lifted_time = slid.lifted_time;
  out.vectors = reduction.n_vectors;
  out.error = reduction.error.history;
  out.glued_error = reduction.bonded_error;
  out.growth = model.growth;
  out.damping_time = model.damping_time;
  out.history = table(loads.time, history);
  out.seconds = watch.seconds();
  return out;
}

ReducedSlip reduce_with_slip(const Simulation& simulation, const Reduction& bonded,
                             const std::function<void(double)>& progress) {
  ReducedSlip slip;
  if (!simulation.scene().sliding) return slip;
  slip.why_not = why_no_slip(simulation);
  if (!slip.why_not.empty()) return slip;
  const Stopwatch watch;
  try {
    slip.model = model_slip(simulation, bonded, progress);
  } catch (const NumericsError& error) {
    slip.why_not = error.what();
  }
  slip.seconds = watch.seconds();
  return slip;
}

}  // namespace upbead
