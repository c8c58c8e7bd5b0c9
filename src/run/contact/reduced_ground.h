// Contact node by node on a reduced model of all that is linear.
#pragma once

#include <list>
#include <memory>
#include <string>

#include "dynamics/basis.h"
#include "dynamics/contact.h"
#include "dynamics/interface_space.h"
#include "fem/compile.h"
#include "run/solve.h"

namespace upbead {

/// Whether contact is solved on a reduced ground: where the case asks for time.scheme = "reduced", and asks for nothing
/// that needs the whole states or the account of energies.
bool reduces_ground(const Simulation& simulation);
/// What stands against it, for a case that asks for it; "" where nothing does.
std::string why_ground_is_whole(const Simulation& simulation);

/// Nested models of one ground, each made once. They do not depend on how loads go in time, nor on friction and forces
/// at rest, and are the same whoever asked for them before.
class ReducedGround {
 public:
  /// `bonded`: directions in which the bonded caisson answers the loads, see InterfaceSpace.
  ReducedGround(std::shared_ptr<const CompiledScene> compiled, double shift, Eigen::MatrixXd bonded);
  /// Whether it would be the same for that scene, whose System differs at most in what models do not depend on, and
  /// for so many directions.
  bool serves(const CompiledScene& compiled, double shift, Eigen::Index n_bonded) const;
  struct Level {
    InterfaceModel model;
    std::shared_ptr<detail::GroundStages> stages;
    int n_solves;
  };
  /// With the courses of the loads, friction and forces at rest of that system.
  Level& level(int number, const System& system);

 private:
  std::shared_ptr<const CompiledScene> compiled_;
  double shift_;
  Eigen::Index n_bonded_;
  InterfaceSpace space_;
  std::list<Level> levels_;
};

/// The shift of a scene's ground (1/s): the power of 2 next to the scene's own, so that waves of other periods share
/// it.
double shift_of_ground(const Scene& scene);

struct ContactRoom;

/// The kept ground where it serves this scene, else a new one in its place; with the basis of the bonded caisson's
/// model, if `bonded_reduced`.
ReducedGround& ground_of(const Simulation& simulation, ContactRoom& room, bool bonded_reduced);

/// Marches contact with nested models of the ground, until S, peak F_T and F_T(t) of two of them agree. The system has
/// an interface with friction and forces at rest. Throws NumericsError where they do not come close enough, or where a
/// model does not balance.
/// `room`: has the ground, or gets it; with the basis of the bonded caisson's model, if `bonded_reduced`.
Solution contact_on_reduced_ground(const Simulation& simulation, const Marching& marching, ContactRoom& room,
                                   bool bonded_reduced);

}  // namespace upbead
