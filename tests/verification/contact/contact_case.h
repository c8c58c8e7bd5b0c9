// Breakwaters whose caisson slips and lifts, marched with the law of contact.
#pragma once

#include "dynamics/contact.h"
#include "record.h"
#include "scenes.h"
#include "upbead/sliding/block.h"

namespace upbead::test {

constexpr double friction = 0.6;

/// A caisson of 18 m by 16 m on the drained section of the tests, in 9 m of water, under a force at `arm` above its
/// bottom (m).
Scene drained_section(const TimeFunction& force, double arm);
/// The same with pore water and a sea on both sides; for a mesh with_sea().
Scene wet_section(const TimeFunction& force, double arm);
/// Makes the ground so stiff that it does not move.
void stiffen(Scene& scene);
/// m (kg/m) and W' (N/m) of that caisson.
double caisson_mass();
double submerged_weight();

/// How the bottom slips and lifts: node by node, or as a whole.
enum class Bottom { nodes, whole };

/// Results of a march with contact.
struct ContactMarch {
  ContactMarch(const Scene& scene, const Mesh& mesh, double mu, double end, double step, Bottom bottom = Bottom::nodes);

  Compiled compiled;
  System system;
  Response response;
  ContactReport report;
  Eigen::MatrixXd slip, opening;  ///< by node and step
  Eigen::MatrixXd shear, normal;  ///< T_i, N_i by node and step
  Eigen::RowVectorXd mean_slip() const;
  double S() const { return mean_slip().tail(1)[0]; }
  double largest_slip() const { return mean_slip().cwiseAbs().maxCoeff(); }
  const EnergyAccount& energy() const { return response.energy.back(); }
};

}  // namespace upbead::test
