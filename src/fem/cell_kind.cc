#include "fem/cell_kind.h"

namespace upbead {

CellKind kind_of(const Region& region) {
  if (region.kind == RegionKind::water) return CellKind::water;
  if (region.kind != RegionKind::porous || region.flow == Flow::drained) return CellKind::solid;
  return region.flow == Flow::inertial ? CellKind::inertial : CellKind::darcy;
}

}  // namespace upbead
