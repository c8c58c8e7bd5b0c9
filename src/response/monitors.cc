#include "response/monitors.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/hp/fe_values.h>
#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <set>

#include "algebra/dense.h"
#include "fem/kernels.h"
#include "response/reduction.h"
#include "response/rows_of_basis.h"

namespace upbead {

using namespace dealii;

namespace {

/// What rows over the unknowns read, of all columns of a StateModel's coordinates: rows x columns.
Eigen::MatrixXd values(const SparseMatrix& rows, const FieldBasis& basis, const Eigen::MatrixXd& coordinates) {
  return product(rows_of_basis(rows, basis), coordinates(basis.coordinate, Eigen::all));
}

/// States at so many times are looked at together: memory for cells x 500 numbers, however long the history is.
constexpr std::size_t at_once = 500;

/// At most so many of a list, from its element `first` on.
std::vector<Eigen::Index> part_of(const std::vector<Eigen::Index>& list, std::size_t first, std::size_t most) {
  return {list.begin() + static_cast<std::ptrdiff_t>(first),
          list.begin() + static_cast<std::ptrdiff_t>(std::min(first + most, list.size()))};
}

}  // namespace

MiddleStrains::MiddleStrains(const Space& space, const Unknowns& unknowns, const std::vector<bool>& of_interest) {
  std::vector<Eigen::Triplet<double>> xx, yy, xy, difference;
  const hp::QCollection<dim> middle{QMidpoint<dim>()};
  hp::FEValues<dim> hp_values(space.dofs().get_fe_collection(), middle, update_gradients);
  for (const auto& cell : space.dofs().active_cell_iterators()) {
    if (!of_interest[cell->active_cell_index()] || space.kind(cell) == CellKind::absent) continue;
    hp_values.reinit(cell);
    const FEValues<dim>& fe = hp_values.get_present_fe_values();
    const Dofs dofs = dofs_of(cell);
    const int row = static_cast<int>(cells_.size());
    for (const unsigned i : fe.dof_indices()) {
      const PlaneStrain strain = strain_of(fe, i, 0);
      for (const auto& [unknown, weight] : unknowns.expansion(dofs[i])) {
        xx.emplace_back(row, unknown, weight * strain.xx);
        yy.emplace_back(row, unknown, weight * strain.yy);
        xy.emplace_back(row, unknown, weight * strain.xy);
        difference.emplace_back(row, unknown, weight * (strain.xx - strain.yy));
      }
    }
    cells_.push_back(cell);
  }
  for (auto [matrix, entries] : {std::pair{&xx_, &xx}, {&yy_, &yy}, {&xy_, &xy}, {&difference_, &difference}}) {
    matrix->resize(static_cast<Eigen::Index>(cells_.size()), unknowns.size());
    matrix->setFromTriplets(entries->begin(), entries->end());
  }
}

std::vector<PlaneStrain> MiddleStrains::at(const Vector& x) const {
  const Vector xx = xx_ * x, yy = yy_ * x, xy = xy_ * x;
  std::vector<PlaneStrain> strains;
  for (Eigen::Index i = 0; i < xx.size(); ++i) strains.push_back({xx[i], yy[i], xy[i]});
  return strains;
}

MiddleStrains::Series MiddleStrains::at(const FieldBasis& basis, const Eigen::MatrixXd& coordinates) const {
  return {values(xx_, basis, coordinates), values(yy_, basis, coordinates), values(xy_, basis, coordinates)};
}

Eigen::MatrixXd MiddleStrains::shear(const FieldBasis& basis, const Eigen::MatrixXd& coordinates) const {
  return (values(difference_, basis, coordinates).array().square() +
          4. * values(xy_, basis, coordinates).array().square())
      .sqrt();
}

std::vector<double> MiddleStrains::shear(const Vector& x) const {
  const Vector difference = difference_ * x, xy = xy_ * x;
  std::vector<double> shear;
  for (Eigen::Index i = 0; i < xy.size(); ++i) shear.push_back(std::hypot(difference[i], 2. * xy[i]));
  return shear;
}

void LargestStrains::see(const State& state, int step, int) {
  if (step == 0) std::fill(largest_.begin(), largest_.end(), 0.);
  const std::vector<double> shear = strains_.shear(state.x);
  for (std::size_t c = 0; c < shear.size(); ++c) {
    double& largest = largest_[strains_.cells()[c]->active_cell_index()];
    largest = std::max(largest, shear[c]);
  }
}

void LargestStrains::see(const StateModel& model, const SampledLoads& loads) {
  std::fill(largest_.begin(), largest_.end(), 0.);
  const CoordinateSeries series = respond_in_coordinates(model.model, loads);
  const auto n = static_cast<std::size_t>(series.position.cols());
  for (std::size_t first = 0; first < n; first += at_once) {
    const auto columns = series.position.middleCols(static_cast<Eigen::Index>(first),
                                                    static_cast<Eigen::Index>(std::min(at_once, n - first)));
    const Eigen::VectorXd shear = strains_.shear(model.displacements, columns).rowwise().maxCoeff();
    for (std::size_t c = 0; c < strains_.cells().size(); ++c) {
      double& largest = largest_[strains_.cells()[c]->active_cell_index()];
      largest = std::max(largest, shear[static_cast<Eigen::Index>(c)]);
    }
  }
}

namespace {

constexpr double end_of_scale = 10.;
constexpr double least_stress = 0.1;  ///< share of the region's mean, as for the floor of StressLaw
constexpr double degree = boost::math::constants::degree<double>();

std::vector<bool> with_strength(const Space& space) {
  std::vector<bool> list;
  for (const auto& cell : space.dofs().active_cell_iterators())
    list.push_back(space.region(cell).strength && space.region(cell).law == SoilLaw::elastic &&
                   space.region(cell).kind != RegionKind::rigid);
  return list;
}

}  // namespace

double Mobilisation::Soil::mobilisation(double s, double difference, double tau) const {
  const double r = std::hypot(difference, tau), strength = apex + s * sine;
  return strength * end_of_scale > r ? r / strength : end_of_scale;
}

Mobilisation::Mobilisation(const Space& space, const Unknowns& unknowns, const EffectiveStress& rest,
                           const std::optional<double>& k0)
    : strains_(space, unknowns, with_strength(space)) {
  for (const auto& cell : strains_.cells()) {
    const std::string& name = space.mesh().surface_of(cell);
    const auto place = std::find(regions_.begin(), regions_.end(), name);
    Soil soil{cell->center(), static_cast<std::size_t>(place - regions_.begin()), area_of(cell)};
    if (place == regions_.end()) regions_.push_back(name);
    const std::size_t i = cell->active_cell_index();
    const double horizontal = k0 ? *k0 * rest.vertical[i] : rest.horizontal[i];
    soil.middle_stress = 0.5 * (horizontal + rest.vertical[i]);
    soil.half_difference = 0.5 * (horizontal - rest.vertical[i]);
    soil.shear = rest.shear[i];
    const Region& region = space.region(cell);
    soil.sine = std::sin(region.strength->friction_angle * degree);
    soil.apex = region.strength->cohesion * std::cos(region.strength->friction_angle * degree);
    soil.law = space.material(cell);
    cells_.push_back(soil);
  }
  largest_.assign(cells_.size(), 0.);
  time_.assign(cells_.size(), 0.);
  leave_out_free_surfaces();
}

void Mobilisation::leave_out_free_surfaces() {
  std::vector<double> stress(regions_.size(), 0.), area(regions_.size(), 0.);
  for (const Soil& soil : cells_) {
    stress[soil.region] += std::max(soil.middle_stress, 0.) * soil.area;
    area[soil.region] += soil.area;
  }
  for (Soil& soil : cells_) soil.counts = soil.middle_stress >= least_stress * stress[soil.region] / area[soil.region];
}

void Mobilisation::see(const State& state, int step, int) {
  has_seen_ = true;
  if (step == 0) {
    std::fill(largest_.begin(), largest_.end(), 0.);
    std::fill(time_.begin(), time_.end(), 0.);
  }
  const std::vector<PlaneStrain> strains = strains_.at(state.x);
  for (std::size_t c = 0; c < cells_.size(); ++c) take(c, strains[c], state.time);
}

void Mobilisation::see(const StateModel& model, const SampledLoads& loads, double duration) {
  has_seen_ = true;
  const CoordinateSeries series = respond_in_coordinates(model.model, loads);
  const std::vector<Eigen::Index> looks = looks_at(series.time, duration);
  for (std::size_t first = 0; first < looks.size(); first += at_once) {
    const std::vector<Eigen::Index> some = part_of(looks, first, at_once);
    const MiddleStrains::Series strains = strains_.at(model.displacements, series.position(Eigen::all, some));
    for (std::size_t i = 0; i < some.size(); ++i)
      for (std::size_t c = 0; c < cells_.size(); ++c) {
        const auto row = static_cast<Eigen::Index>(c), column = static_cast<Eigen::Index>(i);
        take(c, {strains.xx(row, column), strains.yy(row, column), strains.xy(row, column)},
             series.time[static_cast<std::size_t>(some[i])]);
      }
  }
}

void Mobilisation::take(std::size_t cell, const PlaneStrain& strain, double time) {
  const Soil& soil = cells_[cell];
  if (!soil.counts) return;
  const PlaneStress stress = soil.law.stress(strain);  // tension positive
  const double m = soil.mobilisation(soil.middle_stress - 0.5 * (stress.xx + stress.yy),
                                     soil.half_difference - 0.5 * (stress.xx - stress.yy), soil.shear - stress.xy);
  if (m <= largest_[cell]) return;
  largest_[cell] = m;
  time_[cell] = time;
}

std::vector<MobilisedStrength> Mobilisation::found() const {
  std::vector<MobilisedStrength> list(regions_.size());
  std::vector<double> area(regions_.size(), 0.);
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    const Soil& soil = cells_[c];
    MobilisedStrength& of = list[soil.region];
    of.region = regions_[soil.region];
    area[soil.region] += soil.area;
    if (!soil.counts) {
      of.left_out += soil.area;
      continue;
    }
    const double initial = soil.mobilisation(soil.middle_stress, soil.half_difference, soil.shear);
    of.initial = std::max(of.initial, initial);
    if (initial > 1.) of.initial_share += soil.area;
    if (largest_[c] > 1.) of.share += soil.area;
    if (largest_[c] <= of.largest) continue;
    of.largest = largest_[c];
    of.at = {soil.middle[0], soil.middle[1]};
    of.time = time_[c];
  }
  for (std::size_t i = 0; i < list.size(); ++i)
    for (double MobilisedStrength::*part :
         {&MobilisedStrength::initial_share, &MobilisedStrength::share, &MobilisedStrength::left_out})
      list[i].*part /= area[i];
  return list;
}

