// Claim: a state of constant strain and constant pressure gradient is exact on every mesh.
//
// Source: tests/reference/ref8_mms.json, solution `patch`: u and p linear in x, y and quadratic in t.
//
// Limit: 1e-10 of the largest value, at the nodes, on uniform, perturbed and trapezoid meshes of 4 x 2 cells.
// 1. In space alone: the exact x, x', x'' satisfy M x'' + C x' + K x = F(t) to round-off, whatever the time scheme.
// 2. Marched: sdirk4 is not exact for quadratics, because its stages are of order 1. With d = c^2/2 - A c a step leaves
//    b.A^k d h^(k+3) times the (k+1)-th power of the system's matrix; the order conditions cancel k = 0 and 1, and what
//    remains falls with the fourth power of the step. 3200 steps bring it below the limit.

#include <gtest/gtest.h>

#include "meshes.h"
#include "record.h"
#include "sources.h"

namespace upbead::test {
namespace patch_test {

/// Largest |difference| over the largest |exact| among the unknowns of one field.
double nodal_error(const System& system, Field field, const Vector& computed, const Vector& exact) {
  std::vector<double> values, wanted;
  for (int i = 0; i < system.size(); ++i)
    if (system.field[static_cast<std::size_t>(i)] == field) {
      values.push_back(computed[i]);
      wanted.push_back(exact[i]);
    }
  return largest_error(values, wanted);
}

/// |M x'' + C x' + K x - F| over the largest of its terms, the worst of u and phi.
double residual(const Problem& problem, const State& exact) {
  const System& system = problem.compiled.system;
  const Vector M = system.M * exact.a, C = system.C * exact.v, K = system.K * exact.x;
  const Vector F = source(problem.compiled, problem.mms, exact.time);
  return largest_ratio(system, M + C + K - F, {M, C, K, F});
}

void patch(int degree) {
  Record record("manufactured_patch");
  const Manufactured mms = manufactured("ref8_mms", "patch", 0, degree);
  double equations = 0., u = 0., p = 0.;
  for (const Quads quads : {Quads::uniform, Quads::perturbed, Quads::trapezoid}) {
    const auto mesh = quadrilaterals(mms, quads, 2.5);
    const Problem problem(mms, *mesh);
    const System& system = problem.compiled.system;
    const State exact = exact_state(problem.compiled, mms, mms.end);
    const State computed = marched(problem, mms.end, 3200);
    for (const double t : {0., 0.5 * mms.end, mms.end})
      equations = worse(equations, residual(problem, exact_state(problem.compiled, mms, t)));
    u = worse(u, nodal_error(system, Field::displacement, computed.x, exact.x));
    p = worse(p, nodal_error(system, Field::pressure_impulse, computed.v, exact.v));
  }
  const std::string title = "patch, degree " + std::to_string(degree) + ", worst of three meshes: ";
  record.at_most(title + "residual of the exact state in the semi-discrete equations, over their largest term",
                 equations, 1e-10);
  record.at_most(title + "u after 3200 steps of sdirk4, over the largest", u, 1e-10);
  record.at_most(title + "p after 3200 steps of sdirk4, over the largest", p, 1e-10);
}

TEST(ManufacturedPatch, Degree2) {
  patch(2);
}

TEST(ManufacturedPatch, Degree3) {
  patch(3);
}

}  // namespace patch_test
}  // namespace upbead::test
