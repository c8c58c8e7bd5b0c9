#include "sample_system.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <memory>
#include <random>

#include "upbead/algebra/petsc_session.h"

namespace upbead::test {

namespace {

class Petsc : public testing::Environment {
  void SetUp() override { session_ = std::make_unique<PetscSession>(); }
  void TearDown() override { session_.reset(); }
  std::unique_ptr<PetscSession> session_;
};
[[maybe_unused]] testing::Environment* const petsc = testing::AddGlobalTestEnvironment(new Petsc);

/// Random fill of the blocks of M, C, K, unknowns being u, W, phi in this order.
class Builder {
 public:
  Builder(int n_u, int n_phi) : n_u_(n_u), n_phi_(n_phi), M(zero()), C(zero()), K(zero()) {}
  int size() const { return n_u_ + n_W_ + n_phi_; }

  void fill(const Sample& s) {
    const int W = n_u_, p = n_u_ + n_W_;
    M.topLeftCorner(n_u_, n_u_) = positive(n_u_, 4.);
    couple(M, 0, W, 0.2 * random(n_u_, n_W_));
    couple(C, 0, p, 0.5 * random(n_u_, n_phi_));
    couple(C, W, p, random(n_W_, n_phi_));
    for (int cell = 0; cell < 2; ++cell) {
      M.block(W + 2 * cell, W + 2 * cell, 2, 2) = positive(2, 2.);
      C.block(W + 2 * cell, W + 2 * cell, 2, 2) = s.resistance * positive(2, 2.);
    }
    M.bottomRightCorner(n_phi_, n_phi_) = -s.storage * positive(n_phi_, 2.);
    C.bottomRightCorner(n_phi_, n_phi_) = -s.darcy * positive(n_phi_, 2.);
    C.topLeftCorner(n_u_, n_u_) = s.damping * positive(n_u_, 2.);
    K.topLeftCorner(n_u_, n_u_) = positive(n_u_, 6.);
  }

  /// Unknown order[i] of u, W, phi comes at place i.
  System system(const std::vector<int>& order) const {
    System system;
    Eigen::PermutationMatrix<Eigen::Dynamic> P(size());
    for (int i = 0; i < size(); ++i) P.indices()[order[i]] = i;
    const auto sparse = [&](const Eigen::MatrixXd& A) {
      return SparseMatrix(Eigen::MatrixXd(P * A * P.transpose()).sparseView());
    };
    system.M = sparse(M);
    system.C = sparse(C);
    system.K = sparse(K);
    for (int i : order)
      system.field.push_back(i < n_u_          ? Field::displacement
                             : i < n_u_ + n_W_ ? Field::relative_fluid
                                               : Field::pressure_impulse);
    return system;
  }

 private:
  Eigen::MatrixXd zero() const { return Eigen::MatrixXd::Zero(size(), size()); }
  Eigen::MatrixXd random(int rows, int cols) {
    return Eigen::MatrixXd::NullaryExpr(rows, cols, [&] { return entry_(generator_); });
  }
  Eigen::MatrixXd positive(int n, double diagonal) {
    const Eigen::MatrixXd R = random(n, n);
    return 0.3 * R * R.transpose() + diagonal * Eigen::MatrixXd::Identity(n, n);
  }
  static void couple(Eigen::MatrixXd& A, int row, int col, const Eigen::MatrixXd& block) {
    A.block(row, col, block.rows(), block.cols()) = block;
    A.block(col, row, block.cols(), block.rows()) = block.transpose();
  }

  static constexpr int n_W_ = 4;
  int n_u_, n_phi_;
  std::mt19937 generator_{3};
  std::uniform_real_distribution<double> entry_{-1., 1.};

