// Claims: an unknown with a given velocity (a displacement, or a phi: a given pressure) does not change the orders of
// the schemes, and the result is that of the system from which the given motion was eliminated by hand,
//   M_ff x'' + C_ff x' + K_ff x = -(M_fp p'' + C_fp p' + K_fp p).
// Bounds on orders as in order_test.cc; 3.9 where the kinked motion of u reaches order 4 from below (3.89, 3.95, 3.96).
#include <gtest/gtest.h>

#include <cmath>

#include "sample_system.h"

namespace prescribed_test {

using namespace upbead;
using namespace upbead::test;

const SchemeOptions sdirk4{SchemeKind::sdirk4, 0., false};
const SchemeOptions alpha{SchemeKind::generalised_alpha, 0.9, false};
constexpr double end = 2.;

TimeFunction from_zero(double (*f)(double)) {
  return TimeFunction({0.}, {[](double) { return 0.; }, [f](double t) { return f(t); }});
}

/// A given velocity p', its derivative and its integral; `kinked` has p'' jump at t = 0.
struct Motion {
  double (*acceleration)(double);
  double (*velocity)(double);
  double (*position)(double);
};
const Motion gentle{[](double t) { return 3. * std::sin(t) * std::sin(t) * std::cos(t); },
                    [](double t) { return std::pow(std::sin(t), 3); },
                    [](double t) { return std::pow(std::cos(t), 3) / 3. - std::cos(t) + 2. / 3.; }};
const Motion kinked{[](double t) { return std::cos(t); }, [](double t) { return std::sin(t); },
                    [](double t) { return 1. - std::cos(t); }};

System eliminated(const System& full, const Motion& motion) {
  const int n = full.n_free();
  System system;
  const auto cut = [n](const SparseMatrix& A) { return SparseMatrix(SparseMatrix(A.topRows(n)).leftCols(n)); };
  const auto column = [n](const SparseMatrix& A) { return Vector(-(Vector(A.col(n)).head(n))); };
  system.M = cut(full.M);
  system.C = cut(full.C);
  system.K = cut(full.K);
  system.field.assign(full.field.begin(), full.field.begin() + n);
  system.blocks = full.blocks;
  system.loads = {{"M", column(full.M), from_zero(motion.acceleration), -1},
                  {"C", column(full.C), from_zero(motion.velocity), -1},
                  {"K", column(full.K), from_zero(motion.position), -1}};
  return system;
}

class Prescribed : public testing::TestWithParam<bool> {
 protected:
  System system(const Motion& motion) const {
    Sample sample;
    (GetParam() ? sample.prescribed_phi : sample.prescribed_u) = true;
    System full = sample_system(sample);
    full.loads = {prescribed_load(full, from_zero(motion.velocity))};
    return full;
  }
};

TEST_P(Prescribed, EqualsTheEliminatedSystem) {
  for (const Motion& motion : {gentle, kinked}) {
    const System full = system(motion), reduced = eliminated(full, motion);
    const State a = state_at(full, sdirk4, end, 1280), b = state_at(reduced, sdirk4, end, 1280);
    // Both have errors of about 1e-10 at this step.
    EXPECT_LT((a.x.head(full.n_free()) - b.x).norm(), 1e-9 * b.x.norm());
    EXPECT_LT((a.v.head(full.n_free()) - b.v).norm(), 1e-9 * b.v.norm());
    EXPECT_NEAR(a.v[full.n_free()], motion.velocity(end), 1e-12);
    EXPECT_NEAR(a.x[full.n_free()], motion.position(end), 1e-9);
  }
}

TEST_P(Prescribed, KeepsTheOrders) {
  for (const Motion& motion : {gentle, kinked}) {
    const System full = system(motion);
    const Vector reference = state_at(eliminated(full, motion), sdirk4, end, 2560).x;
    const std::vector<int> n{40, 80, 160, 320}, many{80, 160, 320, 640};
    const double of_sdirk = order(n, errors(full, sdirk4, end, n, reference));
    const double of_alpha = order(many, errors(full, alpha, end, many, reference));
    RecordProperty("sdirk4", std::to_string(of_sdirk));
    RecordProperty("alpha", std::to_string(of_alpha));
    EXPECT_GT(of_sdirk, 3.9);
    EXPECT_GT(of_alpha, 1.95);
  }
}

// A given velocity that jumps: its impulse acts through the mass matrix.
TEST_P(Prescribed, MayJump) {
  Sample sample;
  (GetParam() ? sample.prescribed_phi : sample.prescribed_u) = true;
  System full = sample_system(sample);
  full.loads = {prescribed_load(full, jump())};
  const Vector reference = state_at(full, sdirk4, end, 2560).x;
  const std::vector<int> n{20, 40, 80, 160}, many{80, 160, 320, 640};
  EXPECT_GT(order(n, errors(full, sdirk4, end, n, reference)), 3.9);
  EXPECT_GT(order(many, errors(full, alpha, end, many, reference)), 1.95);
}

INSTANTIATE_TEST_SUITE_P(Unknown, Prescribed, testing::Bool(),
                         [](const auto& test) { return test.param ? "pressure" : "displacement"; });

}  // namespace prescribed_test
