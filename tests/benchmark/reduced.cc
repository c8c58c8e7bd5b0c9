// Error of F_T against the number of solves, for marches and for reduced models of one scene, with the time of each
// part.
//
// usage: bench_reduced CASE [KEY=VALUE]...
//
// Prints JSON. All grids in time are refinements of one coarse grid, so that histories are compared at equal times
// without interpolation.

#include <algorithm>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>
#include <numeric>

#include "base/stopwatch.h"
#include "dynamics/batch_response.h"
#include "dynamics/projection.h"
#include "dynamics/state_space.h"
#include "fem/compile.h"
#include "response/reduction.h"
#include "response/shear_response.h"
#include "response/time_choice.h"
#include "upbead/algebra/petsc_session.h"
#include "upbead/base/error.h"
#include "upbead/case/case_run.h"
#include "upbead/sliding/block.h"

namespace upbead {
namespace {

using Json = nlohmann::ordered_json;

constexpr double two_pi = 6.283185307179586;
/// Steps of the reference, and of the modal responses, per step of the coarse grid, which is at most half a duration.
constexpr int reference_refinement = 96, modal_refinement = 24;

double milliseconds(double seconds) {
  return std::round(1e5 * seconds) / 100.;
}

/// F_T at the times of a refined grid, and its largest value, found inside the steps.
struct Shear {
  Eigen::RowVectorXd history;
  double peak = 0.;
  int refinement = 1;
};

/// A scene, its reference and what is measured against it.
class Bench {
 public:
  explicit Bench(const Simulation& scene)
      : scene_(scene),
        system_(scene.system()),
        duration_(step_of_loads(scene.scene(), 4).duration),
        coarse_(make_time_grid(kinks(system_), scene.scene().time.end, duration_ / 2.)) {
    for (const SystemLoad& load : system_.loads) histories_.push_back(load.history);
  }

  Json measure() {
    Json json;
    json["title"] = scene_.scene().title;
    json["unknowns"] = system_.n_free();
    json["duration"] = duration_;
    json["reference"] = march_with(SchemeKind::sdirk4, reference_refinement, reference_);
    for (const int refinement : {1, 2, 3, 4, 6, 8, 12, 16, 24, 48}) add_march(json, SchemeKind::sdirk4, refinement);
    for (const int refinement : {4, 6, 8, 12, 16, 24, 48, 96})
      add_march(json, SchemeKind::generalised_alpha, refinement);
    for (const double shift : {1., 1.25, 1.5, 1.75, 2.}) add_models(json, shift);
    const SchemeChoice choice = choose_scheme(scene_.scene(), *scene_.compiled());
    json["chosen"] = {chosen("run", {false, false, choice.most_vectors}), chosen("reduce", {true, true, {}})};
    json["throughput"] = throughput();
    return json;
  }

 private:
  TimeGrid refined(int refinement) const {
    TimeGrid grid = coarse_;
    for (TimeSegment& segment : grid.segments) {
      segment.step /= refinement;
      segment.n_steps *= refinement;
    }
    return grid;
  }

  Shear shear_of(const Response& response, int refinement) const {
    return {response.ends.reading.row(system_.reading("shear_force")),
            read_shear_response(*scene_.compiled(), response, true).peak_shear, refinement};
  }

  Json march_with(SchemeKind kind, int refinement, Shear& shear) const {
    const auto scheme = make_scheme(system_, {kind, 0.9, false});
    const TimeGrid grid = refined(refinement);
    const Stopwatch watch;
    const Response response = march(system_, *scheme, grid);
    const double wall = watch.seconds();
    shear = shear_of(response, refinement);
    return {{"scheme", scheme->name()},
            {"step", grid.segments.front().step},
            {"solves", response.n_solves},
            {"factorise", milliseconds(scheme->factorise_seconds())},
            {"march", milliseconds(wall - scheme->factorise_seconds())}};
  }

  void add_march(Json& json, SchemeKind kind, int refinement) const {
    Shear shear;
    const Json row = march_with(kind, refinement, shear);
    json["march"].push_back(errors(shear, row));
  }

  /// Adds to `row` the errors of F_T against the reference, over the peak of the reference.
  Json errors(const Shear& shear, Json row) const {
    const int common = std::gcd(shear.refinement, reference_.refinement);
    const auto n = static_cast<Eigen::Index>(coarse_.n_steps()) * common;
    const Eigen::Index step = shear.refinement / common, reference_step = reference_.refinement / common;
    double largest = 0.;
    for (Eigen::Index i = 0; i <= n; ++i)
      largest = std::max(largest, std::abs(shear.history[i * step] - reference_.history[i * reference_step]));
    const double scale = reference_.history.cwiseAbs().maxCoeff();
    row["history_error"] = largest / scale;
    row["peak_error"] = std::abs(shear.peak - reference_.peak) / scale;
    return row;
  }

