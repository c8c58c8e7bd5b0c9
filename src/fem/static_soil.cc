#include "fem/static_soil.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "fem/kernels.h"

namespace upbead {

using namespace dealii;

namespace {

using Columns = Eigen::Matrix<double, 3, Eigen::Dynamic>;

Eigen::Matrix3d matrix_of(const Tangent& tangent) {
  Eigen::Matrix3d out;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) out(i, j) = tangent[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  return out;
}

LawAnswer elastic_answer(const ElasticLaw& law, const PlaneStrain& strain, MohrCoulombLaw::State& state) {
  const PlaneStress change =
      law.stress({strain.xx - state.strain.xx, strain.yy - state.strain.yy, strain.xy - state.strain.xy});
  const PlaneStress& old = state.stress;
  state = {{old.xx + change.xx, old.yy + change.yy, old.xy + change.xy, old.zz + change.zz}, strain};
  return {state.stress, law.tangent()};
}

/// Whether a point at its strength has not moved: then the direction of its flow, and so its tangent, is not known.
bool is_still(const PlaneStrain& now, const PlaneStrain& before) {
  return now.xx == before.xx && now.yy == before.yy && now.xy == before.xy;
}

}  // namespace

struct StaticSoil::Impl {
  /// A cell that deforms.
  struct SoilCell {
    unsigned index;  ///< of the active cell
    ElasticLaw elastic;
    double area;                ///< m2
    std::vector<int> unknowns;  ///< ascending
    std::vector<int> entries;   ///< of the local matrix, row by row, in the pattern
    std::size_t first_point, end_of_points;
  };
  struct Place {
    Columns strain;  ///< (eps_xx, eps_yy, gamma_xy) by the unknowns of the cell
    double area;     ///< m2
  };

  std::vector<SoilCell> cells;
  std::vector<Place> places;
  std::vector<MohrCoulombLaw::State> states;  ///< committed, by point
  std::vector<Eigen::Matrix3d> tangents;      ///< by point, of the last exert()
  StaticLaws laws;
  SparseMatrix pattern;
  double least_stiffness = 1e-5;  ///< over the elastic one