std::vector<double> Mobilisation::memory() const {
  std::vector<double> memory = largest_;
  memory.insert(memory.end(), time_.begin(), time_.end());
  return memory;
}

void Mobilisation::recall(const std::vector<double>& memory) {
  const auto half = memory.begin() + static_cast<std::ptrdiff_t>(cells_.size());
  largest_.assign(memory.begin(), half);
  time_.assign(half, memory.end());
}

LeastPressure::LeastPressure(const Space& space, const Unknowns& unknowns, const Scene& scene, double level) {
  std::vector<Eigen::Triplet<double>> entries;
  std::set<types::global_dof_index> seen;
  for (const auto& cell : space.dofs().active_cell_iterators()) {
    if (!space.has_pressure(cell)) continue;
    const FiniteElement<dim>& fe = cell->get_fe();
    const Dofs dofs = dofs_of(cell);
    for (unsigned i = 0; i < dofs.size(); ++i) {
      if (fe.system_to_component_index(i).first != phi_component || !seen.insert(dofs[i]).second) continue;
      const Point<dim> at = node_of(space, cell, i).at;
      if (at[1] > level) continue;
      const int row = static_cast<int>(nodes_.size());
      for (const auto& [unknown, weight] : unknowns.expansion(dofs[i])) entries.emplace_back(row, unknown, weight);
      nodes_.push_back(
          {at, space.mesh().surface_of(cell), atmosphere + scene.fluid.density * scene.gravity * (level - at[1])});
    }
  }
  rows_.resize(static_cast<Eigen::Index>(nodes_.size()), unknowns.size());
  rows_.setFromTriplets(entries.begin(), entries.end());
}

