// A caisson's interface and the few coordinates of its ground, without the space that they came from: what a file of a
// reduced model holds of contact node by node.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "dynamics/ground_matrices.h"
#include "upbead/dynamics/modal_model.h"
#include "upbead/system/system.h"

namespace upbead {

/// One of nested models, as GroundMatrices: r free coordinates, 2n motions of the interface.
struct GroundLevel {
  Eigen::MatrixXd M, C, K;        ///< of the free coordinates; K is a column, its diagonal
  Eigen::MatrixXd U;              ///< 2n x k
  Eigen::MatrixXd M_f, C_f, K_f;  ///< r x k: what couples the free coordinates with the interface is A U'
  std::vector<bool> is_phi;       ///< r
  Eigen::MatrixXd load;           ///< of all coordinates, a column for each load
  Eigen::MatrixXd position, velocity, acceleration, feedthrough;  ///< rows: GroundModel::readings
  int solves = 0;                                                 ///< that it took to make it

  Eigen::Index n_free() const { return K.rows(); }
};

struct GroundModel {
  /// What each level reads: F_T, and what the apparent period and the balance of forces ask for.
  static constexpr std::array<const char*, 4> readings{"shear_force", "caisson/displacement_x", "caisson/rotation",
                                                       "water_force"};
  Interface interface;      ///< with friction and forces at rest of the case
  OfMatrices of_interface;  ///< 2n x 2n, the same in all levels
  double shift = 0.;        ///< 1/s
  std::vector<GroundLevel> levels;
  ModalModel demand;           ///< bonded: forces at the nodes as bonded() reads them
  double margin = 0.;          ///< by which these may be wrong, over their largest
  Eigen::MatrixXd uplift;      ///< n x 2: of the nodes per unit of a prescribed U, under landward and seaward waves
  Eigen::MatrixXd on_caisson;  ///< loads x 2: force per unit, and its arm about the centre of gravity; 0 without one
  double tolerance = 0.;       ///< of F_T, relative
  double step = 0.;            ///< that the case asks for (s); 0: it leaves it open
};

/// A level as a march takes it: a system without readings and histories, and its matrices.
struct MarchedGround {
  System system;
  GroundMatrices matrices;
};
MarchedGround marched(const GroundModel& model, const GroundLevel& level);

}  // namespace upbead
