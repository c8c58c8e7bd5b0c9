#include "lumped.h"

#include <Eigen/Dense>
#include <algorithm>

#include "../dynamics/reduction_tools.h"

namespace upbead::test {

namespace {

SparseMatrix sparse(const Eigen::MatrixXd& A) {
  return A.sparseView();
}

}  // namespace

System block_on_base(double mass, const ElasticBase& base) {
  Eigen::Matrix2d relative;
  relative << 1., -1., -1., 1.;
  System system;
  Eigen::Matrix2d M = base.mass * relative;
  M(0, 0) += mass;
  system.M = sparse(M);
  system.C = sparse(base.damping * relative);
  system.K = sparse(base.stiffness * relative);
  system.field.assign(2, Field::displacement);
  system.loads.push_back({"force", Vector::Unit(2, 0), TimeFunction(), -1});
  system.readings.push_back({"x", "m", "", {{0, 1.}}, {}, {}, {}});
  return system;
}

System block_on_wedge(double mass, const ElasticBase& base, double coupling) {
  Eigen::MatrixXd T(2, 3), k(2, 2);
  T << 1., 0., -1., 0., 1., 0.;
  k << base.stiffness, coupling, coupling, 2. * base.stiffness;
  const Eigen::MatrixXd M = base.mass * T.transpose() * T, K = T.transpose() * k * T;
  const Eigen::MatrixXd C = base.damping / base.stiffness * K;
  System system;
  system.M = sparse(M + mass * Eigen::Vector3d(1., 1., 0.).asDiagonal().toDenseMatrix());
  system.C = sparse(C);
  system.K = sparse(K);
  system.field.assign(3, Field::displacement);
  system.loads.push_back({"force", Vector::Unit(3, 0), TimeFunction(), -1});
  const auto row = [](const Eigen::MatrixXd& A) { return Row{{0, -A(1, 0)}, {1, -A(1, 1)}, {2, -A(1, 2)}}; };
  system.readings.push_back({"normal_force", "N/m", "", row(K), row(C), row(M), {}});
  for (const auto& [i, name] : {std::pair{0, "x'"}, {1, "y'"}, {2, "s'"}})
    system.readings.push_back({name, "m/s", "", {}, {{i, 1.}}, {}, {}});
  return system;
}

System block_on_rock(double mass) {
  System system;
  system.M = sparse(Eigen::MatrixXd::Constant(1, 1, mass));
  system.C = system.K = SparseMatrix(1, 1);
  system.field = {Field::displacement};
  system.loads.push_back({"force", Vector::Ones(1), TimeFunction(), -1});
  return system;
}

ReducedSystem scaled(ReducedSystem r) {
  const Eigen::MatrixXd T = r.shift * r.shift * r.M + r.shift * r.C + r.K;
  const Eigen::VectorXd unit = T.diagonal().cwiseAbs().cwiseSqrt().cwiseInverse();
  for (Eigen::MatrixXd* A : {&r.M, &r.C, &r.K}) *A = Eigen::MatrixXd(unit.asDiagonal() * *A * unit.asDiagonal());
  r.load = Eigen::MatrixXd(unit.asDiagonal() * r.load);
  for (Eigen::MatrixXd* A : {&r.position, &r.velocity, &r.acceleration}) *A = Eigen::MatrixXd(*A * unit.asDiagonal());
  return r;
}

SlipModel in_modes(System system, double friction, double shift, const std::vector<int>& wanted, int normal) {
  add_slip(system, system.n_free() - 1);
  SlipLaw law{friction, {}, wanted};
  if (normal >= 0) law.normal_force = {{normal, 1.}};
  return slip_model(scaled(whole(system, shift)), law);
}

WaveSamples samples(const History& force, double normal, double step, int n) {
  WaveSamples loads(2, n);
  std::size_t next = 0;
  for (int i = 0; i < n; ++i) {
    const double t = i * step;
    while (next < force.time.size() && force.time[next] <= t) ++next;
    loads(0, i) = 0.;
    if (next > 0 && next < force.time.size()) {
      const double begin = force.time[next - 1], part = (t - begin) / (force.time[next] - begin);
      loads(0, i) = (1. - part) * force.value[next - 1] + part * force.value[next];
    }
    loads(1, i) = normal;
  }
  return loads;
}

}  // namespace upbead::test
