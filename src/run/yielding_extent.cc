#include "run/yielding_extent.h"

#include "fem/space.h"

namespace upbead {

namespace {

const char* why_linear(const Region& region) {
  if (region.kind == RegionKind::rigid || region.deformation == Deformation::rigid) return "it moves as a rigid body";
  if (region.kind == RegionKind::water) return "free water is taken as linear: small waves, no cavitation";
  if (region.strain_law) return "law = \"elastic\": stiffness and damping by its largest strain, the same at all times";
  return "law = \"elastic\": it bears any stress";
}

}  // namespace

YieldingExtent yielding_extent(const Simulation& simulation) {
  YieldingExtent extent;
  const Space& space = *simulation.space();
  for (const Cell& cell : space.dofs().active_cell_iterators()) {
    if (!space.has_matrices(cell) || space.kind(cell) == CellKind::water) continue;
    ++extent.of;
    if (space.region(cell).law == SoilLaw::elastic) continue;
    ++extent.cells;
    extent.area += area_of(cell);
  }
  for (const auto& [name, region] : simulation.scene().regions)
    if (region.law == SoilLaw::elastic) extent.linear.push_back({name, why_linear(region)});
  return extent;
}

}  // namespace upbead
