// Soil of a mesh in static equilibrium: stresses by law at the points of quadrature, their nodal forces and the
// tangent of these.
#pragma once

#include <memory>
#include <vector>

#include "fem/unknowns.h"
#include "material/mohr_coulomb_law.h"

namespace upbead {

/// By active cell index; null where the cell is elastic.
using StaticLaws = std::vector<std::shared_ptr<const MohrCoulombLaw>>;
/// Effective stresses by active cell index and point of quadrature, those of the stiffness (QGauss(degree + 1)).
using PointStresses = std::vector<std::vector<PlaneStress>>;

/// What it exerts is counted from the committed state: strains of the last equilibrium, and the stresses that belong
/// to them. `space` and `unknowns` outlive it.
class StaticSoil {
 public:
  StaticSoil(const Space& space, const Unknowns& unknowns);
  ~StaticSoil();

  /// Laws from now on; the committed state stays, even where they do not bear it.
  void follow(StaticLaws laws);
  /// A tangent without stiffness, as at the apex of a cone, keeps this share of the elastic one. Equilibrium is that of
  /// the stresses, and only the way to it changes: less is faster where much of the soil has no strength and
  /// Newton's method lengthens its steps (StaticSteps::associated), and too little for one that does not.
  void keep_stiffness(double share);
  /// Stresses without strain; cells without any get none.
  void start_from(const PointStresses& stresses);

  /// Nodal forces, integral of B^T sigma, at x.
  void exert(const Vector& x, Vector& force);
  /// Compressed; every unknown has its diagonal.
  const SparseMatrix& pattern() const;
  /// d force / dx where `exert` was asked last, in the order of the pattern.
  void tangent(Eigen::Ref<Vector> values) const;
  /// x becomes history.
  void commit(const Vector& x);

  PointStresses stresses() const;
  /// Largest excess of a committed stress over its law's strength (Pa); 0 or less where all is borne.
  double largest_excess() const;
  /// Of the area that may yield, cells with a point at its strength to 1e-6 of its stress.
  double share_at_strength() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace upbead