  Impl(const Space& space, const Unknowns& unknowns);
  void add(const Space& space, const Unknowns& unknowns, const Cell& cell);
  void number_entries(int n);
  LawAnswer answer(const SoilCell& cell, const PlaneStrain& strain, MohrCoulombLaw::State& state) const {
    const auto& law = laws[cell.index];
    return law ? law->update(strain, state) : elastic_answer(cell.elastic, strain, state);
  }
  static Vector gather(const SoilCell& cell, const Vector& x) {
    Vector local(static_cast<Eigen::Index>(cell.unknowns.size()));
    for (Eigen::Index i = 0; i < local.size(); ++i) local[i] = x[cell.unknowns[static_cast<std::size_t>(i)]];
    return local;
  }
  PlaneStrain strain(std::size_t point, const Vector& local) const {
    const Eigen::Vector3d e = places[point].strain * local;
    return {e[0], e[1], 0.5 * e[2]};
  }
};

StaticSoil::Impl::Impl(const Space& space, const Unknowns& unknowns) {
  for (const Cell& cell : space.dofs().active_cell_iterators())
    if (space.has_matrices(cell) && space.kind(cell) != CellKind::water) add(space, unknowns, cell);
  states.resize(places.size());
  tangents.resize(places.size());
  laws.resize(space.mesh().triangulation.n_active_cells());
  number_entries(unknowns.size());
}

void StaticSoil::Impl::add(const Space& space, const Unknowns& unknowns, const Cell& cell) {
  FEValues<dim> values(space.mapping(), cell->get_fe(), QGauss<dim>(static_cast<unsigned>(space.degree()) + 1),
                       update_gradients | update_JxW_values);
  values.reinit(typename Triangulation<dim>::cell_iterator(cell));
  const Dofs dofs = dofs_of(cell);
  std::map<int, int> local;
  for (const auto dof : dofs)
    for (const auto& entry : unknowns.expansion(dof)) local[entry.first] = 0;
  SoilCell added{cell->active_cell_index(), space.material(cell), area_of(cell), {}, {}, places.size(), 0};
  for (auto& [unknown, number] : local) {
    number = static_cast<int>(added.unknowns.size());
    added.unknowns.push_back(unknown);
  }
  for (unsigned q = 0; q < values.n_quadrature_points; ++q) {
    Place place{Columns::Zero(3, static_cast<Eigen::Index>(local.size())), values.JxW(q)};
    for (unsigned i = 0; i < dofs.size(); ++i) {
      const PlaneStrain of = strain_of(values, i, q);
      for (const auto& [unknown, weight] : unknowns.expansion(dofs[i]))
        place.strain.col(local.at(unknown)) += weight * Eigen::Vector3d(of.xx, of.yy, 2. * of.xy);
    }
    places.push_back(std::move(place));
  }
  added.end_of_points = places.size();
  cells.push_back(std::move(added));
}

void StaticSoil::Impl::number_entries(int n) {
  std::vector<Eigen::Triplet<double>> triplets;
  for (int i = 0; i < n; ++i) triplets.emplace_back(i, i, 0.);
  for (const SoilCell& cell : cells)
    for (const int i : cell.unknowns)
      for (const int j : cell.unknowns) triplets.emplace_back(i, j, 0.);
  pattern.resize(n, n);
  pattern.setFromTriplets(triplets.begin(), triplets.end());
  const int* columns = pattern.innerIndexPtr();
  const int* rows = pattern.outerIndexPtr();
  for (SoilCell& cell : cells)
    for (const int i : cell.unknowns)
      for (const int j : cell.unknowns)
        cell.entries.push_back(
            static_cast<int>(std::lower_bound(columns + rows[i], columns + rows[i + 1], j) - columns));
}

StaticSoil::StaticSoil(const Space& space, const Unknowns& unknowns) : impl_(std::make_unique<Impl>(space, unknowns)) {}
StaticSoil::~StaticSoil() = default;

void StaticSoil::follow(StaticLaws laws) {
  impl_->laws = std::move(laws);
}

void StaticSoil::keep_stiffness(double share) {
  impl_->least_stiffness = share;
}

void StaticSoil::start_from(const PointStresses& stresses) {
  for (const Impl::SoilCell& cell : impl_->cells) {
    const std::vector<PlaneStress>& given = stresses[cell.index];
    for (std::size_t p = cell.first_point, q = 0; p < cell.end_of_points; ++p, ++q)
      impl_->states[p] = {q < given.size() ? given[q] : PlaneStress{}, {}};
  }
}

void StaticSoil::exert(const Vector& x, Vector& force) {
  force.setZero(impl_->pattern.rows());
  const double least = impl_->least_stiffness;
  for (const Impl::SoilCell& cell : impl_->cells) {
    const Vector local = Impl::gather(cell, x);
    Vector sum = Vector::Zero(local.size());
    for (std::size_t p = cell.first_point; p < cell.end_of_points; ++p) {
      MohrCoulombLaw::State state = impl_->states[p];
      const PlaneStrain strain = impl_->strain(p, local);
      LawAnswer answer = impl_->answer(cell, strain, state);
      if (is_still(strain, impl_->states[p].strain)) answer.tangent = cell.elastic.tangent();
      const Impl::Place& place = impl_->places[p];
      impl_->tangents[p] = (1. - least) * matrix_of(answer.tangent) + least * matrix_of(cell.elastic.tangent());
      sum.noalias() += place.strain.transpose() *
                       (place.area * Eigen::Vector3d(answer.stress.xx, answer.stress.yy, answer.stress.xy));
    }
    for (std::size_t i = 0; i < cell.unknowns.size(); ++i) force[cell.unknowns[i]] += sum[static_cast<Eigen::Index>(i)];
  }
}

const SparseMatrix& StaticSoil::pattern() const {
  return impl_->pattern;
}

void StaticSoil::tangent(Eigen::Ref<Vector> values) const {
  assemble(impl_->tangents, values);
}

void StaticSoil::assemble(const std::vector<Eigen::Matrix3d>& D, Eigen::Ref<Vector> values) const {
  values.setZero();
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> K;
  for (const Impl::SoilCell& cell : impl_->cells) {
    const auto n = static_cast<Eigen::Index>(cell.unknowns.size());
    K.setZero(n, n);
    for (std::size_t p = cell.first_point; p < cell.end_of_points; ++p) {
      const Columns& B = impl_->places[p].strain;
      K.noalias() += B.transpose() * ((impl_->places[p].area * D[p]) * B);
    }
    for (Eigen::Index k = 0; k < n * n; ++k) values[cell.entries[static_cast<std::size_t>(k)]] += K.data()[k];
  }
}

void StaticSoil::commit(const Vector& x) {
  for (const Impl::SoilCell& cell : impl_->cells) {
    const Vector local = Impl::gather(cell, x);
    for (std::size_t p = cell.first_point; p < cell.end_of_points; ++p)
      impl_->answer(cell, impl_->strain(p, local), impl_->states[p]);
  }
}

std::vector<StaticSoil::Point> StaticSoil::points() const {
  std::vector<Point> found;
  for (const Impl::SoilCell& cell : impl_->cells)
    for (std::size_t p = cell.first_point; p < cell.end_of_points; ++p)
      found.push_back(
          {cell.index, impl_->places[p].area, cell.elastic, impl_->laws[cell.index].get(), impl_->states[p].stress});
  return found;
}

std::vector<Eigen::Vector3d> StaticSoil::strains(const Vector& x) const {
  std::vector<Eigen::Vector3d> found;
  for (const Impl::SoilCell& cell : impl_->cells) {
    const Vector local = Impl::gather(cell, x);
    for (std::size_t p = cell.first_point; p < cell.end_of_points; ++p)
      found.emplace_back(impl_->places[p].strain * local);
  }
  return found;
}

Vector StaticSoil::forces(const std::vector<Eigen::Vector3d>& stresses) const {
  Vector force = Vector::Zero(impl_->pattern.rows());
  for (const Impl::SoilCell& cell : impl_->cells) {
    Vector sum = Vector::Zero(static_cast<Eigen::Index>(cell.unknowns.size()));
    for (std::size_t p = cell.first_point; p < cell.end_of_points; ++p)
      sum.noalias() += impl_->places[p].strain.transpose() * (impl_->places[p].area * stresses[p]);
    for (std::size_t i = 0; i < cell.unknowns.size(); ++i) force[cell.unknowns[i]] += sum[static_cast<Eigen::Index>(i)];
  }
  return force;
}

PointStresses StaticSoil::stresses() const {
  PointStresses found(impl_->laws.size());
  for (const Impl::SoilCell& cell : impl_->cells)
    for (std::size_t p = cell.first_point; p < cell.end_of_points; ++p)
      found[cell.index].push_back(impl_->states[p].stress);
  return found;
}

double StaticSoil::largest_excess() const {
  double largest = -HUGE_VAL;
  for (const Impl::SoilCell& cell : impl_->cells)
    if (const auto& law = impl_->laws[cell.index])
      for (std::size_t p = cell.first_point; p < cell.end_of_points; ++p)
        largest = std::max(largest, law->excess(impl_->states[p].stress));
  return largest;
}

double StaticSoil::share_at_strength() const {
  double reached = 0., all = 0.;
  for (const Impl::SoilCell& cell : impl_->cells) {
    const auto& law = impl_->laws[cell.index];
    if (!law) continue;
    bool at = false;
    for (std::size_t p = cell.first_point; p < cell.end_of_points; ++p) {
      const PlaneStress& s = impl_->states[p].stress;
      at = at || law->excess(s) > -1e-6 * (std::abs(s.xx) + std::abs(s.yy) + std::abs(s.zz));
    }
    all += cell.area;
    if (at) reached += cell.area;
  }
  return all > 0. ? reached / all : 0.;
}

}  // namespace upbead
