// One reduced model for many Systems that are sums of the same parts.
#pragma once

#include <vector>

#include "upbead/dynamics/krylov.h"
#include "upbead/dynamics/reduced_system.h"
#include "upbead/system/system.h"

namespace upbead {

/// Share of the directions that the smaller of two nested members has, by which a family's error is estimated.
constexpr double nested_share = 0.5;
/// The estimate is at least this multiple of the largest difference between both members' responses, see docs/soils.md.
constexpr double nested_safety = 1.6;

/// fixed + sum_q factor_q part_q in the coordinates of one basis: M, C, K, and the rows of the readings; all else is
/// that of `fixed`. The first `n_kept` coordinates are the prescribed unknowns and those that are kept exactly.
struct ReducedFamily {
  ReducedSystem fixed;
  std::vector<ReducedSystem> parts;
  int n_kept = 0;
  /// Where the members are of a body that slips: its last kept coordinate is the slip, and so many of the last loads
  /// and readings are the slip's.
  int slip_loads = 0, slip_readings = 0;
  double safety = nested_safety;  ///< the estimate of a member's error over the difference of nested members

  bool slips() const { return slip_loads > 0; }
  /// Throws std::invalid_argument where there are not as many factors as parts.
  ReducedSystem at(const std::vector<double>& factors) const;
  /// The member with its slip held, where it slips; `share`: see leading().
  ReducedSystem bonded(const std::vector<double>& factors, double share = 1.) const;
  /// Coordinates that a bonded member keeps.
  int n_kept_bonded() const { return n_kept - (slips() ? 1 : 0); }
};

/// The family in other coordinates q = rotation q_new: R x R', with orthonormal columns, each of one kind of unknowns.
ReducedFamily rotated(const ReducedFamily& family, const Eigen::MatrixXd& rotation);
ReducedSystem rotated(const ReducedSystem& member, const Eigen::MatrixXd& rotation);

/// A member without the last coordinates of both kinds: `share` of those that are not kept remain.
ReducedSystem leading(const ReducedSystem& member, int n_kept, double share);

/// A member without its last loads and readings.
ReducedSystem without_last(ReducedSystem member, int loads, int readings);

/// A member with some coordinate held at zero, and without its last loads and readings.
ReducedSystem holding(const ReducedSystem& member, int coordinate, int fewer_loads, int fewer_readings);

/// A member whose readings are sums of its own: a row of `sums` for each.
ReducedSystem with_readings(ReducedSystem member, const Eigen::MatrixXd& sums, std::vector<ReadingLabel> labels);

/// What as_system() takes over from the System that was reduced, where the member's readings are not those of it.
System names_of(const ReducedSystem& member, const std::vector<SystemLoad>& loads);

/// A member as a System of its own, small and dense: its unknowns are the coordinates, the prescribed ones last. Loads,
/// readings and their names are those of `of`, the System that was reduced.
System as_system(const ReducedSystem& member, const System& of);

/// Vectors per independent load of a member's own reduction: solves cost nothing beside eigenvalues, so that few models
/// are compared.
constexpr int first_of_member = 40, most_of_member = 200;

/// The basis of phi of a family as that of its bonded members: a column's `coordinate` is an unknown of as_system().
FieldBasis of_bonded_members(FieldBasis phi, const ReducedFamily& family);
/// The basis of phi of a member's own reduction, in unknowns of the scene; `phi`: see of_bonded_members().
FieldBasis in_scene(const FieldBasis& of_reduction, const FieldBasis& phi);

/// The index in as_system() of a coordinate.
int unknown_of(const ReducedSystem& member, int coordinate);

}  // namespace upbead
