#include "run/yielding_watch.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "model/words.h"

namespace upbead {

namespace {

constexpr double all_of_it = 1. - 1e-3, nearly_as_large = 1e-9;

std::vector<bool> may_yield(YieldingSoil& soil) {
  std::vector<bool> list;
  for (const double lost : soil.dissipated()) list.push_back(lost >= 0.);
  return list;
}

double mobilised(const std::vector<BorneStress>& points) {
  double sum = 0.;
  for (const BorneStress& point : points) sum += point.mobilised;
  return sum / static_cast<double>(points.size());
}

std::array<double, 2> middle_of(const dealii::DoFHandler<dim>::active_cell_iterator& cell) {
  return {cell->center()[0], cell->center()[1]};
}

}  // namespace

YieldingWatch::YieldingWatch(const Space& space, const Unknowns& unknowns, YieldingSoil& soil)
    : space_(space), soil_(soil), strains_(space, unknowns, may_yield(soil)) {
  for (const auto& cell : space.dofs().active_cell_iterators())
    if (soil.dissipated()[cell->active_cell_index()] >= 0.) cells_.push_back({cell});
}

void YieldingWatch::see(const State& state, int step, int n_steps) {
  strains_.see(state, step, n_steps);
  const std::vector<std::vector<BorneStress>> borne = soil_.borne();
  for (Soil& soil : cells_) {
    const double now = mobilised(borne[soil.cell->active_cell_index()]);
    if (step == 0) soil.initial = soil.largest = now;
    if (step > 0 && now <= soil.largest) continue;
    soil.largest = now;
    soil.time = state.time;
  }
}

std::vector<double> YieldingWatch::memory() const {
  std::vector<double> memory = strains_.memory();
  for (const Soil& soil : cells_) memory.insert(memory.end(), {soil.initial, soil.largest, soil.time});
  return memory;
}

void YieldingWatch::recall(const std::vector<double>& memory) {
  const auto n = static_cast<std::ptrdiff_t>(memory.size() - 3 * cells_.size());
  strains_.recall({memory.begin(), memory.begin() + n});
  const double* from = memory.data() + n;
  for (Soil& soil : cells_)
    for (double* number : {&soil.initial, &soil.largest, &soil.time}) *number = *from++;
}

std::vector<MobilisedRegion> YieldingWatch::regions() const {
  std::map<std::string, MobilisedRegion> by_name;
  std::map<std::string, double> area;
  for (const Soil& soil : cells_) {
    const std::string& name = space_.mesh().surface_of(soil.cell);
    MobilisedRegion& of = by_name[name];
    of.region = name;
    of.law = word_of(space_.region(soil.cell).law, soil_law_words);
    const double size = area_of(soil.cell);
    area[name] += size;
    of.initial = std::max(of.initial, soil.initial);
    if (soil.initial >= all_of_it) of.initial_share += size;
    if (soil.largest >= all_of_it) of.share += size;
    if (soil.largest <= of.largest * (1. + nearly_as_large)) continue;  // of cells alike the first
    of.largest = soil.largest;
    of.at = middle_of(soil.cell);
    of.time = soil.time;
  }
  std::vector<MobilisedRegion> list;
  for (auto& [name, of] : by_name) {
    of.initial_share /= area[name];
    of.share /= area[name];
    list.push_back(of);
  }
  return list;
}

/// Mean of the largest shear strains of the cells that share a face with this one and may yield; 0 where there are
/// none.
double YieldingWatch::mean_beside(const Soil& soil) const {
  double sum = 0.;
  int n = 0;
  for (const unsigned f : soil.cell->face_indices()) {
    if (soil.cell->at_boundary(f) || soil.cell->neighbor(f)->has_children()) continue;
    const auto other = soil.cell->neighbor(f)->active_cell_index();
    if (soil_.dissipated()[other] < 0.) continue;
    sum += strains_.shear()[other];
    ++n;
  }
  return n > 0 ? sum / n : 0.;
}

PeakStrain YieldingWatch::peak_strain() const {
  PeakStrain peak;
  const auto shear = [this](const Soil& soil) { return strains_.shear()[soil.cell->active_cell_index()]; };
  const auto largest =
      std::max_element(cells_.begin(), cells_.end(), [&](const Soil& a, const Soil& b) { return shear(a) < shear(b); });
  if (largest == cells_.end()) return peak;
  peak.value = shear(*largest);
  peak.at = middle_of(largest->cell);
  if (const double beside = mean_beside(*largest); beside > 0.) peak.over_neighbours = peak.value / beside;
  return peak;
}

std::optional<PorePressureLeft> pore_pressure_left(const Space& space, const Unknowns& unknowns, const State& state) {
  const Vector pressure = unknowns.expand(state.v);
  std::optional<PorePressureLeft> largest;
  for (const auto& cell : space.dofs().active_cell_iterators()) {
    if (!space.has_pores(cell)) continue;
    const Dofs dofs = dofs_of(cell);
    for (unsigned i = 0; i < dofs.size(); ++i) {
      if (cell->get_fe().system_to_component_index(i).first != phi_component) continue;
      const double value = pressure[static_cast<Eigen::Index>(dofs[i])];
      if (largest && std::abs(value) <= std::abs(largest->value)) continue;
      const dealii::Point<dim> at = node_of(space, cell, i).at;
      largest = PorePressureLeft{value, {at[0], at[1]}};
    }
  }
  return largest;
}

}  // namespace upbead
