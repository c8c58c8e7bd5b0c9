#include "dynamics/reduced_family.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "algebra/dense.h"

namespace upbead {

namespace {

/// Calls visit(matrix of one, of other) for all that a family sums.
template <class One, class Other, class Visit>
void for_each_summed(One& one, Other& other, const Visit& visit) {
  visit(one.M, other.M);
  visit(one.C, other.C);
  visit(one.K, other.K);
  visit(one.position, other.position);
  visit(one.velocity, other.velocity);
  visit(one.acceleration, other.acceleration);
}

/// Of the coordinates of `member`, those that remain.
ReducedSystem selected(const ReducedSystem& member, const std::vector<int>& coordinates) {
  ReducedSystem out = member;
  for (Eigen::MatrixXd* A : {&out.M, &out.C, &out.K}) *A = (*A)(coordinates, coordinates).eval();
  for (Eigen::MatrixXd* rows : {&out.position, &out.velocity, &out.acceleration})
    *rows = (*rows)(Eigen::all, coordinates).eval();
  out.load = out.load(coordinates, Eigen::all).eval();
  out.is_phi.clear();
  for (const int i : coordinates) out.is_phi.push_back(member.is_phi[static_cast<std::size_t>(i)]);
  return out;
}

/// The coordinates of u with W, and those of phi.
std::array<std::vector<int>, 2> by_kind(const std::vector<bool>& is_phi) {
  std::array<std::vector<int>, 2> list;
  for (std::size_t i = 0; i < is_phi.size(); ++i) list[is_phi[i] ? 1 : 0].push_back(static_cast<int>(i));
  return list;
}

/// R^T A R of a symmetric A by its blocks, as R mixes no kinds: most parts of a family have a single one.
Eigen::MatrixXd rotated_by_kind(const Eigen::MatrixXd& A, const std::array<std::vector<int>, 2>& from,
                                const std::array<std::vector<int>, 2>& to, const std::array<Eigen::MatrixXd, 2>& R) {
  const auto n = static_cast<Eigen::Index>(to[0].size() + to[1].size());
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(n, n);
  for (std::size_t a = 0; a < 2; ++a)
    for (std::size_t b = a; b < 2; ++b) {
      const Eigen::MatrixXd block = A(from[a], from[b]);
      if (block.isZero(0.)) continue;
      const Eigen::MatrixXd turned = transposed_product(R[a], product(block, R[b]));
      out(to[a], to[b]) = turned;
      if (a != b) out(to[b], to[a]) = turned.transpose();
    }
  return out;
}

/// `order[i]` is the coordinate of unknown i.
SparseMatrix dense_pattern(const Eigen::MatrixXd& A, const std::vector<int>& order) {
  return Eigen::MatrixXd(A(order, order)).sparseView(0., 0.);
}

Row row_of(const Eigen::MatrixXd& rows, Eigen::Index i, const std::vector<int>& order) {
  Row row;
  for (std::size_t j = 0; j < order.size(); ++j)
    if (const double weight = rows(i, order[j]); weight != 0.) row.emplace_back(static_cast<int>(j), weight);
  return row;
}

}  // namespace

ReducedSystem ReducedFamily::at(const std::vector<double>& factors) const {
  if (factors.size() != parts.size()) throw std::invalid_argument("a sum of systems needs a factor for each part");
  ReducedSystem member = fixed;
  for (std::size_t q = 0; q < parts.size(); ++q)
    for_each_summed(member, parts[q], [&](Eigen::MatrixXd& sum, const Eigen::MatrixXd& part) {
      if (part.size() > 0) sum += factors[q] * part;
    });
  return member;
}

ReducedSystem ReducedFamily::bonded(const std::vector<double>& factors, double share) const {
  ReducedSystem member = at(factors);
  if (share < 1.) member = leading(member, n_kept, share);
  return slips() ? holding(member, n_kept - 1, slip_loads, slip_readings) : member;
}

ReducedSystem rotated(const ReducedSystem& member, const Eigen::MatrixXd& rotation) {
  ReducedSystem out = member;
  out.is_phi.assign(static_cast<std::size_t>(rotation.cols()), false);
  for (Eigen::Index j = 0; j < rotation.cols(); ++j) {
    Eigen::Index largest = 0;
    rotation.col(j).cwiseAbs().maxCoeff(&largest);
    out.is_phi[static_cast<std::size_t>(j)] = member.is_phi[static_cast<std::size_t>(largest)];
  }
  const std::array<std::vector<int>, 2> from = by_kind(member.is_phi), to = by_kind(out.is_phi);
  const std::array<Eigen::MatrixXd, 2> of_kind{rotation(from[0], to[0]), rotation(from[1], to[1])};
  for (Eigen::MatrixXd* A : {&out.M, &out.C, &out.K})
    if (A->size() > 0) *A = rotated_by_kind(*A, from, to, of_kind);
  for (Eigen::MatrixXd* rows : {&out.position, &out.velocity, &out.acceleration})
    if (rows->size() > 0) *rows = product(*rows, rotation);
  out.load = transposed_product(rotation, member.load);
  return out;
}

ReducedFamily rotated(const ReducedFamily& family, const Eigen::MatrixXd& rotation) {
  ReducedFamily out{
      rotated(family.fixed, rotation), {}, family.n_kept, family.slip_loads, family.slip_readings, family.safety};
  for (const ReducedSystem& part : family.parts) out.parts.push_back(rotated(part, rotation));
  return out;
}

ReducedSystem leading(const ReducedSystem& member, int n_kept, double share) {
  int of_kind[2] = {0, 0}, taken[2] = {0, 0};
  for (int i = n_kept; i < member.size(); ++i) ++of_kind[member.is_phi[static_cast<std::size_t>(i)] ? 1 : 0];
  std::vector<int> remaining;
  for (int i = 0; i < member.size(); ++i) {
    const int kind = member.is_phi[static_cast<std::size_t>(i)] ? 1 : 0;
    if (i < n_kept || taken[kind]++ < static_cast<int>(std::ceil(share * of_kind[kind]))) remaining.push_back(i);
  }
  return selected(member, remaining);
}

ReducedSystem without_last(ReducedSystem member, int loads, int readings) {
  const Eigen::Index n_loads = member.load.cols() - loads, n_readings = member.position.rows() - readings;
  member.load.conservativeResize(Eigen::NoChange, n_loads);
  for (Eigen::MatrixXd* rows : {&member.position, &member.velocity, &member.acceleration})
    rows->conservativeResize(n_readings, Eigen::NoChange);
  member.feedthrough.conservativeResize(n_readings, n_loads);
  member.prescribed.resize(static_cast<std::size_t>(n_loads));
  member.load_name.resize(static_cast<std::size_t>(n_loads));
  member.reading_label.resize(static_cast<std::size_t>(n_readings));
  return member;
}

ReducedSystem holding(const ReducedSystem& member, int coordinate, int fewer_loads, int fewer_readings) {
  std::vector<int> remaining;
  for (int i = 0; i < member.size(); ++i)
    if (i != coordinate) remaining.push_back(i);
  return without_last(selected(member, remaining), fewer_loads, fewer_readings);
}

ReducedSystem with_readings(ReducedSystem member, const Eigen::MatrixXd& sums, std::vector<ReadingLabel> labels) {
  for (Eigen::MatrixXd* rows : {&member.position, &member.velocity, &member.acceleration, &member.feedthrough})
    *rows = (sums * *rows).eval();
  member.reading_label = std::move(labels);
  return member;
}

System names_of(const ReducedSystem& member, const std::vector<SystemLoad>& loads) {
  System names;
  names.loads = loads;
  for (std::size_t i = 0; i < member.reading_label.size(); ++i) {
    const ReadingLabel& label = member.reading_label[i];
    const Eigen::RowVectorXd direct = member.feedthrough.row(static_cast<Eigen::Index>(i));
    names.readings.push_back({label.name, label.unit, label.description, {}, {}, {}, {direct.begin(), direct.end()}});
  }
  return names;
}

int unknown_of(const ReducedSystem& member, int coordinate) {
  const int p = member.n_prescribed;
  return coordinate < p ? member.size() - p + coordinate : coordinate - p;
}

System as_system(const ReducedSystem& member, const System& of) {
  std::vector<int> order(static_cast<std::size_t>(member.size()));
  for (int i = 0; i < member.size(); ++i) order[static_cast<std::size_t>(unknown_of(member, i))] = i;
  System system;
  system.M = dense_pattern(member.M, order);
  system.C = dense_pattern(member.C, order);
  system.K = dense_pattern(member.K, order);
  system.n_prescribed = member.n_prescribed;
  for (const int i : order)
    system.field.push_back(member.is_phi[static_cast<std::size_t>(i)] ? Field::pressure_impulse : Field::displacement);
  for (std::size_t k = 0; k < of.loads.size(); ++k) {
    SystemLoad load = of.loads[k];
    load.vector = member.load.col(static_cast<Eigen::Index>(k))(order);
    if (load.prescribed >= 0) load.prescribed = unknown_of(member, member.prescribed[k]);
    system.loads.push_back(std::move(load));
  }
  for (std::size_t i = 0; i < of.readings.size(); ++i) {
    Reading reading = of.readings[i];
    const auto at = static_cast<Eigen::Index>(i);
    reading.position = row_of(member.position, at, order);
    reading.velocity = row_of(member.velocity, at, order);
    reading.acceleration = row_of(member.acceleration, at, order);
    reading.nodal_forces.clear();
    system.readings.push_back(std::move(reading));
  }
  return system;
}

FieldBasis of_bonded_members(FieldBasis phi, const ReducedFamily& family) {
  const int held = family.slips() ? family.n_kept - 1 : family.fixed.size();
  const int size = family.fixed.size() - (family.slips() ? 1 : 0), p = family.fixed.n_prescribed;
  for (int& coordinate : phi.coordinate) {
    const int of_member = coordinate - (coordinate > held ? 1 : 0);
    coordinate = of_member < p ? size - p + of_member : of_member - p;
  }
  return phi;
}

FieldBasis in_scene(const FieldBasis& of_reduction, const FieldBasis& phi) {
  const Eigen::MatrixXd coordinates = of_reduction.unit.asDiagonal() * of_reduction.columns();
  Eigen::MatrixXd used = Eigen::MatrixXd::Zero(phi.n(), of_reduction.n());
  for (std::size_t i = 0; i < of_reduction.unknown.size(); ++i) {
    const auto column = std::find(phi.coordinate.begin(), phi.coordinate.end(), of_reduction.unknown[i]);
    if (column == phi.coordinate.end()) throw std::invalid_argument("a member has another phi than its family");
    used.row(column - phi.coordinate.begin()) = coordinates.row(static_cast<Eigen::Index>(i));
  }
  return {phi.unknown, phi.unit, product(phi.columns(), used), of_reduction.coordinate};
}

}  // namespace upbead
