// Claims: the motion at B by a force at A is the motion at A by the same force at B (Betti, Maxwell), also in damped
// porous ground; an undamped system runs backwards when its velocities are reversed, if the scheme dissipates no
// energy; the numbering of the unknowns does not matter; refining a mesh does not change a solution that the coarse
// mesh represents exactly. Source: symmetry of M, C and K. Limits: 1e-10 of the largest value, round-off of some
// hundred solves.

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "column_case.h"
#include "fem/unknowns.h"
#include "record.h"
#include "scenes.h"
#include "unknowns_on.h"

namespace upbead::test {
namespace reciprocity_test {

constexpr double tolerance = 1e-10;

double largest_difference(const Eigen::RowVectorXd& a, const Eigen::RowVectorXd& b) {
  return (a - b).cwiseAbs().maxCoeff() / a.cwiseAbs().maxCoeff();
}

/// History of x_j under a unit triangle on unknown i.
Eigen::RowVectorXd moved_at(System system, int i, int j) {
  system.loads = {{"unit", Vector::Unit(system.size(), i), triangle(1., 0.15), -1}};
  system.readings = {{"x", "m", "", {{j, 1.}}, {}, {}, {}}};
  const auto scheme = make_scheme(system, {});
  return march(system, *scheme, make_time_grid(kinks(system), 0.4, 0.0125)).ends.reading.row(0);
}

TEST(Reciprocity, OfForcesAtTwoPlaces) {
  const auto mesh = breakwater_mesh(0.5);
  const Compiled compiled(breakwater(triangle(1e6, 0.15)), *mesh);
  const auto on_bed = unknowns_on(compiled, "bed", 1), on_mound = unknowns_on(compiled, "mound_surface", 0);
  const int a = on_bed[on_bed.size() / 3], b = on_mound[on_mound.size() / 2];
  const int sway = compiled.unknowns.coordinate(0, motion_x);
  const System& system = compiled.system;
  Record record("identities");
  record.at_most("reciprocity of a force on the bed and one on the mound",
                 largest_difference(moved_at(system, a, b), moved_at(system, b, a)), tolerance);
  record.at_most("reciprocity of a force on the bed and one on the caisson",
                 largest_difference(moved_at(system, a, sway), moved_at(system, sway, a)), tolerance);
}

TEST(TimeReversal, ReturnsToTheStart) {
  Scene scene = breakwater(triangle(1e6, 0.15));
  for (const char* name : {"seabed", "mound"}) {
    scene.regions[name].flow = Flow::drained;  // no drag
    scene.regions[name].damping.reset();
  }
  const auto mesh = breakwater_mesh(0.5);
  const Compiled compiled(scene, *mesh);
  const System& system = compiled.system;
  const auto scheme = make_scheme(system, {SchemeKind::generalised_alpha, 1.});
  State state = march(system, *scheme, make_time_grid(kinks(system), 0.2, 0.005)).final_state;
  const State start = state;
  const auto run_free = [&] {
    for (int i = 0; i < 200; ++i) scheme->advance(state, 0.005);
  };
  run_free();
  const double moved = (state.x - start.x).norm() / start.x.norm();
  state.v = -state.v;
  run_free();
  EXPECT_GT(moved, 0.1);
  Record("identities")
      .at_most(
          "undamped, generalised_alpha with rho_inf = 1: 1 s forward and back, distance from the start over its size",
          (state.x - start.x).norm() / start.x.norm(), tolerance);
}

/// The system with its unknowns in another order: free unknowns are shuffled, blocks and prescribed unknowns keep
/// their places.
System renumbered(const System& system) {
  const int n = system.size(), first = system.blocks.empty() ? system.n_free() : system.blocks.front().begin;
  std::vector<int> to(static_cast<std::size_t>(n));
  std::iota(to.begin(), to.end(), 0);
  std::shuffle(to.begin(), to.begin() + first, std::mt19937(7));
  const Eigen::PermutationMatrix<Eigen::Dynamic> P(Eigen::Map<const Eigen::VectorXi>(to.data(), n));
  System out = system;
  for (SparseMatrix System::*matrix : {&System::M, &System::C, &System::K})
    out.*matrix = SparseMatrix(SparseMatrix(P * (system.*matrix)) * P.transpose());
  for (SystemLoad& load : out.loads) load.vector = P * load.vector;
  for (Reading& reading : out.readings)
    for (Row Reading::*row : {&Reading::position, &Reading::velocity, &Reading::acceleration})
      for (auto& entry : reading.*row) entry.first = to[static_cast<std::size_t>(entry.first)];
  for (int i = 0; i < n; ++i) out.field[static_cast<std::size_t>(to[static_cast<std::size_t>(i)])] = system.field[i];
  return out;
}

TEST(Numbering, DoesNotMatter) {
  const auto mesh = breakwater_mesh(0.5);
  Scene scene = breakwater(triangle(1e6, 0.15));
  scene.probes["sand"].at = {4., -3.};
  const Compiled compiled(scene, *mesh);
  const auto histories = [](const System& system) {
    const auto scheme = make_scheme(system, {});
    return march(system, *scheme, make_time_grid(kinks(system), 0.5, 0.0125)).ends.reading;
  };
  const Eigen::MatrixXd one = histories(compiled.system), other = histories(renumbered(compiled.system));
  Record record("identities");
  for (const char* reading : {"shear_force", "caisson/displacement_x", "probes/sand/pressure"}) {
    const int row = compiled.system.reading(reading);
    record.at_most(std::string("another numbering of the unknowns: ") + reading,
                   largest_difference(one.row(row), other.row(row)), tolerance);
  }
}

TEST(Refinement, KeepsAnAffineSolution) {
  Region elastic = sand();
  elastic.flow = Flow::drained;
  elastic.damping.reset();
  Scene scene = column(elastic, step_load(1e5));
  scene.time.inertia = false;
  scene.probes["top"].at = {0.5, 10.};
  scene.probes["middle"].at = {0.3, 4.};
  const auto coarse = column_mesh(10., 3), fine = column_mesh(10., 3);
  fine->triangulation.refine_global(2);
  const Compiled a(scene, *coarse), b(scene, *fine);
  const Response on_coarse = run(a, 1., 0.5), on_fine = run(b, 1., 0.5);
  Record record("identities");
  for (const char* reading :
       {"probes/top/displacement_y", "probes/middle/displacement_y", "probes/middle/effective_stress_yy"})
    record.at_most(std::string("refining a column of constant strain: ") + reading,
                   largest_difference(history(a, on_coarse, reading), history(b, on_fine, reading)), tolerance);
  const Material m = material(elastic, scene.fluid, scene.gravity);
  const double exact = -1e5 * 10. / (m.lambda + 2. * m.G);
  record.at_most("settlement of a column of constant strain, relative",
                 std::abs(history(a, on_coarse, "probes/top/displacement_y").tail<1>()[0] / exact - 1.), tolerance);
}

}  // namespace reciprocity_test
}  // namespace upbead::test
