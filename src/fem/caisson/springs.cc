#include "fem/caisson/springs.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace upbead {

using namespace dealii;

std::optional<BaseLine> lowest_side(const Mesh& mesh) {
  double lowest = std::numeric_limits<double>::infinity(), left = lowest, right = -lowest, length = 0.;
  for (const auto& cell : mesh.triangulation.active_cell_iterators())
    if (mesh.surface_of(cell) == caisson_name)
      for (const unsigned v : cell->vertex_indices()) lowest = std::min(lowest, cell->vertex(v)[1]);
  for (const auto& cell : mesh.triangulation.active_cell_iterators()) {
    if (mesh.surface_of(cell) != caisson_name) continue;
    for (const auto& face : cell->face_iterators()) {
      if (!face->at_boundary() || face->center()[1] > lowest + 1e-6 * face->measure()) continue;
      left = std::min({left, face->vertex(0)[0], face->vertex(1)[0]});
      right = std::max({right, face->vertex(0)[0], face->vertex(1)[0]});
      length += face->measure();
    }
  }
  if (length == 0.) return std::nullopt;
  return BaseLine{Point<dim>(0.5 * (left + right), lowest), right - left};
}

namespace {

/// Mass of the base under a slip, over that of the caisson: slip as a whole is solved for what is below it, and springs
/// have no mass. It swings a few hundred times as fast as the caisson.
constexpr double mass_below_slip = 1e-5;

const Region* caisson_of(const Space& space) {
  for (const auto& cell : space.dofs().active_cell_iterators())
    if (space.mesh().surface_of(cell) == caisson_name) return &space.region(cell);
  return nullptr;
}

std::array<double, n_motions> by_motion(const std::optional<BaseSupport>& support) {
  const BaseSupport of = support.value_or(BaseSupport());
  return {of.horizontal, of.vertical, of.rotation};
}

/// The motions of the base's middle, over the coordinates of the body and, with an interface, slip and opening.
std::array<Row, n_motions> motions_of(const Unknowns& unknowns, int body, const Caisson& caisson) {
  std::array<Row, n_motions> motions;
  const auto coordinate = [&](int m) { return unknowns.coordinate(static_cast<std::size_t>(body), m); };
  const auto turned = unit_motion(motion_rotation, caisson.bottom_centre, caisson.body.centre);
  for (int m = 0; m < n_motions; ++m) {
    motions[m] = {{coordinate(m), 1.}};
    if (m == motion_rotation) continue;
    motions[m].emplace_back(coordinate(motion_rotation), turned[static_cast<unsigned>(m)]);
    if (unknowns.has_interface()) motions[m].emplace_back(unknowns.opening(0) - (m == motion_x ? 1 : 0), -1.);
  }
  return motions;
}

}  // namespace

bool is_on_springs(const Space& space) {
  const Region* caisson = caisson_of(space);
  return caisson != nullptr && caisson->springs.has_value();
}

BaseSprings::BaseSprings(const Region& region, const Space& space, const Unknowns& unknowns,
                         const std::vector<Body>& bodies, const Caisson& caisson)
    : spring_(by_motion(region.springs)), dashpot_(by_motion(region.dashpots)) {
  const auto body = std::find_if(bodies.begin(), bodies.end(), [](const Body& b) { return b.region == caisson_name; });
  if (body == bodies.end()) throw std::logic_error("a caisson on springs is no rigid body");
  motion_ = motions_of(unknowns, static_cast<int>(body - bodies.begin()), caisson);
  for (const auto& cell : space.dofs().active_cell_iterators())
    if (space.mesh().surface_of(cell) == caisson_name) terms_.cell = cell->active_cell_index();
  for (const Row& motion : motion_)
    for (const auto& [unknown, weight] : motion)
      if (std::find(terms_.prescribed.begin(), terms_.prescribed.end(), unknown) == terms_.prescribed.end())
        terms_.prescribed.push_back(unknown);
  const auto place = [this](int unknown) {
    return static_cast<unsigned>(std::find(terms_.prescribed.begin(), terms_.prescribed.end(), unknown) -
                                 terms_.prescribed.begin());
  };
  terms_.matrices.reinit(static_cast<unsigned>(terms_.prescribed.size()));
  const double below = unknowns.has_interface() ? mass_below_slip * caisson.body.mass : 0.;
  for (int m = 0; m < n_motions; ++m)
    for (const auto& [i, a] : motion_[m])
      for (const auto& [j, b] : motion_[m]) {
        if (m != motion_rotation) terms_.matrices.M(place(i), place(j)) += below * (a * b);
        terms_.matrices.K(place(i), place(j)) += spring_[m] * (a * b);
        terms_.matrices.C(place(i), place(j)) += dashpot_[m] * (a * b);
      }
}

void BaseSprings::add_to(NodalReaction& ground) const {
  for (int m = 0; m < n_motions; ++m) ground.add(m, spring_[m], dashpot_[m], motion_[m]);
}

}  // namespace upbead
