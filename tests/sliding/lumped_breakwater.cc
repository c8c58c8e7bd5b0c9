#include "lumped_breakwater.h"

#include <Eigen/Dense>

#include "../dynamics/reduction_tools.h"
#include "lumped.h"

namespace upbead::test {

namespace {

constexpr double half_width = 8., arm_of_bottom = 9., arm_of_load = 2.;

/// Soil in its own coordinates: three columns of nodes from the base up, then the pores of two of them.
class Soil {
 public:
  Soil(int layers, double damping_time)
      : n_(layers), M(zero()), C(zero()), K(zero()), uplift(Eigen::RowVectorXd::Zero(5 * n_)) {
    add_column(0, 6e4, 3.5e8 * n_);
    add_column(n_, 3e4, 4e8 * n_);
    add_column(2 * n_, 3e4, 5.2e8 * n_);
    C = damping_time * K;
    add_pores(n_, 3 * n_);
    add_pores(2 * n_, 4 * n_);
  }

 private:
  Eigen::MatrixXd zero() const { return Eigen::MatrixXd::Zero(5 * n_, 5 * n_); }

  /// Masses of the nodes, springs between them.
  void add_column(int first, double mass, double stiffness) {
    for (int i = 0; i < n_; ++i) {
      M(first + i, first + i) += i + 1 < n_ ? mass : 0.5 * mass;
      K(first + i, first + i) += stiffness;
      if (i == 0) continue;
      K(first + i - 1, first + i - 1) += stiffness;
      K(first + i, first + i - 1) = K(first + i - 1, first + i) = -stiffness;
    }
  }

  /// Pressure of each layer over the half width; water flows from layer to layer, and slowly out of each.
  void add_pores(int column, int first) {
    constexpr double storage = 2e-8, flow = 2e-7, leak = 1e-8;
    for (int i = 0; i < n_; ++i) {
      const int p = first + i, above = column + i;
      M(p, p) = -storage / n_;
      C(p, p) -= flow * n_ * (i == 0 ? 1. : 2.) + leak;
      if (i > 0) C(p, p - 1) = C(p - 1, p) = flow * n_;
      C(above, p) = C(p, above) = -half_width;
      if (i > 0) C(above - 1, p) = C(p, above - 1) = half_width;
    }
    uplift[first + n_ - 1] = half_width;
  }

  int n_;

 public:
  Eigen::MatrixXd M, C, K;
  Eigen::RowVectorXd uplift;
};

/// The soil's coordinates from those of the system: nodes below the top, pores, x, y, rotation, s.
Eigen::MatrixXd ties(int n) {
  const int below = n - 1, own = 3 * below + 2 * n, x = own;
  Eigen::MatrixXd T = Eigen::MatrixXd::Zero(5 * n, own + 4);
  for (int column = 0; column < 3; ++column) T.block(column * n, column * below, below, below).setIdentity();
  T.block(3 * n, 3 * below, 2 * n, 2 * n).setIdentity();
  T.row(n - 1).segment(x, 4) << 1., 0., -arm_of_bottom, -1.;
  T.row(2 * n - 1).segment(x, 4) << 0., 1., half_width, 0.;
  T.row(3 * n - 1).segment(x, 4) << 0., 1., -half_width, 0.;
  return T;
}

Row row(const Eigen::RowVectorXd& dense) {
  Row sparse;
  for (Eigen::Index i = 0; i < dense.size(); ++i)
    if (dense[i] != 0.) sparse.emplace_back(static_cast<int>(i), dense[i]);
  return sparse;
}

}  // namespace

System LumpedBreakwater::system() const {
  const Soil soil(layers, damping_time);
  const Eigen::MatrixXd T = ties(layers);
  const auto tied = [&](const Eigen::MatrixXd& A) -> Eigen::MatrixXd { return T.transpose() * A * T; };
  const int size = static_cast<int>(T.cols()), x = size - 4, y = size - 3, rotation = size - 2;
  Eigen::MatrixXd M = tied(soil.M), C = tied(soil.C), K = tied(soil.K);
  const Reading normal{"normal_force", "N/m", "", row(-K.row(y)), row(-C.row(y)), row(-M.row(y)), {}};
  M(x, x) += mass;
  M(y, y) += mass;
  M(rotation, rotation) += 60. * mass;
  System system;
  system.M = M.sparseView();
  system.C = C.sparseView();
  system.K = K.sparseView();
  system.field.assign(static_cast<std::size_t>(size), Field::displacement);
  for (int i = 3 * (layers - 1); i < x; ++i) system.field[static_cast<std::size_t>(i)] = Field::pressure_impulse;
  Vector load = Vector::Zero(size);
  load[x] = 1.;
  load[rotation] = arm_of_load;
  system.loads.push_back({"impact", load, TimeFunction(), -1});
  system.readings = {normal,
                     {"uplift", "N/m", "", {}, row(soil.uplift * T), {}, {}},
                     {"x", "m", "", {{x, 1.}}, {}, {}, {}},
                     {"velocity", "m/s", "", {}, {{x, 1.}}, {}, {}}};
  return system;
}

SlipModel LumpedBreakwater::model(double friction) const {
  constexpr double shift = 40.;
  System slipping = system();
  add_slip(slipping, slipping.n_free() - 1);
  return slip_model(scaled(whole(slipping, shift)),
                    {friction, {{lumped_normal, 1.}, {lumped_uplift, -1.}}, {lumped_x, lumped_velocity}});
}

}  // namespace upbead::test
