// Blocks on nodes of ground, on which they may slip and lift off.
#pragma once

#include <vector>

#include "dynamics/contact.h"
#include "upbead/dynamics/march.h"

namespace upbead::test {

/// A rigid block (x, y, rotation about its centre of gravity, anticlockwise) on nodes of ground, each with mass, spring
/// and dashpot to a rigid base and a spring to the next node.
struct BlockOnNodes {
  double mass = 6e5, inertia = 3e7, height = 8.;  ///< kg/m, kg m, m from the nodes to the centre of gravity
  std::vector<double> position = {0.};            ///< of the nodes, from the centre of gravity (m)
  double node_mass = 0., kx = 6e8, ky = 6e8, cx = 0., cy = 0., link = 0.;  ///< of each node
  std::vector<double> normal_force;  ///< at rest (N/m); empty: equal at all nodes, their sum the weight
  double weight = 3.233333333333333e6;
  double friction = 0.6;
  double arm = -8.;  ///< of the force above the centre of gravity; -height: no moment about the nodes

  /// Under the horizontal force P(t) and the vertical one V(t), upwards.
  System system(const TimeFunction& P, const TimeFunction& V = {}) const;
};

/// The triangle from 0 to `peak` in half the duration (s), and back, from t = 0 on.
TimeFunction triangle(double peak, double duration);

/// A march under the law of contact, with the values at the ends of steps.
struct ContactMarch {
  std::vector<State> states;
  std::vector<InterfaceForces> forces;
  std::vector<EnergyAccount> energy;
  std::vector<int> moving_steps;  ///< number of steps so far in which a node slipped or was open
  ContactReport report;
  int n_solves = 0, n_factorisations = 0;

  double mismatch() const;             ///< largest mismatch of the balance of energy
  double least_friction_step() const;  ///< least growth of energy().friction, over largest work
};
ContactMarch march_contact(const System& system, double end, double step, int leap = 1);

}  // namespace upbead::test
