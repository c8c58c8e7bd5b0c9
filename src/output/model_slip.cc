#include "model_parts.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "dynamics/slip_model.h"
#include "fem/caisson/reading_names.h"

namespace upbead::detail {

namespace {

const std::string group = "/slip";

const auto fields_of_slip = [](auto& slip, const auto& visit) {
  visit("n_prescribed", slip.system.n_prescribed);
  visit("shift", slip.system.shift);
  visit("error", slip.error);
  visit("glued_error", slip.glued_error);
  visit("vectors", slip.vectors);
  visit("solves", slip.solves);
};

/// Writes the equations of R coordinates, with K loads.
void write_equations(Hdf5Image& image, const ReducedSystem& s) {
  const Label by_term{"", "of M q'' + C q' + K q = sum_k load_k f_k"};
  write_matrix(image, group + "/M", s.M, by_term);
  write_matrix(image, group + "/C", s.C, by_term);
  write_matrix(image, group + "/K", s.K, by_term);
  write_matrix(image, group + "/load", s.load, by_term);
  const std::vector<double> is_phi(s.is_phi.begin(), s.is_phi.end());
  image.numbers(group + "/is_phi", {is_phi.size()}, is_phi.data(),
                {"1",
                 "1: a coordinate of the integrated pore pressure, row of the equation multiplied by -1; 0: of "
                 "displacements"});
  const std::vector<double> prescribed(s.prescribed.begin(), s.prescribed.end());
  image.numbers(group + "/prescribed", {prescribed.size()}, prescribed.data(),
                {"1", "coordinate whose velocity the load prescribes; -1: none"});
  image.texts(group + "/load_name", s.load_name);
}

void write_readings(Hdf5Image& image, const ReducedSystem& s) {
  const std::string what = "of y = position q + velocity q' + acceleration q'' + feedthrough f";
  write_matrix(image, group + "/position", s.position, {"", what});
  write_matrix(image, group + "/velocity", s.velocity, {"", what});
  write_matrix(image, group + "/acceleration", s.acceleration, {"", what});
  write_matrix(image, group + "/feedthrough", s.feedthrough, {"unit of the reading / unit of the load", what});
  write_labels(image, group + "/readings", s.reading_label);
}

void read_equations(ModelParts& parts, ReducedSystem& s) {
  const std::size_t size = parts.length(group + "/is_phi");
  for (const int phi : read_indices(parts, group + "/is_phi", size, 0, 2)) s.is_phi.push_back(phi == 1);
  s.load_name = parts.texts(group + "/load_name");
  s.M = parts.matrix(group + "/M", size, size);
  s.C = parts.matrix(group + "/C", size, size);
  s.K = parts.matrix(group + "/K", size, size);
  s.load = parts.matrix(group + "/load", size, s.load_name.size());
  s.prescribed = read_indices(parts, group + "/prescribed", s.load_name.size(), -1, s.size());
}

void read_readings(ModelParts& parts, ReducedSystem& s) {
  const auto size = static_cast<std::size_t>(s.size());
  s.reading_label = read_labels(parts, group + "/readings");
  const std::size_t n = s.reading_label.size();
  s.position = parts.matrix(group + "/position", n, size);
  s.velocity = parts.matrix(group + "/velocity", n, size);
  s.acceleration = parts.matrix(group + "/acceleration", n, size);
  s.feedthrough = parts.matrix(group + "/feedthrough", n, s.load_name.size());
}

bool is_symmetric(const Eigen::MatrixXd& matrix) {
  constexpr double round_off = 1e-8;
  return matrix.size() == 0 ||
         (matrix - matrix.transpose()).cwiseAbs().maxCoeff() <= round_off * matrix.cwiseAbs().maxCoeff();
}

/// Whether the symmetric part has no negative eigenvalue; those by which projection misses zero are far smaller than
/// the tolerance.
bool is_positive(const Eigen::MatrixXd& matrix) {
  constexpr double round_off = 1e-8;
  const double scale = matrix.size() == 0 ? 0. : matrix.cwiseAbs().maxCoeff();
  if (scale == 0.) return true;
  const Eigen::MatrixXd part = (matrix + matrix.transpose()) / (2. * scale);
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(part, Eigen::EigenvaluesOnly).eigenvalues().minCoeff() >=
         -round_off * static_cast<double>(part.rows());
}

/// With the rows of phi multiplied by -1 all three matrices are positive, see ReducedSystem. The rows of prescribed
/// coordinates are left out, as they are no equations.
void require_energies(ModelParts& parts, const ReducedSystem& s) {
  const auto n = static_cast<Eigen::Index>(s.size() - std::clamp(s.n_prescribed, 0, s.size()));
  Eigen::VectorXd sign(s.size());
  for (int i = 0; i < s.size(); ++i) sign[i] = s.is_phi[static_cast<std::size_t>(i)] ? -1. : 1.;
  const auto equations = [n](const Eigen::MatrixXd& matrix) -> Eigen::MatrixXd {
    return matrix.bottomRightCorner(n, n);
  };
  const auto signed_equations = [&](const Eigen::MatrixXd& matrix) -> Eigen::MatrixXd {
    return equations(sign.asDiagonal() * matrix);
  };
  if (!is_symmetric(equations(s.M)) || !is_positive(signed_equations(s.M)))
    parts.wrong(group + "/M is not that of a kinetic energy: not symmetric, or negative");
  if (!is_positive(signed_equations(s.C))) parts.wrong(group + "/C brings energy in");
  if (!is_symmetric(equations(s.K)) || !is_positive(signed_equations(s.K)))
    parts.wrong(group + "/K is not that of a strain energy: not symmetric, or negative");
}

/// Checks what slip_model() assumes.
void require_slip(ModelParts& parts, const ReducedSystem& s) {
  require_prescribed(parts, group, s);
  require_energies(parts, s);
  if (s.load_name.empty() || s.load_name.back() != slip_name::friction)
    parts.wrong(group + "/load_name does not end with '" + slip_name::friction + "'");
  for (const char* name : {reading::normal_force, slip_name::slip, slip_name::velocity})
    if (std::none_of(s.reading_label.begin(), s.reading_label.end(),
                     [name](const ReadingLabel& label) { return label.name == name; }))
      parts.wrong(group + "/readings/name does not name '" + name + "'");
}

}  // namespace

void write_slip(Hdf5Image& image, const ModelSlip& slip) {
  image.group(group);
  write_equations(image, slip.system);
  write_readings(image, slip.system);
  write_attributes(image, group, fields_of_slip, slip);
}

std::optional<ModelSlip> read_slip(ModelParts& parts) {
  if (!parts.has(group, "error")) return std::nullopt;
  ModelSlip slip;
  read_equations(parts, slip.system);
  read_readings(parts, slip.system);
  read_attributes(parts, group, fields_of_slip, slip);
  require_slip(parts, slip.system);
  return slip;
}

}  // namespace upbead::detail
