#include "fem/caisson/wall_water.h"

#include <algorithm>
#include <stdexcept>

namespace upbead {

WallMass westergaard(double density, double height) {
  const double mass = density * height * height;
  return {7. / 12. * mass, 7. / 30. * mass * height, 2. / 15. * mass * height * height};
}

WallMass beside_walls(const WallWater& heights, double density) {
  const WallMass front = westergaard(density, heights.seaward), back = westergaard(density, heights.landward);
  return {front.mass + back.mass, front.first + back.first, front.second + back.second};
}

BesideWalls::BesideWalls(const Region& region, double density, const Unknowns& unknowns,
                         const std::vector<Body>& bodies, const Caisson& caisson) {
  const auto body = std::find_if(bodies.begin(), bodies.end(), [](const Body& b) { return b.region == caisson_name; });
  if (body == bodies.end()) throw std::logic_error("the caisson beside added mass is no rigid body");
  const auto number = static_cast<std::size_t>(body - bodies.begin());
  const int sway = unknowns.coordinate(number, motion_x), turn = unknowns.coordinate(number, motion_rotation);
  const double arm = caisson.bottom_centre[1] - body->centre[1];  // the base moves by x_G + arm phi
  terms_.prescribed = {sway, turn};
  terms_.matrices.reinit(2);
  const auto add = [&](double height) -> Row {
    const WallMass water = westergaard(density, height);
    const double first = water.first + arm * water.mass;
    terms_.matrices.M(0, 0) += water.mass;
    terms_.matrices.M(0, 1) += first;
    terms_.matrices.M(1, 0) += first;
    terms_.matrices.M(1, 1) += water.second + 2. * arm * water.first + arm * arm * water.mass;
    return {{sway, water.mass}, {turn, first}};
  };
  front_ = add(region.added_mass->seaward);
  back_ = add(region.added_mass->landward);
}

void BesideWalls::add_to(CaissonForces& forces) const {
  forces.water_front.add_mass(motion_x, front_);
  forces.water_back.add_mass(motion_x, back_);
}

}  // namespace upbead
