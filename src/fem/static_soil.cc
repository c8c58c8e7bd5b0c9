#include "fem/static_soil.h"

#include <algorithm>
#include <cmath>

#include "fem/cell_pack.h"

namespace upbead {

namespace {

Eigen::Matrix3d matrix_of(const Tangent& tangent) {
  Eigen::Matrix3d out;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) out(i, j) = tangent[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  return out;
}

/// Whether a point at its strength has not moved: then the direction of its flow, and so its tangent, is not known.
bool is_still(const PlaneStrain& now, const PlaneStrain& before) {
  return now.xx == before.xx && now.yy == before.yy && now.xy == before.xy;
}

Eigen::Vector3d part_of(const Vector& all, std::size_t point) {
  return all.segment<3>(static_cast<Eigen::Index>(3 * point));
}

PlaneStrain strain_at(const Vector& strains, std::size_t point) {
  const Eigen::Vector3d e = part_of(strains, point);
  return {e[0], e[1], 0.5 * e[2]};
}

}  // namespace

StaticSoil::StaticSoil(const Space& space, const Unknowns& unknowns)
    : laws_(space.mesh().triangulation.n_active_cells()) {
  std::vector<std::vector<PointStrain>> points;  // by cell
  for (const Cell& cell : space.dofs().active_cell_iterators()) {
    if (!space.has_matrices(cell) || space.kind(cell) == CellKind::water) continue;
    points.push_back(strains_by_unknown(shapes_of(space, cell), unknowns));
    const std::size_t first = area_.size();
    for (const PointStrain& point : points.back()) area_.push_back(point.area);
    cells_.push_back({cell->active_cell_index(), space.material(cell), area_of(cell), first, area_.size()});
  }
  states_.resize(area_.size());
  tangents_.resize(area_.size());
  B_.resize(static_cast<Eigen::Index>(3 * area_.size()), unknowns.size());
  int row = 0;
  for (const auto& of_cell : points)
    for (const PointStrain& point : of_cell)
      for (int component = 0; component < 3; ++component, ++row) {
        B_.startVec(row);
        for (const auto& [unknown, of] : point.strain)
          B_.insertBack(row, unknown) = component == 0 ? of.xx : component == 1 ? of.yy : 2. * of.xy;
      }
  B_.finalize();
  number_entries();
}

Eigen::Map<const Eigen::VectorXi> StaticSoil::unknowns_of(const SoilCell& cell) const {
  const int* begin = B_.outerIndexPtr() + 3 * cell.first_point;
  return {B_.innerIndexPtr() + begin[0], begin[1] - begin[0]};
}

void StaticSoil::number_entries() {
  const auto n = B_.cols();
  std::vector<Eigen::Triplet<double>> triplets;
  for (int i = 0; i < n; ++i) triplets.emplace_back(i, i, 0.);
  for (const SoilCell& cell : cells_)
    for (const int i : unknowns_of(cell))
      for (const int j : unknowns_of(cell)) triplets.emplace_back(i, j, 0.);
  pattern_.resize(n, n);
  pattern_.setFromTriplets(triplets.begin(), triplets.end());
  const int* columns = pattern_.innerIndexPtr();
  const int* rows = pattern_.outerIndexPtr();
  for (SoilCell& cell : cells_)
    for (const int i : unknowns_of(cell))
      for (const int j : unknowns_of(cell))
        cell.entries.push_back(
            static_cast<int>(std::lower_bound(columns + rows[i], columns + rows[i + 1], j) - columns));
}

LawAnswer StaticSoil::answer(const SoilCell& cell, const PlaneStrain& strain, MohrCoulombLaw::State& state) const {
  if (const auto& law = laws_[cell.index]) return law->update(strain, state);
  const PlaneStrain& old = state.strain;
  const PlaneStress change = cell.elastic.stress({strain.xx - old.xx, strain.yy - old.yy, strain.xy - old.xy});
  state = {sum(state.stress, change), strain};
  return {state.stress, cell.elastic.tangent()};
}

void StaticSoil::start_from(const PointStresses& stresses) {
  each_point([&](const SoilCell& cell, std::size_t p) {
    const std::vector<PlaneStress>& given = stresses[cell.index];
    const std::size_t q = p - cell.first_point;
    states_[p] = {q < given.size() ? given[q] : PlaneStress{}, {}};
  });
}

void StaticSoil::exert(const Vector& x, Vector& force) {
  const Vector strains = B_ * x;
  std::vector<Eigen::Vector3d> stresses(area_.size());
  each_point([&](const SoilCell& cell, std::size_t p) {
    MohrCoulombLaw::State state = states_[p];
    const PlaneStrain strain = strain_at(strains, p);
    LawAnswer now = answer(cell, strain, state);
    const Tangent elastic = cell.elastic.tangent();
    if (is_still(strain, states_[p].strain)) now.tangent = elastic;
    tangents_[p] = (1. - least_stiffness_) * matrix_of(now.tangent) + least_stiffness_ * matrix_of(elastic);
    stresses[p] = {now.stress.xx, now.stress.yy, now.stress.xy};
  });
  force = forces(stresses);
}

void StaticSoil::assemble(const std::vector<Eigen::Matrix3d>& D, Eigen::Ref<Vector> values) const {
  values.setZero();
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> K;
  for (const SoilCell& cell : cells_) {
    const auto n = unknowns_of(cell).size();
    K.setZero(n, n);
    for (std::size_t p = cell.first_point; p < cell.end_of_points; ++p) {
      const Columns B(B_.valuePtr() + B_.outerIndexPtr()[3 * p], 3, n);
      K.noalias() += B.transpose() * ((area_[p] * D[p]) * B);
    }
    for (Eigen::Index k = 0; k < n * n; ++k) values[cell.entries[static_cast<std::size_t>(k)]] += K.data()[k];
  }
}

void StaticSoil::commit(const Vector& x) {
  const Vector strains = B_ * x;
  each_point([&](const SoilCell& cell, std::size_t p) { answer(cell, strain_at(strains, p), states_[p]); });
}

std::vector<StaticSoil::Point> StaticSoil::points() const {
  std::vector<Point> found;
  each_point([&](const SoilCell& cell, std::size_t p) {
    found.push_back({cell.index, area_[p], cell.elastic, laws_[cell.index].get(), states_[p].stress});
  });
  return found;
}

std::vector<Eigen::Vector3d> StaticSoil::strains(const Vector& x) const {
  const Vector all = B_ * x;
  std::vector<Eigen::Vector3d> found(area_.size());
  for (std::size_t p = 0; p < found.size(); ++p) found[p] = part_of(all, p);
  return found;
}

Vector StaticSoil::forces(const std::vector<Eigen::Vector3d>& stresses) const {
  Vector all(B_.rows());
  for (std::size_t p = 0; p < area_.size(); ++p)
    all.segment<3>(static_cast<Eigen::Index>(3 * p)) = area_[p] * stresses[p];
  return B_.transpose() * all;
}

PointStresses StaticSoil::stresses() const {
  PointStresses found(laws_.size());
  each_point([&](const SoilCell& cell, std::size_t p) { found[cell.index].push_back(states_[p].stress); });
  return found;
}

double StaticSoil::largest_excess() const {
  double largest = -HUGE_VAL;
  each_point([&](const SoilCell& cell, std::size_t p) {
    if (const auto& law = laws_[cell.index]) largest = std::max(largest, law->excess(states_[p].stress));
  });
  return largest;
}

double StaticSoil::share_at_strength() const {
  double reached = 0., all = 0.;
  for (const SoilCell& cell : cells_) {
    const auto& law = laws_[cell.index];
    if (!law) continue;
    const auto first = states_.begin() + static_cast<std::ptrdiff_t>(cell.first_point);
    const bool at = std::any_of(first, first + static_cast<std::ptrdiff_t>(cell.end_of_points - cell.first_point),
                                [&](const MohrCoulombLaw::State& state) {
                                  const PlaneStress& s = state.stress;
                                  const double size = std::abs(s.xx) + std::abs(s.yy) + std::abs(s.zz);
                                  return law->excess(s) > -1e-6 * size;
                                });
    all += cell.area;
    if (at) reached += cell.area;
  }
  return all > 0. ? reached / all : 0.;
}

}  // namespace upbead