  /// Models of one Krylov space about a shift (in 2 pi / duration), of increasing numbers of vectors.
  void add_models(Json& json, double shift) const {
    SecondOrderKrylov krylov(system_, shift * two_pi / duration_, scene_.compiled()->body_coordinates);
    Projection projection(system_, krylov);
    double krylov_seconds = 0., projection_seconds = 0.;
    for (const int vectors : {12, 15, 18, 21, 24, 27, 30, 33, 37, 41, 46, 51, 57, 64, 71, 80, 90}) {
      const Stopwatch krylov_watch;
      while (krylov.n_vectors() < vectors * krylov.n_independent_loads())
        if (!krylov.extend()) return;
      krylov_seconds += krylov_watch.seconds();
      const Stopwatch projection_watch;
      projection.extend();
      projection_seconds += projection_watch.seconds();
      Json row{{"shift", shift}, {"vectors", krylov.n_vectors()}, {"solves", krylov.n_solves()}};
      row["factorise"] = milliseconds(krylov.factorise_seconds());
      row["krylov"] = milliseconds(krylov_seconds);
      row["projection"] = milliseconds(projection_seconds);
      json["reduced"].push_back(answered(projection, row));
    }
  }

  /// How many waves one core computes per second with the model that `upbead reduce` would write: F_T, its peak and
  /// S.
  Json throughput() const {
    const Reduction reduction = reduce_scene(scene_.scene(), *scene_.compiled(), {true, true, {}});
    constexpr int n_waves = 2000, n_samples = 2000;
    constexpr double step = 1e-3;
    const BatchResponse batch(reduction.model, system_.reading("shear_force"), step);
    History F_T{std::vector<double>(n_samples), std::vector<double>(n_samples)};
    for (int n = 0; n < n_samples; ++n) F_T.time[n] = n * step;
    WaveSamples loads = WaveSamples::Zero(reduction.model.n_loads(), n_samples);
    Eigen::RowVectorXd y(n_samples);
    const double resistance = reference_.peak, mass = scene_.compiled()->caisson->body.mass;
    double respond_seconds = 0., read_seconds = 0.;
    int n_sliding = 0;
    for (int w = 0; w < n_waves; ++w) {
      const double start = 1e-4 * w, scale = peak_of_loads() * (0.5 + static_cast<double>(w) / n_waves);
      for (int n = 0; n < n_samples; ++n)
        loads(0, n) = scale * std::max(0., 1. - std::abs((n * step - start) / (0.5 * duration_) - 1.));
      const Stopwatch respond_watch;
      batch.respond(loads, y);
      respond_seconds += respond_watch.seconds();
      const Stopwatch read_watch;
      const double peak = y.maxCoeff();
      Eigen::Map<Eigen::RowVectorXd>(F_T.value.data(), n_samples) = y;
      if (peak > resistance && slide(mass, F_T, resistance).residual > 0.) ++n_sliding;
      read_seconds += read_watch.seconds();
    }
    return {{"n_modes", reduction.model.n_modes()},
            {"samples", n_samples},
            {"waves", n_waves},
            {"sliding", n_sliding},
            {"F_T_per_second", std::round(n_waves / respond_seconds)},
            {"F_T_peak_and_S_per_second", std::round(n_waves / (respond_seconds + read_seconds))}};
  }

  /// Largest |f| of the scene's first load.
  double peak_of_loads() const { return extremum(histories_.front(), 0., coarse_.end, 1).value; }

  Json answered(const Projection& projection, Json row) const {
    const Stopwatch modes_watch;
    const ModalModel model = modal_model(state_space(projection.reduced()), projection.reduced());
    row["n_modes"] = model.n_modes();
    row["modes"] = milliseconds(modes_watch.seconds());
    return answered(model, row);
  }

  /// The model that a command makes: its error as estimated by nested models, and its true error.
  Json chosen(const char* command, const ReductionTargets& aim) const {
    const Reduction reduction = reduce_scene(scene_.scene(), *scene_.compiled(), aim);
    return answered(reduction.model, {{"command", command},
                                      {"solves", reduction.n_solves},
                                      {"converged", reduction.converged},
                                      {"nested_error", reduction.error.history},
                                      {"highest_frequency", reduction.omega / two_pi}});
  }

  Json answered(const ModalModel& model, Json row) const {
    std::vector<double> time{0.};
    for (const TimeSegment& segment : refined(modal_refinement).segments)
      for (int i = 1; i <= segment.n_steps; ++i) time.push_back(segment.start + i * segment.step);
    const Stopwatch respond_watch;
    Response response;
    response.ends = respond(model, sample(histories_, time));
    row["respond"] = milliseconds(respond_watch.seconds());
    response.balanced = response.ends;
    response.order = 4;
    response.n_steps = static_cast<int>(time.size()) - 1;
    return errors(shear_of(response, modal_refinement), row);
  }

  const Simulation& scene_;
  const System& system_;
  double duration_;
  TimeGrid coarse_;
  std::vector<TimeFunction> histories_;
  Shear reference_;
};

}  // namespace
}  // namespace upbead

int main(int argc, char** argv) {
  try {
    if (argc < 2) throw std::invalid_argument("usage: bench_reduced CASE [KEY=VALUE]...");
    const upbead::PetscSession petsc;
    const upbead::Simulation scene =
        upbead::simulation_of(upbead::read_case(argv[1], std::vector<std::string>(argv + 2, argv + argc)));
    std::cout << upbead::Bench(scene).measure().dump(1) << "\n";
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
}
