#include "fem/impedance.h"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <cmath>

namespace upbead {

namespace {

/// Plane waves in a porous soil without drag: M x'' = A d2x/dn2 for x = (u_n, W_n).
struct DragFree {
  explicit DragFree(const Material& m) {
    const double E = m.constrained_modulus(), Q = 1. / m.storage;
    M << m.rho, m.rho_f, m.rho_f, m.a;
    A << E + m.alpha * m.alpha * Q, m.alpha * Q, m.alpha * Q, Q;
  }
  Eigen::Matrix2d M, A;
};

/// Z = M^1/2 (M^-1/2 A M^-1/2)^1/2 M^1/2.
Impedance drag_free_impedance(const Material& m) {
  const auto [M, A] = DragFree(m);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> of_M(M);
  const Eigen::Matrix2d root = of_M.operatorSqrt(), inverse = of_M.operatorInverseSqrt();
  const Eigen::Matrix2d speed =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(Eigen::Matrix2d(inverse * A * inverse)).operatorSqrt();
  const Eigen::Matrix2d Z = root * speed * root;
  Impedance z;
  z.normal = Z(0, 0) - Z(0, 1) * Z(0, 1) / Z(1, 1);
  z.coupling = Z(0, 1) / Z(1, 1);
  z.mobility = 1. / Z(1, 1);
  z.tangential = std::sqrt((m.rho - m.rho_f * m.rho_f / m.a) * m.G);
  return z;
}

}  // namespace

Impedance impedance(const Material& m, CellKind kind, bool open_to_waves) {
  if (kind == CellKind::inertial && open_to_waves) return drag_free_impedance(m);
  Impedance z;
  if (kind == CellKind::water) {
    if (open_to_waves) z.mobility = std::sqrt(m.storage / m.rho_f);
    return z;
  }
  const bool pores = kind == CellKind::inertial || kind == CellKind::darcy;
  z.normal = std::sqrt(m.rho * (m.constrained_modulus() + (pores ? m.alpha * m.alpha / m.storage : 0.)));
  z.tangential = std::sqrt(m.rho * m.G);
  return z;
}

double fastest_wave(const Region& region, const Fluid& fluid, double gravity) {
  const Material m = material(region, fluid, gravity);
  if (region.kind == RegionKind::rigid) return 0.;
  if (region.kind == RegionKind::water) return std::sqrt(1. / (m.storage * m.rho_f));
  const double E = m.constrained_modulus();
  if (region.kind == RegionKind::solid || region.flow == Flow::drained) return std::sqrt(E / m.rho);
  const double undrained = std::sqrt((E + m.alpha * m.alpha / m.storage) / m.rho);
  if (region.flow != Flow::inertial || std::isinf(undrained)) return undrained;
  const auto [M, A] = DragFree(m);
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix2d> squares(A, M);
  return std::sqrt(squares.eigenvalues().maxCoeff());
}

}  // namespace upbead
