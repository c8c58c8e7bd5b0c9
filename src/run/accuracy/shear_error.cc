#include "run/accuracy/accuracy.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/progress.h"
#include "base/stopwatch.h"
#include "base/text.h"
#include "fem/caisson/readings.h"
#include "mesh/refine.h"
#include "model/exclusions.h"
#include "response/reduction.h"
#include "response/spectrum.h"
#include "run/derived.h"
#include "run/solve.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

double over(double difference, double scale) {
  return scale > 0. ? difference / scale : 0.;
}

}  // namespace

ShearHistory shear_history(const CompiledScene& compiled, const Response& response) {
  const ShearResponse read = read_shear_response(compiled, response, true);
  const Eigen::RowVectorXd F_T = response.ends.reading.row(compiled.system.reading(reading::shear_force));
  return {{response.ends.time, {F_T.begin(), F_T.end()}},
          -read.peak_force_seaward > read.peak_force ? read.peak_shear_seaward : read.peak_shear};
}

ShearHistory marched_shear(const CompiledScene& compiled, SchemeKind kind, const TimeGrid& grid) {
  SchemeOptions options;
  options.kind = kind;
  options.account_energy = false;
  const auto scheme = make_scheme(compiled.system, options);
  return shear_history(compiled, march(compiled.system, *scheme, grid));
}

ShearError difference(const ShearHistory& answer, const ShearHistory& better) {
  const auto& [time, force] = better.history;
  double largest = 0., most = 0.;
  for (const double F : force) largest = std::max(largest, std::abs(F));
  for (std::size_t i = 0; i < answer.history.time.size(); ++i)
    most = std::max(most, std::abs(answer.history.value[i] - value_at(time, force, answer.history.time[i])));
  return {over(std::abs(answer.peak - better.peak), std::abs(better.peak)), over(most, largest)};
}

namespace {

/// Share of the tolerance for the error of the mesh; the rest is for the reduced model or the steps.
constexpr double share_of_mesh = 0.75, share_of_rest = 0.25;
/// Error of a cell after it was split, over that before: measured between 0.2 and 0.6.
constexpr double error_after_split = 0.4;
/// Share of the error whose cells are split in one refinement, at least and at most.
constexpr double least_part = 0.3, most_part = 0.85;
/// After a refinement the error should fall below this share of the one before; else it comes from cells that the
/// estimate missed.
constexpr double enough = 0.8;
/// Share of the error whose cells are split in that case; it takes half as many unknowns as splitting all cells.
constexpr double stuck_part = 0.97;
constexpr int most_unknowns = 250000;
/// Share of the error whose cells are split for a comparison: F_T changes by 0.88 to 1.05 of what it changes when all
/// are split, at 0.3 to 0.6 of the unknowns.
constexpr double compared_part = 0.97;
/// The error of the history is measured on a mesh where it is expected below this multiple of the aim, and carried to
/// meshes whose cells have at least this share of the errors of that one.
constexpr double near_aim = 3., least_share_carried = 0.25;

/// The cells with the largest errors, which together have this part of the sum. Mirror images, whose errors differ by
/// round-off, are split alike, so that a symmetric scene stays symmetric.
std::vector<bool> worst_cells(const MeshError& error, double part) {
  std::vector<std::size_t> order(error.of_cell.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return error.of_cell[a] > error.of_cell[b]; });
  std::vector<bool> chosen(order.size(), false);
  double sum = 0., least = 0.;
  for (const std::size_t cell : order) {
    if (sum >= part * error.sum && error.of_cell[cell] < (1. - 1e-6) * least) break;
    chosen[cell] = true;
    least = error.of_cell[cell];
    sum += least;
  }
  return chosen;
}

/// Share of the error to split: no more cells than needed to come just below the aim.
double part_to_split(double error, double aim) {
  return std::clamp((error - 0.9 * aim) / (error * (1. - error_after_split)), least_part, most_part);
}

void require_measurable(const Simulation& simulation) {
  const std::string cure = "give a number of uniform refinements";
  std::string why;
  if (!simulation.compiled()->caisson) why = "the mesh has no surface 'caisson' whose F_T would show it";
  for (const Exclusion& reason : excluded(simulation.given(), Treatment::adapted_mesh)) why = reason.why;
  if (simulation.compiled()->loads_on_caisson.empty()) why = "no load acts";
  if (!why.empty()) throw InputError(at_key("mesh.refine"), "refine = \"auto\": " + why, cure);
}

double driving(const Scene& given, const ShearError& error) {
  return given.accuracy.of == AccuracyOf::peak ? error.peak : error.history;
}

[[noreturn]] void throw_out_of_reach(const Scene& given, const MeshAccuracy& accuracy, int unknowns) {
  const MeshAccuracy::Level& last = accuracy.levels.back();
  const bool peak = given.accuracy.of == AccuracyOf::peak;
  throw InputError(at_key("accuracy.tolerance"),
                   "a mesh of " + std::to_string(last.unknowns) + " unknowns still makes " +
                       (peak ? "the peak of F_T" : "the history of F_T") + " wrong by up to " +
                       significant(driving(given, last.error)) + "; a tolerance of " + significant(given.tolerance) +
                       " would take more than " + std::to_string(unknowns),
                   std::string("raise tolerance, ") + (peak ? "" : "write accuracy.of = \"peak\", ") +
                       "or give mesh.refine as a number");
}

