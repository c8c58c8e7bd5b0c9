// Claim: displacements of degree k with pressures of degree k - 1 are a stable pair: on an undrained layer of
// incompressible soil under a strip load, pressures and settlements converge and do not alternate from node to node,
// and the inf-sup number of Chapelle and Bathe (1993) has a positive lower bound under refinement.
// Source: tests/reference/ref9_stress.json, test b (Fourier transform of the exact layer with nu = 0.5). Water and
// grains are incompressible; the surface is drained, but steps are so short that its drained skin is far thinner than
// a cell. Limits: at h = b/8, 0.1 % of q and of the largest settlement at the tabulated points; every halving of h at
// least halves both errors and the second differences of p between nodes (those of a smooth field fall fourfold,
// those of a checkerboard not at all), and reduces the inf-sup number by less than 5 %; order 0.9 of p in L2, which
// is 1 as p jumps at the load's edge.
//
// The inf-sup number is sqrt(lambda_min) of B A^-1 B' p = lambda M_p p with the program's own blocks: B from C, M_p
// from M, A = int eps(u) : eps(u) from K at nu = 0, 2 G = 1, which is equivalent to the H1 seminorm (Korn).

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

#include "loaded_layer.h"
#include "record.h"
#include "tensor_mesh.h"

namespace upbead::test {
namespace infsup_test {

const std::vector<int> levels{2, 4, 8};  ///< cells over half the load's width

/// Undrained pressures and settlements over q.
struct Undrained {
  std::vector<double> p, u;   ///< at the tabulated points
  std::vector<double> field;  ///< p at the middles of a grid of `n_grid` by `n_grid` over 2 b by H
  std::vector<double> nodes;  ///< p at the cells' corners on the axis, from z = b/2 down
};
constexpr int n_grid = 12;

/// Adds the probes for all of these.
void add_probes(Scene& scene, const Json& test, const LoadedLayer& layer, int n) {
  add_probes_at_depths(scene, "axis", test.at("z"));
  add_probes_on_surface(scene, "surface", test.at("x"));
  std::vector<double> nodes;
  for (double z = 0.5 * layer.half_width; z < 1.001 * layer.depth; z += layer.half_width / n) nodes.push_back(z);
  add_probes_at_depths(scene, "node", nodes);
  for (int i = 0; i < n_grid; ++i)
    for (int j = 0; j < n_grid; ++j)
      scene.probes["grid" + std::to_string(n_grid * i + j)].at = {2. * layer.half_width * (i + 0.5) / n_grid,
                                                                  -layer.depth * (j + 0.5) / n_grid};
}

Undrained undrained(const Json& test, int degree, int n) {
  const LoadedLayer layer{test.at("b"), test.at("H")};
  const double q = 1e4;
  Json constants = test.at("mat");
  constants["k"] = 1e-12;
  Scene scene = loaded_layer(soil(constants, Flow::darcy), q, PressureCondition::open);
  scene.fluid = fluid(constants);  // K_f is infinite
  scene.mesh.degree = degree;
  add_probes(scene, test, layer, n);
  const auto mesh = even_layer_mesh(layer, n);
  const Compiled compiled(scene, *mesh);
  const System& system = compiled.system;
  const State end = run(compiled, 2., 1.).final_state;
  const auto read = [&](const std::string& prefix, const std::string& quantity) {
    std::vector<double> values;
    for (int i = 0; scene.probes.count(prefix + std::to_string(i)); ++i) {
      const int reading = system.reading("probes/" + prefix + std::to_string(i) + quantity);
      values.push_back(evaluate(system.readings[static_cast<std::size_t>(reading)], end, {q}) / q);
    }
    return values;
  };
  Undrained out{read("axis", "/pressure"), read("surface", "/displacement_y"), read("grid", "/pressure"),
                read("node", "/pressure")};
  for (double& u : out.u) u = -u;
  return out;
}

double rms_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

/// Largest second difference between neighbours: for a checkerboard it would not fall with the size of the cells.
double alternation(const std::vector<double>& nodes) {
  double largest = 0.;
  for (std::size_t i = 1; i + 1 < nodes.size(); ++i)
    largest = std::max(largest, std::abs(nodes[i - 1] - 2. * nodes[i] + nodes[i + 1]));
  return largest;
}

/// `field`: p on the grid, by a finer mesh.
void compare_undrained(Record& record, const Json& test, int degree, const std::vector<double>& field) {
  const std::vector<double> p = test.at("p_over_q"), u = test.at("u_z_down_per_q");
  std::vector<double> h, p_error, u_error, field_error, alternating;
  Undrained result;
  for (const int n : levels) {
    result = undrained(test, degree, n);
    h.push_back(1. / n);
    p_error.push_back(largest_error(result.p, p, 1.));
    u_error.push_back(largest_error(result.u, u));
    field_error.push_back(rms_difference(result.field, field));
    alternating.push_back(alternation(result.nodes));
  }
  const std::string name = "degree " + std::to_string(degree) + ": ";
  record.at_most(name + "p on the axis at h = b/8, largest error over q", p_error.back(), 1e-3);
  record.at_most(name + "settlements at h = b/8, largest error over the largest", u_error.back(), 1e-3);
  record.at_least(name + "order of p in L2 over 2 b by H, h = b/2 to b/8, against degree 3 at b/16",
                  order(h, field_error), 0.9);
  for (std::size_t i = 1; i < levels.size(); ++i) {
    const std::string step = "h = b/" + std::to_string(levels[i]) + " over that at twice h";
    record.at_most(name + "error of p on the axis at " + step, p_error[i] / p_error[i - 1], 0.5);
    record.at_most(name + "error of the settlements at " + step, u_error[i] / u_error[i - 1], 0.5);
    record.at_most(name + "alternation of p on the axis at " + step, alternating[i] / alternating[i - 1], 0.5);
  }
  record.curve({"undrained layer: p on the axis", "z (m)", "p/q", name + "h = b/8", test.at("z"), p, result.p});
}

TEST(UndrainedLayer, Converges) {
  const Json test = stress_test("b_infsup_strip_on_undrained_layer");
  const std::vector<double> field = undrained(test, 3, 16).field;
  Record record("stress_infsup");
  for (const int degree : {2, 3}) compare_undrained(record, test, degree, field);
}

/// A block of a matrix over the unknowns of two fields.
Eigen::SparseMatrix<double> block(const SparseMatrix& matrix, const std::vector<Field>& field, Field rows,
                                  Field columns) {
  std::vector<int> index(field.size());
  int n_rows = 0, n_columns = 0;
  std::vector<int> column_index(field.size());
  for (std::size_t i = 0; i < field.size(); ++i) {
    index[i] = field[i] == rows ? n_rows++ : -1;
    column_index[i] = field[i] == columns ? n_columns++ : -1;
  }
  std::vector<Eigen::Triplet<double>> entries;
  for (int outer = 0; outer < matrix.outerSize(); ++outer)
    for (SparseMatrix::InnerIterator entry(matrix, outer); entry; ++entry) {
      const int i = index[static_cast<std::size_t>(entry.row())];
      const int j = column_index[static_cast<std::size_t>(entry.col())];
      if (i >= 0 && j >= 0) entries.emplace_back(i, j, entry.value());
    }
  Eigen::SparseMatrix<double> out(n_rows, n_columns);
  out.setFromTriplets(entries.begin(), entries.end());
  return out;
}

double infsup_number(int degree, int n) {
  const LoadedLayer layer{1., 3.};
  Region unit;
  unit.kind = RegionKind::porous;
  unit.shear_modulus = 0.5;
  unit.poissons_ratio = 0.;
  unit.porosity = 0.5;
  unit.grain_density = 1.;
  unit.hydraulic_conductivity = 1.;
  unit.flow = Flow::darcy;
  Scene scene = loaded_layer(unit, 1., PressureCondition::sealed);
  scene.fluid = {1., 0.5};  // 1/Q = n / K_f = 1
  scene.mesh.degree = degree;
  const auto mesh = layer_mesh(layer, even_lines(0., 3., 3 * n), even_lines(-3., 0., 3 * n));
  const Compiled compiled(scene, *mesh);
  const System& system = compiled.system;
  const Field u = Field::displacement, phi = Field::pressure_impulse;
  const Eigen::SparseMatrix<double> B = block(system.C, system.field, phi, u), A = block(system.K, system.field, u, u);
  const Eigen::MatrixXd M_p = -Eigen::MatrixXd(block(system.M, system.field, phi, phi));
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(A);
  const Eigen::MatrixXd B_transposed = Eigen::MatrixXd(B.transpose());
  const Eigen::MatrixXd S = B * Eigen::MatrixXd(factors.solve(B_transposed));
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> eigen(0.5 * (S + S.transpose()), M_p,
                                                                        Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(0., eigen.eigenvalues().minCoeff()));
}

TEST(InfSup, NumberTendsToAConstant) {
  Record record("stress_infsup");
  for (const int degree : {2, 3}) {
    std::vector<double> number;
    for (const int n : {1, 2, 4}) number.push_back(infsup_number(degree, n));
    const std::string name = "degree " + std::to_string(degree) + ": inf-sup number ";
    record.measured(name + "at h = H/12", number[2]);
    record.at_least(name + "at h = H/6 over that at h = H/3", number[1] / number[0], 0.95);
    record.at_least(name + "at h = H/12 over that at h = H/6", number[2] / number[1], 0.95);
  }
}

}  // namespace infsup_test
}  // namespace upbead::test
