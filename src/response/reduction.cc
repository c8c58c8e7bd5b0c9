#include "response/reduction.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/numbers.h"
#include "base/text.h"
#include "dynamics/basis.h"
#include "fem/caisson/readings.h"
#include "response/time_choice.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

constexpr double steps_per_duration = 32.;
/// The shift as a multiple of 2 pi / duration, measured in docs/reduced.md: high modes persist where nothing damps
/// them.
constexpr double shift_damped = 1.25, shift_undamped = 1.75;
constexpr double hardly_damped = 0.01;
/// Tolerance of all other readings as a multiple of F_T's: a march at its own step achieves 2 % damped, 9 % undamped.
constexpr double others_damped = 10., others_undamped = 20.;
constexpr int order = 4;  ///< of the interpolation inside steps, for exact values
constexpr double most_times = 1e6;

/// Whether every soil or solid that deforms has material damping.
bool is_damped(const Scene& scene) {
  return std::all_of(scene.regions.begin(), scene.regions.end(), [](const auto& entry) {
    const Region& region = entry.second;
    const bool deforms = region.kind == RegionKind::porous || region.kind == RegionKind::solid;
    return !deforms || (region.damping && region.damping->ratio > hardly_damped);
  });
}

/// Sorted in ascending order, without duplicates.
std::vector<double> in_order(std::vector<double> time, double end) {
  std::sort(time.begin(), time.end());
  const auto same = [end](double a, double b) { return b - a < 1e-9 * end; };
  time.erase(std::unique(time.begin(), time.end(), same), time.end());
  return time;
}

std::vector<double> times_of_steps(const Scene& scene, const System& system, double step) {
  const double end = scene.time.end;
  const TimeGrid grid = make_time_grid(kinks(system), end, std::min(step, end));
  std::vector<double> time{0.};
  for (const TimeSegment& segment : grid.segments)
    for (int i = 1; i <= segment.n_steps; ++i) time.push_back(segment.start + i * segment.step);
  for (const SystemLoad& load : system.loads)
    for (const double sample : load.history.samples())
      if (sample > 0. && sample < end) time.push_back(sample);
  return in_order(std::move(time), end);
}

/// Whether straight lines between the times reproduce the loads, within a thousandth of their largest values.
bool follow_loads(const std::vector<double>& time, const System& system) {
  constexpr double tolerable = 1e-3;
  for (const SystemLoad& load : system.loads) {
    double largest = 0., most = 0.;
    for (std::size_t n = 1; n < time.size(); ++n) {
      const double middle = 0.5 * (time[n - 1] + time[n]), there = load.history(middle, middle);
      largest = std::max(largest, std::abs(there));
      most =
          std::max(most, std::abs(there - 0.5 * (load.history(time[n - 1], middle) + load.history(time[n], middle))));
    }
    if (most > tolerable * largest) return false;
  }
  return true;
}

}  // namespace

std::vector<double> response_times(const Scene& scene, const System& system) {
  const double of_loads = step_of_loads(scene, order).duration / steps_per_duration;
  if (!scene.time.step) return times_of_steps(scene, system, of_loads);
  std::vector<double> given = times_of_steps(scene, system, *scene.time.step);
  if (*scene.time.step <= of_loads || follow_loads(given, system)) return given;
  if (const double n = estimated_steps(kinks(system).size(), scene.time.end, of_loads); n > most_times)
    throw NumericsError("the loads vary so fast that a reduced model must be read at about " + significant(n) +
                        " times until time.end = " + significant(scene.time.end) + " s, more than " +
                        significant(most_times) + ": a shorter time.end needs fewer");
  return times_of_steps(scene, system, of_loads);
}

SampledLoads sampled_loads(const Scene& scene, const System& system, const std::vector<double>& others) {
  std::vector<double> time = response_times(scene, system);
  time.insert(time.end(), others.begin(), others.end());
  return sample(load_histories(system), in_order(std::move(time), scene.time.end));
}

std::vector<Eigen::Index> looks_at(const std::vector<double>& time, double duration) {
  std::vector<Eigen::Index> looks;
  for (std::size_t i = 0; i < time.size(); ++i)
    if (looks.empty() || time[i] - time[static_cast<std::size_t>(looks.back())] > duration / 17.)
      looks.push_back(static_cast<Eigen::Index>(i));
  return looks;
}

double krylov_shift(const Scene& scene) {
  return (is_damped(scene) ? shift_damped : shift_undamped) * two_pi / step_of_loads(scene, order).duration;
}

