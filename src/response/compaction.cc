#include "response/compaction.h"

#include <algorithm>
#include <map>

#include "base/text.h"
#include "fem/kernels.h"

namespace upbead {

namespace {

/// Share of the region's mean: where the mean stress at rest is smaller, any load takes it away, so such points are
/// left out.
constexpr double least_rest = 0.1;
/// Lost share of the stress from which soil counts as liquefied.
constexpr double liquefied = 0.95;
/// Largest amplitude without a warning; the tests behind the law went up to 3e-3 (Martin, Finn and Seed 1975).
constexpr double largest_tested = 1e-2;

/// The points of one region, each with its share of the area.
struct Soil {
  struct Part {
    Cell cell;
    const CompactingPoint* point;
    double area = 0.;
  };
  std::vector<Part> parts;
  double area = 0., rest = 0.;  ///< m2; mean effective stress at rest times area (N)
};

std::map<std::string, Soil> by_region(const Space& space, const CompactingPoints& points) {
  std::map<unsigned, int> points_in;
  for (const auto& [cell, point] : points) ++points_in[cell];
  std::vector<Cell> cells(space.mesh().triangulation.n_active_cells());
  for (const Cell& cell : space.dofs().active_cell_iterators()) cells[cell->active_cell_index()] = cell;
  std::map<std::string, Soil> soils;
  for (const auto& [index, point] : points) {
    const double area = area_of(cells[index]) / points_in[index];
    Soil& soil = soils[space.mesh().surface_of(cells[index])];
    soil.parts.push_back({cells[index], point, area});
    soil.area += area;
    soil.rest += area * std::max(point->mean_at_rest(), 0.);
  }
  return soils;
}

std::array<double, 2> middle(const Cell& cell) {
  return {cell->center()[0], cell->center()[1]};
}

/// The share of the mean effective stress at rest that is lost: from 0 to 1, where nothing is left.
double lost_share(const CompactingPoint& point, double mean) {
  return std::clamp(1. - mean / point.mean_at_rest(), 0., 1.);
}

void take_pressure(const Soil::Part& part, const Soil& soil, CompactedSoil& found) {
  if (!(part.point->mean_at_rest() >= least_rest * soil.rest / soil.area) || soil.rest == 0.) {
    found.left_out += part.area / soil.area;
    return;
  }
  const double ratio = lost_share(*part.point, part.point->least_mean());
  if (ratio > found.largest_pressure_ratio) {
    found.largest_pressure_ratio = ratio;
    found.pressure_ratio_at = middle(part.cell);
  }
  found.pressure_ratio_at_end = std::max(found.pressure_ratio_at_end, lost_share(*part.point, part.point->mean()));
  if (ratio >= liquefied) found.share_liquefied += part.area / soil.area;
}

void take_cycles(const Soil::Part& part, const Soil& soil, CompactedSoil& found) {
  const ShearCycles& cycles = part.point->cycles();
  if (cycles.compaction() > found.largest) {
    found.largest = cycles.compaction();
    found.at = middle(part.cell);
  }
  found.mean += cycles.compaction() * part.area / soil.area;
  found.largest_amplitude = std::max(found.largest_amplitude, cycles.largest_amplitude());
  found.reversals = std::max(found.reversals, cycles.reversals());
  found.energy += part.area * part.point->taken();
}

/// Largest p = phi' at the nodes of a cell (Pa).
double largest_pressure(const Cell& cell, const Unknowns& unknowns, const State& state) {
  const Dofs dofs = dofs_of(cell);
  double largest = 0.;
  for (unsigned i = 0; i < dofs.size(); ++i) {
    if (cell->get_fe().system_to_component_index(i).first != phi_component) continue;
    double p = 0.;
    for (const auto& [unknown, weight] : unknowns.expansion(dofs[i])) p += weight * state.v[unknown];
    largest = std::max(largest, p);
  }
  return largest;
}

}  // namespace

std::vector<CompactedSoil> compacted_soils(const Space& space, const Unknowns& unknowns, const CompactingPoints& points,
                                           const State& end) {
  std::vector<CompactedSoil> list;
  for (const auto& [name, soil] : by_region(space, points)) {
    CompactedSoil found;
    found.region = name;
    for (const Soil::Part& part : soil.parts) {
      take_cycles(part, soil, found);
      take_pressure(part, soil, found);
      if (space.has_pressure(part.cell))
        found.pressure_at_end =
            std::max(found.pressure_at_end.value_or(0.), largest_pressure(part.cell, unknowns, end));
    }
    list.push_back(found);
  }
  return list;
}

NumberedWarnings compaction_warnings(const std::vector<CompactedSoil>& soils) {
  NumberedWarnings list;
  for (const CompactedSoil& soil : soils) {
    if (soil.largest_pressure_ratio >= liquefied)
      list.push_back({"liquefied", soil.largest_pressure_ratio, liquefied, "1",
                      "in " + significant(100. * soil.share_liquefied, 2) + " % of region '" + soil.region +
                          "' the mean effective stress falls to " +
                          significant(100. * (1. - soil.largest_pressure_ratio), 2) + " % of that at rest, most at " +
                          place_text(soil.pressure_ratio_at) +
                          ": it has liquefied. Strength of hysteretic soil stays that at rest",
                      "trust no displacement, and compare with law = \"mohr_coulomb\", which follows the stress that "
                      "is left"});
    if (soil.largest_amplitude > largest_tested)
      list.push_back({"beyond_compaction", soil.largest_amplitude, largest_tested, "1",
                      "region '" + soil.region + "' is sheared by an amplitude of " +
                          significant(soil.largest_amplitude, 2) +
                          ": densification was measured up to 0.003, and dense sand dilates at so much",
                      "trust no volumetric strain of '" + soil.region + "' where it is sheared so much"});
  }
  return list;
}

}  // namespace upbead