/// Splits cells until the error that they cause is small enough.
class Adaptation {
 public:
  Adaptation(const Scene& given, std::shared_ptr<const Mesh> coarse, Layout among)
      : given_(given), aim_(share_of_mesh * given.tolerance), mesh_(std::move(coarse)), among_(std::move(among)) {}

  /// The scene on the present mesh; its accuracy is set where this mesh is good enough.
  Simulation assemble() {
    // for the cells' errors, then for the comparison, then for the solution
    const Simulation simulation = with_room(on_mesh(given_, mesh_));
    require_measurable(simulation);
    cells_ = mesh_error(simulation.scene(), *simulation.space(), *simulation.unknowns(), *simulation.compiled(),
                        simulation.room().get());
    among_.take_first(cells_.of_cell);
    among_.take_first(cells_.sum);
    const int n = simulation.system().n_free();
    if (n > most_unknowns) throw_out_of_reach(given_, accuracy_, n);
    const bool known = is_carried();
    measured_ = !known && scale_ * cells_.sum <= (of_history() ? near_aim : 1.) * aim_;
    if (measured_) measure(simulation, n);
    CellsCompared compared = known ? carried(compared_, *compared_on_, share()) : compared_;
    expected_ = known || measured_ ? driving(given_, compared.error) : scale_ * cells_.sum;
    if (expected_ > aim_) return simulation;
    if (known) accuracy_.levels.push_back({n, compared.error});
    complete(compared, simulation);
    agree(compared, among_);
    accuracy_.compared = std::make_shared<const CellsCompared>(std::move(compared));
    return simulation.with([&](auto& parts) { parts.accuracy = accuracy_; });
  }

  /// Where cells with large errors were split and the error has hardly fallen, nearly all cells with a part in the
  /// error are split; where that does not help either, all cells.
  void refine() {
    const std::size_t n = accuracy_.levels.size();
    const auto error = [this, n](std::size_t back) { return driving(given_, accuracy_.levels[n - back].error); };
    const bool stuck = measured_ && n > 1 && error(1) > enough * error(2);
    if (measured_) n_stuck_ = stuck ? n_stuck_ + 1 : 0;
    const double part = stuck ? stuck_part : part_to_split(expected_, aim_);
    mesh_ = stuck && n_stuck_ > 1 ? halved(*mesh_) : refined(*mesh_, worst_cells(cells_, part));
  }

  /// Share of the way to the aim, by the logarithm of the error.
  double done() const {
    if (accuracy_.levels.empty()) return 0.;
    const double first = driving(given_, accuracy_.levels.front().error);
    return first > aim_ ? std::log(first / driving(given_, accuracy_.levels.back().error)) / std::log(first / aim_)
                        : 1.;
  }

 private:
  bool of_history() const { return given_.accuracy.of == AccuracyOf::history; }

  /// Whether the error is known from that of the mesh that was compared last, by the cells' errors. Not from the first
  /// mesh, which is too coarse for that, nor where the cells' errors have missed something.
  bool is_carried() const {
    return of_history() && accuracy_.levels.size() > 1 && n_stuck_ == 0 && share() >= least_share_carried;
  }
  double share() const { return compared_sum_ > 0. ? cells_.sum / compared_sum_ : 0.; }

  void measure(const Simulation& simulation, int n) {
    compared_ = compare_cells(simulation, worst_cells(cells_, compared_part));
    agree(compared_, among_);
    accuracy_.levels.push_back({n, compared_.error});
    if (cells_.sum > 0.) scale_ = driving(given_, compared_.error) / cells_.sum;
    compared_sum_ = cells_.sum;
    compared_on_ = of_history() ? std::make_unique<Simulation>(simulation) : nullptr;
  }

  const Scene& given_;
  double aim_;
  std::shared_ptr<const Mesh> mesh_;
  MeshAccuracy accuracy_;
  MeshError cells_;
  bool measured_ = false;                    ///< whether the present mesh was compared with a finer one
  int n_stuck_ = 0;                          ///< number of successive measurements by which the error had hardly fallen
  double scale_ = 0.;                        ///< true error over the sum of the cells' errors, as last measured
  double expected_ = 0.;                     ///< error of the present mesh
  CellsCompared compared_;                   ///< the last comparison
  double compared_sum_ = 0.;                 ///< of the cells' errors on its mesh
  std::unique_ptr<Simulation> compared_on_;  ///< where it may be carried
  Layout among_;                             ///< the processes of a run, which need one mesh
};

}  // namespace

Simulation adapted(const Scene& given, std::shared_ptr<const Mesh> coarse, const Layout& among) {
  const Stopwatch watch;
  Adaptation adaptation(given, coarse, among);
  const auto progress = shown_progress("refining the mesh");
  for (;;) {
    progress(adaptation.done());
    const Simulation simulation = adaptation.assemble();
    if (simulation.accuracy()) {
      return simulation.with([&](auto& parts) {
        if (given.accuracy.of == AccuracyOf::history) parts.scene.tolerance = share_of_rest * given.tolerance;
        parts.given_mesh = std::move(coarse);
        parts.timing.mesh = watch.seconds() - parts.timing.compile;
      });
    }
    adaptation.refine();
  }
}

}  // namespace upbead
