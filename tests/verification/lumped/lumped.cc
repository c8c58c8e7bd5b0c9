#include "lumped.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "upbead/model/load.h"

namespace upbead::test {

namespace {

System dense_system(const Eigen::MatrixXd& M, const Eigen::MatrixXd& C, const Eigen::MatrixXd& K, const Vector& b,
                    const TimeFunction& force) {
  System system;
  system.M = M.sparseView();
  system.C = C.sparseView(1., 0.);
  system.K = K.sparseView();
  system.loads.push_back({"force", b, force});
  system.field.assign(static_cast<std::size_t>(M.rows()), Field::displacement);
  return system;
}

Row row(const Eigen::RowVectorXd& weights) {
  Row out;
  for (int i = 0; i < weights.size(); ++i) out.emplace_back(i, weights[i]);
  return out;
}

/// The reading K_i x + C_i x' and its rate K_i x' + C_i x''.
void add_force(System& system, const std::string& name, const Eigen::RowVectorXd& K, const Eigen::RowVectorXd& C) {
  system.readings.push_back({name, "N/m", name, row(K), row(C), {}, {}});
  system.readings.push_back({name + "_rate", "N/(m s)", name, {}, row(K), row(C), {}});
}

Eigen::MatrixXd mass_matrix(const SwayAndRotation& c) {
  const double coupling = c.mass * c.centre_height;
  Eigen::MatrixXd M(2, 2);
  M << c.mass, coupling, coupling, c.moment_of_inertia + coupling * c.centre_height;
  return M;
}

Eigen::MatrixXd stiffness_matrix(const SwayAndRotation& c) {
  return Eigen::Vector2d(c.sway_stiffness, c.rocking_stiffness).asDiagonal();
}

/// Modes, normalised by M, and squares of their circular frequencies.
using Modes = Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>;

/// Largest value of sign * y on a step of length h with y and y' given at both ends, y a cubic.
double cubic_extreme(double h, const Eigen::Vector2d& y, const Eigen::Vector2d& rate, int sign) {
  const double d = y[1] - y[0], r0 = h * rate[0], r1 = h * rate[1];
  const double c2 = 3. * d - 2. * r0 - r1, c3 = r0 + r1 - 2. * d;
  const auto value = [&](double s) { return sign * (y[0] + s * (r0 + s * (c2 + s * c3))); };
  double best = std::max(value(0.), value(1.));
  const double discriminant = c2 * c2 - 3. * c3 * r0;
  if (discriminant < 0.) return best;
  const double q = -(c2 + std::copysign(std::sqrt(discriminant), c2));
  for (const double s : {r0 / q, q / (3. * c3)})
    if (s > 0. && s < 1.) best = std::max(best, value(s));
  return best;
}

}  // namespace

System one_degree(double zeta, const TimeFunction& force) {
  const double omega = 2. * std::acos(-1.);
  const auto one_by_one = [](double value) { return Eigen::MatrixXd::Constant(1, 1, value); };
  const Eigen::MatrixXd C = one_by_one(2. * zeta * omega), K = one_by_one(omega * omega);
  System system = dense_system(one_by_one(1.), C, K, Vector::Ones(1), force);
  add_force(system, "shear_force", K.row(0), C.row(0));
  add_force(system, "spring_force", K.row(0), 0. * C.row(0));
  return system;
}

System two_degrees(const SwayAndRotation& caisson, const TimeFunction& force) {
  const Eigen::MatrixXd M = mass_matrix(caisson), K = stiffness_matrix(caisson);
  const Modes modes(K, M);
  const Eigen::MatrixXd momenta = M * modes.eigenvectors();
  const Eigen::VectorXd damping = 2. * caisson.zeta * modes.eigenvalues().cwiseSqrt();
  const Eigen::MatrixXd C = momenta * damping.asDiagonal() * momenta.transpose();
  System system = dense_system(M, C, K, Eigen::Vector2d(1., caisson.force_height), force);
  add_force(system, "shear_force", K.row(0), C.row(0));
  add_force(system, "base_moment", K.row(1), C.row(1));
  return system;
}

double longer_period(const SwayAndRotation& caisson) {
  const Modes modes(stiffness_matrix(caisson), mass_matrix(caisson));
  return 2. * std::acos(-1.) / std::sqrt(modes.eigenvalues()[0]);
}

Response march_with(SchemeKind kind, const System& system, double end, double step) {
  SchemeOptions options;
  options.kind = kind;
  options.account_energy = false;
  const auto scheme = make_scheme(system, options);
  return march(system, *scheme, make_time_grid(kinks(system), end, step));
}

double extreme(const System& system, const Response& response, const std::string& reading, int sign) {
  const std::vector<double>& time = response.ends.time;
  const Eigen::RowVectorXd y = response.ends.reading.row(system.reading(reading));
  const Eigen::RowVectorXd rate = response.ends.reading.row(system.reading(reading + "_rate"));
  double best = 0.;  // at rest
  for (Eigen::Index n = 0; n + 1 < y.size(); ++n) {
    const double h = time[static_cast<std::size_t>(n + 1)] - time[static_cast<std::size_t>(n)];
    best = std::max(best, cubic_extreme(h, {y[n], y[n + 1]}, {rate[n], rate[n + 1]}, sign));
  }
  return best;
}

TimeFunction ramp(double value, double start, double rise) {
  Pulse shape;
  shape.shape = PulseShape::step;
  shape.peak = value;
  shape.start = start;
  shape.rise = rise;
  return time_function(shape);
}

TimeFunction pulse(double value, double rise, double duration) {
  Pulse shape;
  shape.peak = value;
  shape.rise = rise;
  shape.duration = duration;
  return time_function(shape);
}

std::string title(SchemeKind kind, double steps_a_period) {
  const char* name = kind == SchemeKind::sdirk4 ? "SDIRK4" : "generalised-alpha";
  return name + (", " + std::to_string(std::lround(steps_a_period))) + " steps a period";
}

}  // namespace upbead::test
