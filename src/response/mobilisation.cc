#include "response/mobilisation.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/hp/fe_values.h>

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>

#include "fem/kernels.h"

namespace upbead {

using namespace dealii;

namespace {

constexpr double end_of_scale = 10.;
constexpr double least_stress = 0.1;  ///< of the region's mean, as the floor of StressLaw
constexpr double degree = boost::math::constants::degree<double>();

/// Rows of three quantities, filled cell by cell.
struct Rows {
  std::vector<Eigen::Triplet<double>> sum, difference, shear;

  void add(int row, int unknown, const PlaneStress& stress, double weight) {
    sum.emplace_back(row, unknown, -weight * 0.5 * (stress.xx + stress.yy));
    difference.emplace_back(row, unknown, -weight * 0.5 * (stress.xx - stress.yy));
    shear.emplace_back(row, unknown, -weight * stress.xy);
  }
};

}  // namespace

double Mobilisation::Soil::mobilisation(double s, double difference, double tau) const {
  const double r = std::hypot(difference, tau), strength = apex + s * sine;
  return strength * end_of_scale > r ? r / strength : end_of_scale;
}

Mobilisation::Mobilisation(const Space& space, const Unknowns& unknowns, const EffectiveStress& rest, const std::optional<double>& k0) {
  Rows rows;
  const hp::QCollection<dim> middle{QMidpoint<dim>()};
  hp::FEValues<dim> hp_values(space.dofs().get_fe_collection(), middle, update_gradients);
  std::vector<types::global_dof_index> dofs;
  for (const auto& cell : space.dofs().active_cell_iterators()) {
    const Region& region = space.region(cell);
    if (!region.strength || region.kind == RegionKind::rigid || space.kind(cell) == CellKind::absent) continue;
    hp_values.reinit(cell);
    const FEValues<dim>& fe = hp_values.get_present_fe_values();
    dofs.resize(fe.dofs_per_cell);
    cell->get_dof_indices(dofs);
    const ElasticLaw& law = space.material(cell);
    for (const unsigned i : fe.dof_indices()) {
      const PlaneStress stress = law.stress(strain_of(fe, i, 0));
      for (const auto& [unknown, weight] : unknowns.expansion(static_cast<unsigned>(dofs[i])))
        rows.add(static_cast<int>(cells_.size()), unknown, stress, weight);
    }
    const std::string& name = space.mesh().surface_of(cell);
    const auto place = std::find(regions_.begin(), regions_.end(), name);
    Soil soil{cell->center(), static_cast<std::size_t>(place - regions_.begin()), cell->measure()};
    if (place == regions_.end()) regions_.push_back(name);
    const std::size_t i = cell->active_cell_index();
    const double horizontal = k0 ? *k0 * rest.vertical[i] : rest.horizontal[i];
    soil.middle_stress = 0.5 * (horizontal + rest.vertical[i]);
    soil.half_difference = 0.5 * (horizontal - rest.vertical[i]);
    soil.shear = rest.shear[i];
    soil.sine = std::sin(region.strength->friction_angle * degree);
    soil.apex = region.strength->cohesion * std::cos(region.strength->friction_angle * degree);
    cells_.push_back(soil);
  }
  for (auto [matrix, entries] :
       {std::pair{&sum_, &rows.sum}, std::pair{&difference_, &rows.difference}, std::pair{&shear_, &rows.shear}}) {
    matrix->resize(static_cast<Eigen::Index>(cells_.size()), unknowns.size());
    matrix->setFromTriplets(entries->begin(), entries->end());
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
  const Vector sum = sum_ * state.x, difference = difference_ * state.x, shear = shear_ * state.x;
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    const Soil& soil = cells_[c];
    const auto i = static_cast<Eigen::Index>(c);
    const double m =
        soil.mobilisation(soil.middle_stress + sum[i], soil.half_difference + difference[i], soil.shear + shear[i]);
    if (!soil.counts || m <= largest_[c]) continue;
    largest_[c] = m;
    time_[c] = state.time;
  }
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

}  // namespace upbead
