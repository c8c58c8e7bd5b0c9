#include "adapt.h"

#include <algorithm>
#include <numeric>

#include "../compile_on.h"
#include "upbead/base/error.h"
#include "upbead/base/interrupt.h"
#include "upbead/base/stopwatch.h"
#include "upbead/base/text.h"
#include "upbead/mesh/refine.h"

namespace upbead {

namespace {

/// Part of the tolerance that the mesh may use up by its estimate, which was down to 0.6 of the true error
/// (docs/verification.md).
constexpr double share_of_mesh = 0.6;
/// Errors of cells that are split, over what they were: measured between 0.2 and 0.6.
constexpr double error_after_split = 0.4;
/// Part of the error whose cells are split at once, at least and at most.
constexpr double least_part = 0.3, most_part = 0.85;
constexpr int most_unknowns = 400000;

/// The cells with the largest errors, which together have a part of the sum. Mirror images, whose errors differ by
/// round-off, are split alike: a symmetric scene then stays so.
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

/// No more cells than it takes to come just below the aim.
double part_to_split(double error, double aim) {
  return std::clamp((error - 0.9 * aim) / (error * (1. - error_after_split)), least_part, most_part);
}

void require_measurable(const Case& input, const CompiledCase& scene) {
  const std::string cure = "give a number of uniform refinements";
  std::string why;
  if (!scene.compiled.caisson) why = "the mesh has no surface 'caisson' whose F_T would tell";
  if (!input.scene.time.inertia) why = "time.inertia = false leaves nothing dynamic to tell";
  if (scene.compiled.loads_on_caisson.empty()) why = "no load acts";
  if (!why.empty()) throw InputError(input.place("mesh.refine"), "refine = \"auto\": " + why, cure);
}

void require_reached(const Case& input, const MeshAccuracy& accuracy, double aim) {
  const auto [unknowns, error] = accuracy.levels.back();
  if (error <= aim) return;
  throw InputError(input.place("accuracy.tolerance"),
                   "with " + std::to_string(unknowns) + " unknowns the mesh still makes F_T wrong by " +
                       significant(error) + "; a tolerance of " + significant(input.scene.tolerance) + " leaves it " +
                       significant(aim),
                   "raise tolerance, or give mesh.refine as a number");
}

}  // namespace

CompiledCase compile_adapted(const Case& input) {
  const Stopwatch watch;
  const double aim = share_of_mesh * input.scene.tolerance;
  const std::shared_ptr<Mesh> mesh = read_mesh(mesh_request(input));
  MeshAccuracy accuracy;
  for (;;) {
    check_interrupt();
    CompiledCase scene = compile_on(input, mesh);
    require_measurable(input, scene);
    accuracy.error = mesh_error(scene.scene, *scene.space, *scene.unknowns, scene.compiled);
    const int n = scene.compiled.system.n_free();
    accuracy.levels.emplace_back(n, accuracy.error.sum);
    if (accuracy.error.sum <= aim || n > most_unknowns) {
      require_reached(input, accuracy, aim);
      scene.timing.mesh = watch.seconds() - scene.timing.compile;
      scene.accuracy = std::move(accuracy);
      return scene;
    }
    const std::vector<bool> chosen = worst_cells(accuracy.error, part_to_split(accuracy.error.sum, aim));
    scene.unknowns.reset();  // both stand on the mesh as it is
    scene.space.reset();
    refine_cells(*mesh, chosen);
  }
}

}  // namespace upbead
