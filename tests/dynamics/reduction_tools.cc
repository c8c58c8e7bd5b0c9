#include "reduction_tools.h"

#include <Eigen/Dense>
#include <algorithm>
#include <numeric>

#include "dynamics/projection.h"
#include "dynamics/state_space.h"

namespace upbead::test {

namespace {

Eigen::MatrixXd rows(const System& system, Row Reading::*part, const std::vector<int>& order) {
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(system.readings.size()), system.size());
  for (std::size_t i = 0; i < system.readings.size(); ++i)
    for (const auto& [j, weight] : system.readings[i].*part) A(static_cast<Eigen::Index>(i), j) += weight;
  return A(Eigen::all, order);
}

}  // namespace

ReducedSystem whole(const System& system, double shift) {
  std::vector<int> order(static_cast<std::size_t>(system.size()));
  std::iota(order.begin(), order.end(), 0);
  std::rotate(order.begin(), order.begin() + system.n_free(), order.end());
  ReducedSystem r;
  r.shift = shift;
  r.n_prescribed = system.n_prescribed;
  r.M = Eigen::MatrixXd(system.M)(order, order);
  r.C = Eigen::MatrixXd(system.C)(order, order);
  r.K = Eigen::MatrixXd(system.K)(order, order);
  const auto I = static_cast<Eigen::Index>(system.readings.size()), n = static_cast<Eigen::Index>(system.loads.size());
  r.load.resize(system.size(), n);
  r.feedthrough.setZero(I, n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const SystemLoad& load = system.loads[static_cast<std::size_t>(k)];
    r.load.col(k) = load.vector(order);
    r.prescribed.push_back(load.prescribed < 0 ? -1 : load.prescribed - system.n_free());
    r.load_name.push_back(load.name);
  }
  r.position = rows(system, &Reading::position, order);
  r.velocity = rows(system, &Reading::velocity, order);
  r.acceleration = rows(system, &Reading::acceleration, order);
  for (Eigen::Index i = 0; i < I; ++i) {
    const Reading& reading = system.readings[static_cast<std::size_t>(i)];
    for (std::size_t k = 0; k < reading.feedthrough.size(); ++k)
      r.feedthrough(i, static_cast<Eigen::Index>(k)) = reading.feedthrough[k];
    r.reading_label.push_back({reading.name.text(), reading.unit, reading.description});
  }
  for (const int i : order) r.is_phi.push_back(system.field[static_cast<std::size_t>(i)] == Field::pressure_impulse);
  return r;
}

ReducedSystem reduced(const System& system, double shift, int most_vectors) {
  SecondOrderKrylov krylov(system, shift);
  while (krylov.n_vectors() < most_vectors && krylov.extend()) continue;
  return Projection(system, krylov).reduced();
}

ModalModel modes_of(const ReducedSystem& reduced) {
  return modal_model(state_space(reduced), reduced);
}

Eigen::MatrixXcd transfer(const ReducedSystem& r, std::complex<double> s) {
  const Eigen::Index p = r.n_prescribed, n = r.size() - p;
  const Eigen::MatrixXcd T = s * s * r.M + s * r.C + r.K;
  Eigen::MatrixXcd X = Eigen::MatrixXcd::Zero(r.size(), r.load.cols());
  for (std::size_t k = 0; k < r.prescribed.size(); ++k)
    if (r.prescribed[k] >= 0) X(r.prescribed[k], static_cast<Eigen::Index>(k)) = 1. / s;
  const Eigen::MatrixXcd rhs = r.load.bottomRows(n) - T.bottomLeftCorner(n, p) * X.topRows(p);
  X.bottomRows(n) = T.bottomRightCorner(n, n).completeOrthogonalDecomposition().solve(rhs);
  return (r.position + s * r.velocity + s * s * r.acceleration) * X + r.feedthrough;
}

Eigen::MatrixXcd transfer(const ModalModel& model, std::complex<double> s) {
  Eigen::MatrixXcd H(model.n_readings(), model.n_loads());
  for (int i = 0; i < H.rows(); ++i)
    for (int k = 0; k < H.cols(); ++k) H(i, k) = model.transfer(i, k, s);
  return H;
}

double relative(const Eigen::MatrixXcd& found, const Eigen::MatrixXcd& expected) {
  return (found - expected).norm() / expected.norm();
}

System loaded_sample(const Sample& sample, const TimeFunction& history) {
  System system = sample_system(sample);
  SystemLoad on_all = sample_load(system, history), on_one = on_all, on_phi = on_all;
  on_one.vector = Vector::Unit(system.size(), 2);
  on_phi.vector.setZero();
  for (int i = 0; i < system.n_free(); ++i)
    if (system.field[static_cast<std::size_t>(i)] == Field::pressure_impulse) on_phi.vector[i] = std::sin(2. + i);
  system.loads = {on_all, on_one, on_phi};
  system.readings.push_back({"v1", "m/s", "", {}, {{1, 1.}}, {}, {0.7, 0.3, 0.}});
  system.readings.push_back({"phi", "Pa s", "", {}, {{10, 1.}, {11, -0.5}}, {}, {}});
  return system;
}

System chain(int n, double storage, double darcy, double damping) {
  Eigen::MatrixXd strain = Eigen::MatrixXd::Identity(n, n);  // of cell i: u_i - u_(i-1), u_(-1) = 0
  for (int i = 1; i < n; ++i) strain(i, i - 1) = -1.;
  const Eigen::MatrixXd K_uu = strain.transpose() * strain;
  Eigen::MatrixXd M = Eigen::MatrixXd::Zero(2 * n, 2 * n), C = M, K = M;
  M.topLeftCorner(n, n).setIdentity();
  M.bottomRightCorner(n, n).diagonal().setConstant(-storage);
  C.topLeftCorner(n, n) = damping * K_uu;
  C.topRightCorner(n, n) = 0.5 * strain.transpose();
  C.bottomLeftCorner(n, n) = 0.5 * strain;
  C.bottomRightCorner(n, n) = -darcy * strain * strain.transpose();
  K.topLeftCorner(n, n) = K_uu;
  System system;
  system.M = M.sparseView();
  system.C = C.sparseView();
  system.K = K.sparseView();
  system.field.assign(static_cast<std::size_t>(n), Field::displacement);
  system.field.insert(system.field.end(), static_cast<std::size_t>(n), Field::pressure_impulse);
  system.loads.push_back({"top", Vector::Unit(2 * n, n - 1), hat(), -1});
  system.readings.push_back({"top", "m", "", {{n - 1, 1.}}, {}, {}, {}});
  system.readings.push_back({"pressure", "Pa", "", {}, {{n + n / 2, 1.}}, {}, {}});
  return system;
}

TimeFunction hat() {
  return piecewise_linear({0., 1., 2.}, {0., 1., 0.});
}

Series marched(const System& system, double end, int n) {
  const auto scheme = make_scheme(system, {SchemeKind::sdirk4, 0., false});
  return march(system, *scheme, {{{0., end / n, n}}, end}).ends;
}

Eigen::MatrixXd responded(const ModalModel& model, const System& system, const std::vector<double>& time) {
  std::vector<TimeFunction> histories;
  for (const SystemLoad& load : system.loads) histories.push_back(load.history);
  return respond(model, sample(histories, time)).reading;
}

double error(const Eigen::MatrixXd& found, const Eigen::MatrixXd& expected) {
  const Eigen::VectorXd peak = expected.cwiseAbs().rowwise().maxCoeff();
  return (found - expected).cwiseAbs().rowwise().maxCoeff().cwiseQuotient(peak).maxCoeff();
}

}  // namespace upbead::test
