// Motions of the nodes of an interface, each with what the ground does near it.
#pragma once

#include <vector>

#include "upbead/dynamics/krylov.h"
#include "upbead/system/system.h"

namespace upbead {

/// The same of M, C and K.
struct OfMatrices {
  Eigen::MatrixXd M, C, K;
};

/// The unit motions of slip and opening of all nodes. With its part of high degree along the interface, of which little
/// is felt away from it, a motion carries what the displacements in the neighbourhood answer about a real shift, all
/// beyond at rest: constraint modes on a patch.
class CarriedMotions {
 public:
  /// `own`: unknowns that are coordinates themselves, which stay at rest. The system must outlive the object.
  CarriedMotions(const System& system, const SparseMatrix& at_shift, const std::vector<bool>& own);

  /// Degrees of the motions that carry nothing.
  static constexpr Eigen::Index low_degrees = 6;
  /// Orthonormal motions of rising degree, slip and opening in turn.
  const Eigen::MatrixXd& by_degree() const { return by_degree_; }
  const OfMatrices& matrices() const { return matrices_; }
  /// Blocks between the columns of a basis from `first` on, and these motions.
  OfMatrices with(const FieldBasis& basis, Eigen::Index first) const;
  /// What rows over the unknowns read of them.
  Eigen::MatrixXd read(const std::vector<Reading>& readings, Row Reading::*part) const;
  /// The part of a vector along them.
  Vector along(const Vector& vector) const;
  void add_to(const Eigen::Ref<const Vector>& motion, Vector& state) const;

 private:
  void choose_patch(const SparseMatrix& at_shift, const std::vector<bool>& own, int n_layers);
  void carry(const SparseMatrix& at_shift, const Eigen::MatrixXd& high);

  const System& system_;
  Eigen::MatrixXd by_degree_;
  std::vector<int> patch_;    ///< free unknowns, ascending
  std::vector<int> unknown_;  ///< that move: displacements of the patch, and those of the interface
  std::vector<int> near_;     ///< rows of the matrices that these motions reach
  Eigen::MatrixXd motion_;    ///< by unknown that moves
  OfMatrices products_, matrices_;
};

}  // namespace upbead