void LeastPressure::see(const State& state, int step, int) {
  if (step == 0) has_seen_ = false;
  if (watches()) take(rows_ * state.v, state.time);
}

void LeastPressure::see(const PressureModel& model, const SampledLoads& loads, double duration) {
  if (!watches()) return;
  const Series series = respond(model.model, loads);
  const std::vector<Eigen::Index> looks = looks_at(series.time, duration);
  std::vector<double> times;
  for (const Eigen::Index look : looks) times.push_back(series.time[static_cast<std::size_t>(look)]);
  see(model.basis, series.reading(Eigen::all, looks), times);
}

void LeastPressure::see(const FieldBasis& basis, const Eigen::MatrixXd& velocities, const std::vector<double>& times) {
  if (!watches()) return;
  const Eigen::MatrixXd rows = rows_of_basis(rows_, basis);
  constexpr Eigen::Index together = 128;  // so that what is looked at stays in the cache
  for (Eigen::Index first = 0; first < rows.rows(); first += together) {
    const Eigen::MatrixXd excess = product(rows.middleRows(first, std::min(together, rows.rows() - first)), velocities);
    for (Eigen::Index i = 0; i < excess.cols(); ++i)
      take(excess.col(i), times[static_cast<std::size_t>(i)], static_cast<std::size_t>(first));
  }
}

std::vector<double> LeastPressure::memory() const {
  return {least_, time_, static_cast<double>(node_), has_seen_ ? 1. : 0.};
}

void LeastPressure::recall(const std::vector<double>& memory) {
  least_ = memory.at(0);
  time_ = memory.at(1);
  node_ = static_cast<std::size_t>(memory.at(2));
  has_seen_ = memory.at(3) != 0.;
}

void LeastPressure::take(const Eigen::Ref<const Vector>& excess, double time, std::size_t first) {
  for (Eigen::Index row = 0; row < excess.size(); ++row) {
    const std::size_t i = first + static_cast<std::size_t>(row);
    const double p = nodes_[i].still + excess[row];
    if (has_seen_ && p >= least_) continue;
    has_seen_ = true;
    least_ = p;
    time_ = time;
    node_ = i;
  }
}

}  // namespace upbead
