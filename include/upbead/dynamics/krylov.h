// Directions in which a system answers its loads: moments of its response about one real frequency.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "upbead/algebra/layout.h"
#include "upbead/system/system.h"

namespace upbead {

struct SlipRow;

namespace detail {
struct KrylovMatrices;
struct SlipColumns;
}  // namespace detail

/// Orthonormal directions of one kind of unknowns: of u with W, or of phi. In a divided system each process holds them
/// in its own unknowns.
struct FieldBasis {
  std::vector<int> unknown;     ///< indices in the system, ascending
  Vector unit;                  ///< unit of each unknown, in which the norm is Euclidean; 1 where it is prescribed
  Eigen::MatrixXd vectors;      ///< by column; columns from n() on are reserved
  std::vector<int> coordinate;  ///< by column: index among the coordinates of both kinds
  Layout layout = {};           ///< of the unknowns

  Eigen::Index n() const { return static_cast<Eigen::Index>(coordinate.size()); }
  auto columns() const { return vectors.leftCols(n()); }
  auto columns_from(Eigen::Index first) const { return vectors.middleCols(first, n() - first); }
};

/// Bases of both kinds.
struct FieldBases {
  FieldBasis displacements, phi;
};

/// Bases of the prescribed unknowns, then of `exact` ones, in units in which all kinds count alike; T = T(s_0), below.
FieldBases exact_bases(const System& system, const SparseMatrix& T, const std::vector<int>& exact);

/// Block second-order Krylov space of a System about a real shift s_0 > 0 [Bai and Su 2005]. With
/// T(s) = s^2 M + s C + K and tau = (s - s_0)/s_0 the response X(s) = T(s)^-1 b is a power series in tau, whose
/// coefficients r_j obey
///
///     T(s_0) r_j = -s_0 (2 s_0 M + C) r_{j-1} - s_0^2 M r_{j-2}.
///
/// An Arnoldi process makes the pairs (r_j, r_{j-1}) orthonormal. It works on their coordinates in two orthonormal
/// bases, one of u with W and one of phi [Lu, Su and Bai 2016, the two-level process TOAR]. A load that prescribes an
/// unknown starts with that unknown's unit motion instead of b. The cost is one factorisation, and one solve per
/// vector. Each prescribed unknown, and each other unknown that is to be kept exactly, is a coordinate of its own. So
/// is each direction to keep, after the part along the directions before it is removed. The System is read by the
/// constructor alone. Of a divided system all processes make the same calls, and the coordinates are the same on each.
class SecondOrderKrylov {
 public:
  /// `exact`: unknowns to keep; `kept`: directions of displacements to keep. Throws NumericsError where T(s_0) is
  /// singular or nothing loads the system, std::invalid_argument where the shift is not positive.
  SecondOrderKrylov(const System& system, double shift, const std::vector<int>& exact = {},
                    const std::vector<Vector>& kept = {});
  /// The space of one unknown more, its slip: the other unknowns answer its unit motion,
  ///
  ///     T(s_0) r_0 = -t(s_0),    t(s) = s^2 M_slip + s C_slip + K_slip, the slip's column,
  ///
  /// and r_j as above. Matrices, factors and units are those of `of`, which another thread may extend meanwhile; none
  /// is factorised. Directions are those of the unknowns of `of`; the slip itself is coordinate 0, in a unit of its
  /// own.
  SecondOrderKrylov(const SecondOrderKrylov& of, const SlipRow& slip);
  ~SecondOrderKrylov();

  /// Adds a vector; false where the space is exhausted.
  bool extend();
  /// Adds as many vectors as there are independent loads, side by side: bases and factors are read once for all of
  /// them. They span what extend() would add, in other directions. False where the space is exhausted. Not of a divided
  /// system nor of a slip.
  bool extend_together();

  const FieldBasis& displacements() const { return u_; }
  const FieldBasis& phi() const { return phi_; }
  double shift() const { return shift_; }
  int n_vectors() const { return n_vectors_; }
  int n_coordinates() const { return n_coordinates_; }
  /// How many directions, of displacements and of phi, the first n vectors span, with those that are kept; n >= 1.
  const std::array<Eigen::Index, 2>& n_directions(int n) const {
    return n_directions_[static_cast<std::size_t>(n - 1)];
  }
  /// Number of linearly independent loads.
  int n_independent_loads() const { return n_starts_; }
  int n_solves() const { return n_solves_; }
  /// Wall time of the factorisation (s).
  double factorise_seconds() const { return factorise_seconds_; }

 private:
  void start(const System& system);
  void start_slip();
  /// Coordinates of x in both bases, and of a slip; first adds to the bases the part of x that they do not span.
  Vector take(const Vector& x, double slip = 0.);
  void take(FieldBasis& basis, const Vector& x, double least, Vector& coordinates);
  void take_together(FieldBasis& basis, const Eigen::MatrixXd& x, Eigen::MatrixXd& coordinates);
  Vector vector_of(const Eigen::Ref<const Vector>& coordinates) const;
  /// Appends a pair, given by the coordinates of both vectors, unless it lies in the span of the pairs so far.
  bool append(const Vector& x, const Eigen::Ref<const Vector>& previous);
  void solve(Vector& rhs, Vector& x);
  /// The vector after that of these coordinates, before it is solved for.
  Vector next(const Vector& of_x, const Vector& of_previous);

  int n_unknowns_;
  double shift_;
  double factorise_seconds_ = 0.;
  std::shared_ptr<detail::KrylovMatrices> matrices_;
  std::unique_ptr<detail::SlipColumns> slip_;  ///< of the space of a slip
  FieldBasis u_, phi_;
  Eigen::MatrixXd x_, previous_;  ///< coordinates of the orthonormal pairs, by column
  int n_vectors_ = 0, n_coordinates_ = 0, n_starts_ = 0, n_expanded_ = 0, n_solves_ = 0;
  std::vector<std::array<Eigen::Index, 2>> n_directions_;  ///< by vector
};

}  // namespace upbead