ReduceOptions reduce_options(const Scene& scene, const CompiledScene& compiled, const ReductionTargets& targets) {
  const System& system = compiled.system;
  ReduceOptions options;
  const bool damped = is_damped(scene);
  options.shift = krylov_shift(scene);
  options.exact = compiled.body_coordinates;
  if (targets.balanced) options.kept = compiled.caisson_motions;
  options.training = sampled_loads(scene, system);
  options.tolerance = scene.tolerance;
  options.tolerance_of_others =
      (damped ? others_damped : others_undamped) * targets.tolerance_of_others.value_or(scene.tolerance);
  options.tolerance_of_states = options.tolerance_of_others;
  if (targets.only_shear) options.tolerance_of_others = infinity;
  options.each_load = targets.each_load;
  if (targets.most_vectors) options.max_vectors = *targets.most_vectors;
  if (targets.first_vectors) options.first_vectors = *targets.first_vectors;
  options.keep_pressures = targets.pressures;
  options.keep_states = targets.states;
  if (compiled.caisson) {
    options.measured = {system.reading(reading::shear_force)};
  } else {
    options.measured.resize(system.readings.size());
    std::iota(options.measured.begin(), options.measured.end(), 0);
  }
  return options;
}

Reduction reduce_scene(const Scene& scene, const CompiledScene& compiled, const ReductionTargets& targets,
                       const std::function<void(double)>& progress, BasisRoom* room) {
  ReduceOptions options = reduce_options(scene, compiled, targets);
  options.progress = progress;
  if (room != nullptr && room->shift()) options.shift = *room->shift();
  return reduce(compiled.system, options, room);
}

std::string worst_reading(const Reduction& reduction) {
  Eigen::Index worst = 0;
  const Eigen::VectorXd& errors = reduction.error.of_reading;
  if (errors.size() == 0 || errors.maxCoeff(&worst) == 0.) return "";
  return reduction.model.reading_label[static_cast<std::size_t>(worst)].name;
}

std::string told_of_others(const Reduction& reduction) {
  const std::string name = worst_reading(reduction);
  if (name.empty()) return "";
  const bool close = reduction.error.others <= reduction.tolerance_of_others;
  return "; least certain of all else is " + name + ", by " + percent(reduction.error.others) +
         " of its largest value, " +
         (std::isinf(reduction.tolerance_of_others)
              ? std::string("of which no tolerance is asked")
              : std::string(close ? "less than" : "which matters where it is read, not for F_T: more than") +
                    " its tolerance of " + percent(reduction.tolerance_of_others));
}

void require_converged(const Reduction& reduction) {
  if (reduction.converged) return;
  throw NumericsError("the reduced model has not converged after " + std::to_string(reduction.n_solves) +
                      " solves: F_T is uncertain by " + percent(reduction.error.history) + " of its peak, where " +
                      percent(reduction.tolerance) + " are asked for" + told_of_others(reduction));
}

void require_shear_converged(const Reduction& reduction) {
  if (reduction.history.empty() || !(reduction.error.history <= reduction.tolerance)) require_converged(reduction);
}

std::vector<InexactReading> inexact_readings(const Reduction& reduction) {
  std::vector<InexactReading> list;
  if (reduction.converged) return list;
  const Eigen::VectorXd& errors = reduction.error.of_reading;
  for (Eigen::Index i = 0; i < errors.size(); ++i) {
    const auto& measured = reduction.measured;
    if (std::find(measured.begin(), measured.end(), i) != measured.end()) continue;
    if (errors[i] > reduction.tolerance_of_others)
      list.push_back({reduction.model.reading_label[static_cast<std::size_t>(i)].name, errors[i]});
  }
  return list;
}

Response respond(const Reduction& reduction, const Scene& scene, const System& system) {
  Response response;
  response.ends = respond(reduction.model, sampled_loads(scene, system, scene.output_times));
  response.balanced = response.ends;
  response.order = order;
  response.n_steps = static_cast<int>(response.ends.time.size()) - 1;
  response.n_solves = reduction.n_solves;
  response.n_factorisations = 1;
  return response;
}

double error_against_march(const Reduction& reduction, const Scene& scene, const CompiledScene& compiled) {
  const System& system = compiled.system;
  const std::vector<double> time = sampled_loads(scene, system, scene.output_times).time;
  TimeGrid grid{{}, time.back()};
  for (std::size_t n = 1; n < time.size(); ++n) grid.segments.push_back({time[n - 1], time[n] - time[n - 1], 1});
  const auto scheme = make_scheme(system, {SchemeKind::sdirk4, 0., false});
  const int shear = system.reading(reading::shear_force);
  const Eigen::RowVectorXd marched = march(system, *scheme, grid).ends.reading.row(shear);
  const Eigen::RowVectorXd reduced = respond(reduction, scene, system).ends.reading.row(shear);
  return (reduced - marched).cwiseAbs().maxCoeff() / marched.cwiseAbs().maxCoeff();
}

}  // namespace upbead
