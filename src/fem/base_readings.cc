#include "upbead/fem/base_readings.h"

#include <algorithm>
#include <utility>

#include "point_rows.h"
#include "upbead/fem/faces.h"

namespace upbead {

using namespace dealii;

namespace {

struct BottomFace {
  Cell ground;
  unsigned face = 0;
  Point<dim> middle;
};

/// From the sea landward.
std::vector<BottomFace> bottom_faces(const Space& space, const Caisson& caisson) {
  std::vector<BottomFace> faces;
  for (const auto& cell : space.dofs().active_cell_iterators()) {
    const RegionKind kind = space.region(cell).kind;
    if (kind != RegionKind::porous && kind != RegionKind::solid) continue;
    if (space.mesh().surface_of(cell) == caisson.body.region) continue;
    for (const unsigned f : cell->face_indices())
      if (!cell->at_boundary(f) && space.mesh().surface_of(cell->neighbor(f)) == caisson.body.region)
        faces.push_back({cell, f, cell->face(f)->center()});
  }
  std::sort(faces.begin(), faces.end(),
            [](const BottomFace& a, const BottomFace& b) { return a.middle[0] < b.middle[0]; });
  return faces;
}

Row sum(const std::vector<std::pair<double, Row>>& parts) {
  std::map<int, double> entries;
  for (const auto& [factor, row] : parts)
    for (const auto& [unknown, weight] : row) entries[unknown] += factor * weight;
  return to_row(entries);
}

void add_face(const BottomFace& at, const Space& space, const Unknowns& unknowns, const Scene& scene,
              const std::string& prefix, std::vector<Reading>& list) {
  const Region& region = space.region(at.ground);
  const Material ground = material(region, scene.fluid, scene.gravity);
  const PointRows rows(space, unknowns, {at.ground, space.mapping().transform_real_to_unit_cell(at.ground, at.middle)});
  const Tensor<1, dim> n = outward_normal(at.ground, at.face);  // into the caisson
  const Row xx = rows.stress(ground, 0, 0), yy = rows.stress(ground, 1, 1), xy = rows.stress(ground, 0, 1);
  // n.s n and t.s n with t = (n_y, -n_x), landward
  const Row normal = sum({{-n[0] * n[0], xx}, {-n[1] * n[1], yy}, {-2. * n[0] * n[1], xy}});
  const Row shear = sum({{n[1] * n[0], xx}, {-n[0] * n[1], yy}, {n[1] * n[1] - n[0] * n[0], xy}});
  list.push_back({prefix + "normal_stress", "Pa", "change of the effective normal stress", normal, {}, {}, {}});
  list.push_back({prefix + "shear_stress", "Pa", "shear stress on the ground, landward", shear, {}, {}, {}});
  if (space.has_pressure(at.ground))
    list.push_back({prefix + "pore_pressure", "Pa", "excess pore pressure", {}, rows.value(phi_component), {}, {}});
}

}  // namespace

std::vector<double> base_positions(const Space& space, const Caisson& caisson) {
  std::vector<double> x;
  for (const BottomFace& face : bottom_faces(space, caisson)) x.push_back(face.middle[0]);
  return x;
}

std::vector<Reading> base_readings(const Space& space, const Unknowns& unknowns, const Scene& scene,
                                   const Caisson& caisson) {
  std::vector<Reading> list;
  int number = 0;
  for (const BottomFace& face : bottom_faces(space, caisson))
    add_face(face, space, unknowns, scene, base_prefix + std::to_string(number++) + "/", list);
  return list;
}

}  // namespace upbead