 public:
  Eigen::MatrixXd M, C, K;
};

}  // namespace

System sample_system(const Sample& sample) {
  const int n_u = 6 + (sample.prescribed_u ? 1 : 0), n_phi = 3 + (sample.prescribed_phi ? 1 : 0);
  Builder builder(n_u, n_phi);
  builder.fill(sample);
  std::vector<int> order, last;
  for (int i = 0; i < builder.size(); ++i) {
    const bool prescribed = (sample.prescribed_u && i == 6) || (sample.prescribed_phi && i == builder.size() - 1);
    (prescribed ? last : order).push_back(i);
  }
  order.insert(order.end(), last.begin(), last.end());
  System system = builder.system(order);
  system.blocks = {{6, 8}, {8, 10}};
  system.n_prescribed = static_cast<int>(last.size());
  for (int i = 0; i < 2; ++i) system.readings.push_back({"u" + std::to_string(i), "m", "", {{i, 1.}}, {}, {}, {}});
  system.readings.push_back({"a0", "m/s2", "", {}, {}, {{0, 1.}}, {}});
  return system;
}

SystemLoad sample_load(const System& system, TimeFunction history) {
  Vector b = Vector::Zero(system.size());
  for (int i = 0; i < system.n_free(); ++i)
    if (system.field[i] != Field::pressure_impulse)
      b[i] = (system.field[i] == Field::displacement ? 1. : 0.2) * std::cos(1. + i);
  return {"load", b, std::move(history), -1};
}

SystemLoad prescribed_load(const System& system, TimeFunction history) {
  return {"given", Vector::Zero(system.size()), std::move(history), system.size() - 1};
}

TimeFunction smooth() {
  return TimeFunction({0.}, {[](double) { return 0.; }, [](double t) { return std::pow(std::sin(t), 4); }});
}

TimeFunction jump() {
  return TimeFunction({0.}, {[](double) { return 0.; }, [](double t) { return std::cos(t); }});
}

State state_at(const System& system, const SchemeOptions& options, double end, int n) {
  const auto scheme = make_scheme(system, options);
  State state = at_rest(system);
  scheme->start(state);
  for (int i = 0; i < n; ++i) {
    state.time = end * i / n;
    scheme->advance(state, end / n);
  }
  return state;
}

double order(const std::vector<int>& n, const std::vector<double>& error) {
  const auto size = static_cast<double>(n.size());
  double x = 0., y = 0., xx = 0., xy = 0.;
  for (std::size_t i = 0; i < n.size(); ++i) {
    const double log_h = -std::log(n[i]), log_error = std::log(error[i]);
    x += log_h / size;
    y += log_error / size;
    xx += log_h * log_h / size;
    xy += log_h * log_error / size;
  }
  return (xy - x * y) / (xx - x * x);
}

std::vector<double> errors(const System& system, const SchemeOptions& options, double end, const std::vector<int>& n,
                           const Vector& reference) {
  std::vector<double> list;
  for (int steps : n) {
    const Vector x = state_at(system, options, end, steps).x;
    list.push_back((x.head(6) - reference.head(6)).norm() / reference.head(6).norm());
  }
  return list;
}

System consolidation(int n, TimeFunction push) {
  using Triplets = std::vector<Eigen::Triplet<double>>;
  Triplets c, k;
  const auto u = [n](int node) { return node < n ? node : -1; };            // fixed at the bottom
  const auto phi = [n](int node) { return node > 0 ? n + node - 1 : -1; };  // drained at the top
  const auto add = [](Triplets& list, int i, int j, double value) {
    if (i >= 0 && j >= 0) list.emplace_back(i, j, value);
  };
  for (int element = 0; element < n; ++element)
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 2; ++b) {
        const int i = element + a, j = element + b;
        const double stiff = n * (a == b ? 1. : -1.), gradient = a == 0 ? -0.5 : 0.5;
        add(k, u(i), u(j), stiff);
        add(c, phi(i), phi(j), -stiff);
        add(c, u(i), phi(j), -gradient);
        add(c, phi(j), u(i), -gradient);
      }
  System system;
  for (SparseMatrix* matrix : {&system.M, &system.C, &system.K}) matrix->resize(2 * n, 2 * n);
  system.C.setFromTriplets(c.begin(), c.end());
  system.K.setFromTriplets(k.begin(), k.end());
  system.field.assign(n, Field::displacement);
  system.field.resize(2 * n, Field::pressure_impulse);
  system.loads.push_back({"push", Vector::Unit(2 * n, 0), std::move(push), -1});
  return system;
}

System oscillator(double m, double c, double k, TimeFunction f) {
  System system;
  const auto scalar = [](double value) { return SparseMatrix(Eigen::MatrixXd::Constant(1, 1, value).sparseView()); };
  system.M = scalar(m);
  system.C = scalar(c);
  system.K = scalar(k);
  system.field = {Field::displacement};
  system.loads.push_back({"force", Vector::Ones(1), std::move(f), -1});
  system.readings.push_back({"x", "m", "", {{0, 1.}}, {}, {}, {}});
  return system;
}

}  // namespace upbead::test
