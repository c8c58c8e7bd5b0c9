// The planes that bound the stress of a Mohr-Coulomb soil in principal stresses, and the return to them.
#pragma once

#include <array>

#include "upbead/material/elastic_law.h"

namespace upbead {

using Principals = std::array<double, 3>;  ///< in descending order

/// k s1 - s3 <= strength, in all orders that a sorted stress may violate, with flow by m s1 - s3; s_i <= tension.
class MohrCoulombPlanes {
 public:
  MohrCoulombPlanes(const ElasticLaw& elastic, double k, double m, double strength, double tension);

  /// A set of `n` planes, and the stress on all of them.
  struct Return {
    Principals stress;
    std::array<int, 3> planes;
    int n = 0;
  };
  /// The first set (smaller sets first) for which the stress on it violates no plane and no multiplier is negative
  /// (Koiter): s = trial - D B l, A (trial - D B l) = limits. Throws NumericsError where there is none: the trial is
  /// not finite.
  Return from(const Principals& trial) const;
  /// d stress / d (principal strains) on that set.
  std::array<Principals, 3> tangent(const Return& on) const;

  double k, m, strength, tension;  ///< strength: 2 c sqrt(k) (Pa)

 private:
  static constexpr int n_planes = 6;
  bool solve(const std::array<int, 3>& set, int n, const Principals& rhs, Principals& l) const;
  bool try_set(const Principals& trial, double small, Return& on) const;

  double constrained_, lambda_, G_;
  std::array<Principals, n_planes> a_, Db_, aD_;  ///< normals; D times directions of flow; normals times D
  std::array<double, n_planes> limit_;
  std::array<std::array<double, n_planes>, n_planes> aDb_;
};

}  // namespace upbead
