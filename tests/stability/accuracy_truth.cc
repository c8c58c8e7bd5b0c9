#include "accuracy_truth.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/stopwatch.h"
#include "fem/compile.h"
#include "mesh/refine.h"
#include "upbead/base/error.h"

namespace upbead::test {

namespace {

constexpr int rounds_at_corners = 3, most_unknowns = 45000;
constexpr double exactness = 0.15;  ///< tolerance of the reduced model of the truth, over that of the case

/// Cells at points where two regions meet at the outline, or three regions meet: there stresses are singular.
std::vector<bool> cells_at_corners(const Mesh& mesh) {
  std::map<unsigned, std::set<unsigned>> regions;
  std::set<unsigned> outline;
  for (const auto& cell : mesh.triangulation.active_cell_iterators()) {
    for (const unsigned v : cell->vertex_indices()) regions[cell->vertex_index(v)].insert(cell->material_id());
    for (const unsigned f : cell->face_indices())
      if (cell->at_boundary(f))
        for (unsigned v = 0; v < 2; ++v) outline.insert(cell->face(f)->vertex_index(v));
  }
  std::vector<bool> chosen;
  for (const auto& cell : mesh.triangulation.active_cell_iterators()) {
    bool at_corner = false;
    for (const unsigned v : cell->vertex_indices()) {
      const unsigned i = cell->vertex_index(v);
      at_corner = at_corner || regions.at(i).size() + outline.count(i) > 2;
    }
    chosen.push_back(at_corner);
  }
  return chosen;
}

std::shared_ptr<Mesh> finer_mesh(const Mesh& mesh, int halvings) {
  std::shared_ptr<Mesh> finer = halved(mesh);
  for (int i = 1; i < halvings; ++i) finer = halved(*finer);
  for (int i = 0; i < rounds_at_corners; ++i) finer = refined(*finer, cells_at_corners(*finer));
  return finer;
}

struct Truth {
  Run run;
  int unknowns = 0;
};

Truth solve(const Case& input, const Run& answer, std::shared_ptr<Mesh> mesh) {
  Case exact = input;
  exact.scene.mesh.refine = 0;
  exact.scene.tolerance *= exactness;
  // the steps meet the times of the run, between which its history is not known
  const bool slips = answer.summary.contact && answer.summary.contact->solved;
  const double part = answer.summary.reduction || slips ? 0.25 : 0.5;
  exact.scene.time.step = part * answer.summary.discretisation.time_step * (1. + 1e-9);
  const Simulation scene = simulation_of(exact, std::move(mesh));
  Truth truth;
  truth.unknowns = scene.unknowns()->n_free();
  truth.run = solve(exact, scene, {});
  return truth;
}

double value_at(const std::vector<double>& time, const Eigen::RowVectorXd& value, double t) {
  const auto after = std::lower_bound(time.begin(), time.end(), t);
  const auto i = std::clamp<std::ptrdiff_t>(after - time.begin(), 1, static_cast<std::ptrdiff_t>(time.size()) - 1);
  const double a = time[static_cast<std::size_t>(i) - 1], b = time[static_cast<std::size_t>(i)];
  return value[i - 1] + (t - a) / (b - a) * (value[i] - value[i - 1]);
}

/// `row`: of F_T.
double history_error(const Run& run, const Run& truth, int row) {
  const Eigen::RowVectorXd found = run.response.ends.reading.row(row), right = truth.response.ends.reading.row(row);
  double most = 0.;
  for (std::size_t i = 0; i < run.response.ends.time.size(); ++i)
    most = std::max(most, std::abs(found[static_cast<Eigen::Index>(i)] -
                                   value_at(truth.response.ends.time, right, run.response.ends.time[i])));
  return most / right.cwiseAbs().maxCoeff();
}

double peak_error(const Run& run, const Run& truth) {
  return std::abs(run.summary.response->peak_shear / truth.summary.response->peak_shear - 1.);
}

JudgedNumber judged(double value, double truth, const std::optional<double>& told) {
  return {value, told.value_or(0.), std::abs(value - truth), told.has_value()};
}

void judge_slip(const Run& run, const Run& truth, AccuracyVerdict& verdict) {
  const auto& own = run.summary.sliding;
  const auto& right = truth.summary.sliding;
  verdict.slip = judged(own->history.by_history.residual, right->history.by_history.residual, own->error_estimate);
  if (own->coupled && right->coupled)
    verdict.coupled = judged(own->coupled->slip.residual, right->coupled->slip.residual, own->coupled->error_estimate);
  const auto& contact = run.summary.contact;
  if (contact && contact->solved && truth.summary.contact->solved)
    verdict.contact =
        judged(contact->solved->slip, truth.summary.contact->solved->slip, contact->solved->error_estimate);
}

double without_sides(const ErrorEstimate& e) {
  return e.total() - e.far_boundary;
}

}  // namespace

AccuracyVerdict judge_accuracy(const std::string& path) {
  AccuracyVerdict verdict;
  try {
    const Stopwatch watch;
    const Case input = read_case(path);
    const Simulation scene = simulation_of(input);
    const Run run = solve(input, scene);
    verdict.seconds = watch.seconds();
    verdict.unknowns = scene.unknowns()->n_free();
    verdict.scheme = run.summary.discretisation.scheme;
    const Stopwatch truth_watch;
    const int row = scene.system().reading("shear_force");
    Truth truth = solve(input, run, finer_mesh(*scene.mesh(), 1));
    Run before = std::move(truth.run);
    if (16 * verdict.unknowns <= most_unknowns) {
      truth = solve(input, run, finer_mesh(*scene.mesh(), 2));
      verdict.truth_peak = peak_error(before, truth.run);
      verdict.truth_history = history_error(before, truth.run, row);
    } else {
      truth.run = std::move(before);
    }
    verdict.truth_seconds = truth_watch.seconds();
    verdict.truth_unknowns = truth.unknowns;
    const Summary& s = run.summary;
    verdict.peak = {s.response->peak_shear, without_sides(*s.error), peak_error(run, truth.run), true};
    verdict.peak_with_sides = s.error->total();
    verdict.history = {s.response->peak_shear, s.history_error->total(), history_error(run, truth.run, row), true};
    judge_slip(run, truth.run, verdict);
  } catch (const InputError& error) {
    verdict.refused = error.diagnostics().list().front().what;
  } catch (const NumericsError& error) {
    verdict.refused = std::string("numerics: ") + error.what();
  }
  return verdict;
}

}  // namespace upbead::test
