// Claim: a solid block on a layer becomes a rigid one as its modulus grows to 10^8 times the soil's: its stiffness
// tends to the rigid strip's from below, with a deviation proportional to E_soil / E_block, and the program's solver
// stays accurate. Source: tests/reference/ref9_stress.json, test d. The block, 2 b high, is pushed through a rigid
// cap on its top whose coordinates are those of the middle of the base, so that block and soil deform in series: K
// grows with E_block by the theorem of minimum energy, on any mesh. The rigid limit is computed on a fine mesh and
// agrees with the table within 0.5 %; the approach to it is computed on a coarse mesh, against the rigid limit of
// that mesh, because both moduli are in one matrix and round-off, about 100 times 10^-16 E_block / E_soil, must stay
// below the deviation. Limits: K_v, K_hh, K_rr monotone and below the limit up to 10^6, slope of the deviation over
// E_soil / E_block 1 within 1 %; at 10^7 and 10^8, where the deviation is below round-off, 1e-5 of the limit;
// relative residual of the solver 1e-10 at 10^8.

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "algebra/factorisation.h"
#include "dynamic_stiffness.h"
#include "fem/unknowns.h"
#include "loaded_layer.h"
#include "tensor_mesh.h"

namespace upbead::test {
namespace contrast_test {

const ElasticSoil ground{0.3, 1.5};
constexpr double rigid = std::numeric_limits<double>::infinity();
constexpr std::array<const char*, 3> names{"K_hh", "K_v", "K_rr"};  ///< on the diagonal

/// Static stiffness by the program's own solver, and the largest relative residual of its solutions.
struct Solved {
  Eigen::Matrix3d K;
  double residual;
};

/// |b - K x| over |K| |x| + |b|, all in the norm of the largest entry or row sum.
double relative_residual(const SparseMatrix& K, const Vector& x, const Vector& b) {
  Vector row_sum = Vector::Zero(b.size());
  for (int outer = 0; outer < K.outerSize(); ++outer)
    for (SparseMatrix::InnerIterator entry(K, outer); entry; ++entry) row_sum[entry.row()] += std::abs(entry.value());
  return (b - K * x).lpNorm<Eigen::Infinity>() /
         (row_sum.maxCoeff() * x.lpNorm<Eigen::Infinity>() + b.lpNorm<Eigen::Infinity>());
}

Solved solve(const Compiled& compiled) {
  const SparseMatrix& K = compiled.system.K;
  const Factorisation factors(K);
  Solved out{Eigen::Matrix3d::Zero(), 0.};
  Eigen::Matrix3d compliance;
  for (int load = 0; load < n_motions; ++load) {
    Vector unit = Vector::Zero(K.rows());
    unit[compiled.unknowns.coordinate(0, load)] = 1.;
    const Vector x = factors.solve(unit);
    out.residual = std::max(out.residual, relative_residual(K, x, unit));
    for (int motion = 0; motion < n_motions; ++motion)
      compliance(motion, load) = x[compiled.unknowns.coordinate(0, motion)];
  }
  out.K = compliance.inverse();
  return out;
}

/// `contrast`: the block's modulus over the soil's.
Solved with_block(double contrast, double edge, int degree) {
  StiffnessCells cells;
  cells.edge = edge;
  cells.calm = 12. * ground.depth;
  const bool solid = !std::isinf(contrast);
  const auto mesh =
      stiffness_mesh(ground, cells, {{solid ? "block" : "strip", even_lines(0., 2., 4)}, {"strip", {2., 2.5}}});
  Scene scene = stiffness_scene(ground, cells, *mesh, 0.);
  scene.mesh.degree = degree;
  if (solid) scene.regions["block"].shear_modulus = contrast;
  return solve(Compiled(scene, *mesh));
}

TEST(StiffnessContrast, RigidLimit) {
  const Json limit = stress_test("d_stiffness_contrast").at("rigid_limit");
  Stiffness exact = Stiffness::Zero();
  exact(0, 0) = limit.at("Khh").get<double>(), exact(1, 1) = limit.at("Kv").get<double>();
  exact(2, 2) = limit.at("Krr").get<double>(), exact(0, 2) = limit.at("Khr").get<double>();
  Record record("stress_contrast");
  record.at_most("rigid block, fine mesh: K_v, K_hh, K_rr, K_hr against the table",
                 stiffness_error(with_block(rigid, 0.005, 3).K.cast<std::complex<double>>(), exact), 5e-3);
}

/// Deviations below the rigid limit of one component, for moduli of 10^2, 10^3, ... 10^8.
void compare_component(Record& record, const std::string& name, const std::vector<double>& deviation) {
  constexpr std::size_t n_resolved = 5;  // to 10^6
  std::vector<double> softness, proportional;
  for (std::size_t i = 0; i < n_resolved; ++i) softness.push_back(std::pow(10., -2. - static_cast<double>(i)));
  const std::vector<double> resolved(deviation.begin(), deviation.begin() + n_resolved);
  double least_gain = resolved.back() > 0. ? rigid : 0.;
  for (std::size_t i = 0; i + 1 < n_resolved; ++i) least_gain = std::min(least_gain, resolved[i] / resolved[i + 1]);
  for (const double s : softness) proportional.push_back(resolved[2] * s / softness[2]);
  const double slope = order({softness.begin() + 1, softness.end()}, {resolved.begin() + 1, resolved.end()});
  record.at_least(name + ": deviation below the rigid limit over that at ten times the modulus, least up to 10^6",
                  least_gain, 1.);
  record.at_most(name + ": slope of log deviation over log E_soil/E_block, 10^-3 to 10^-6, difference from 1",
                 std::abs(slope - 1.), 0.01);
  for (std::size_t i = n_resolved; i < deviation.size(); ++i)
    record.at_most(
        name + ": difference from the rigid limit at E_block = 10^" + std::to_string(i + 2) + " E_soil, over K",
        std::abs(deviation[i]), 1e-5);
  record.curve({"block on a layer: 1 - K/K_rigid", "E_soil/E_block (log)", "1 - K/K_rigid (log)", name, softness,
                proportional, resolved});
}

TEST(StiffnessContrast, BlockBecomesRigid) {
  constexpr double edge = 0.5;
  constexpr int degree = 2;
  const Eigen::Matrix3d limit = with_block(rigid, edge, degree).K;
  std::array<std::vector<double>, 3> deviation;
  double residual = 0.;
  for (int power = 2; power <= 8; ++power) {
    const Solved solved = with_block(std::pow(10., power), edge, degree);
    for (int i = 0; i < 3; ++i) deviation[static_cast<std::size_t>(i)].push_back(1. - solved.K(i, i) / limit(i, i));
    residual = solved.residual;
  }
  Record record("stress_contrast");
  for (std::size_t i = 0; i < 3; ++i) compare_component(record, names[i], deviation[i]);
  record.at_most("residual of the program's solver at E_block = 10^8 E_soil, coarse mesh, over norm(K) norm(x)",
                 residual, 1e-10);
}

// On a fine mesh round-off is amplified more: stiffnesses are recorded only, and just the residual has a limit.
TEST(StiffnessContrast, RoundOffOnAFineMesh) {
  const Eigen::Matrix3d limit = with_block(rigid, 0.005, 3).K;
  const Solved solved = with_block(1e8, 0.005, 3);
  double worst = 0.;
  for (int i = 0; i < 3; ++i) worst = std::max(worst, std::abs(1. - solved.K(i, i) / limit(i, i)));
  Record record("stress_contrast");
  record.at_most("residual of the program's solver at E_block = 10^8 E_soil, fine mesh, over norm(K) norm(x)",
                 solved.residual, 1e-10);
  record.measured("difference from the rigid limit at E_block = 10^8 E_soil, fine mesh, over K", worst);
}

}  // namespace contrast_test
}  // namespace upbead::test
