// Soil of a mesh in static equilibrium: stresses by the laws at the points of quadrature, their nodal forces, and the
// tangent.
#pragma once

#include <Eigen/Dense>
#include <memory>
#include <utility>
#include <vector>

#include "fem/unknowns.h"
#include "material/mohr_coulomb_law.h"

namespace upbead {

/// By active cell index; null where the cell is elastic.
using StaticLaws = std::vector<std::shared_ptr<const MohrCoulombLaw>>;
/// Effective stresses by active cell index and point of quadrature, those of the stiffness (QGauss(degree + 1)).
using PointStresses = std::vector<std::vector<PlaneStress>>;

/// Stresses start from the committed state: the strains of the last equilibrium, and the stresses there. `space` and
/// `unknowns` outlive it.
class StaticSoil {
 public:
  StaticSoil(const Space& space, const Unknowns& unknowns);

  /// Sets the laws from now on; the committed state stays, even where the new laws do not bear it.
  void follow(StaticLaws laws) { laws_ = std::move(laws); }
  /// Adds this share of the elastic stiffness to every tangent, which has none at the apex of a cone, for instance. The
  /// equilibrium does not change, as it depends on stresses alone; only the iterations do. A smaller share is faster
  /// where much of the soil has no strength and Newton's method lengthens its steps (StaticSteps::associated), and
  /// too small without that.
  void keep_stiffness(double share) { least_stiffness_ = share; }
  /// Sets stresses at zero strain; cells without given stresses get none.
  void start_from(const PointStresses& stresses);

  /// Nodal forces, integral of B^T sigma, at x.
  void exert(const Vector& x, Vector& force);
  /// Compressed; every unknown has its diagonal.
  const SparseMatrix& pattern() const { return pattern_; }
  /// d force / dx at the x of the last `exert`, in the order of the pattern.
  void tangent(Eigen::Ref<Vector> values) const { assemble(tangents_, values); }
  /// Commits x.
  void commit(const Vector& x);

  /// A point of quadrature, in a fixed order.
  struct Point {
    unsigned cell;  ///< active cell index
    double area;    ///< m2
    ElasticLaw elastic;
    const MohrCoulombLaw* law;  ///< null where the cell is elastic
    PlaneStress stress;         ///< committed
  };
  std::vector<Point> points() const;
  /// (eps_xx, eps_yy, gamma_xy) at every point.
  std::vector<Eigen::Vector3d> strains(const Vector& x) const;
  /// Nodal forces of the stresses (xx, yy, xy) at every point.
  Vector forces(const std::vector<Eigen::Vector3d>& stresses) const;
  /// Sum of area B^T D B over the points, in the order of the pattern.
  void assemble(const std::vector<Eigen::Matrix3d>& D, Eigen::Ref<Vector> values) const;

  PointStresses stresses() const;
  /// Largest excess of a committed stress over the strength of its law (Pa); 0 or less where all stresses are borne.
  double largest_excess() const;
  /// Share of the area of soil with a law whose cells have a point at its strength, to 1e-6 of its stress.
  double share_at_strength() const;

 private:
  /// A cell that deforms.
  struct SoilCell {
    unsigned index;  ///< of the active cell
    ElasticLaw elastic;
    double area;  ///< m2
    std::size_t first_point, end_of_points;
    std::vector<int> entries{};  ///< of the local matrix, row by row, in the pattern
  };
  using Columns = Eigen::Map<const Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::RowMajor>>;

  void number_entries();
  /// Unknowns of a cell, ascending: its points' rows of B have no others.
  Eigen::Map<const Eigen::VectorXi> unknowns_of(const SoilCell& cell) const;
  LawAnswer answer(const SoilCell& cell, const PlaneStrain& strain, MohrCoulombLaw::State& state) const;
  /// Calls of_point(cell, number) for every point.
  template <class Function>
  void each_point(const Function& of_point) const {
    for (const SoilCell& cell : cells_)
      for (std::size_t p = cell.first_point; p < cell.end_of_points; ++p) of_point(cell, p);
  }

  std::vector<SoilCell> cells_;
  SparseMatrix B_;                             ///< (eps_xx, eps_yy, gamma_xy) of one point after the other, by unknowns
  std::vector<double> area_;                   ///< by point, as all that follows (m2)
  std::vector<MohrCoulombLaw::State> states_;  ///< committed
  std::vector<Eigen::Matrix3d> tangents_;      ///< of the last exert()
  StaticLaws laws_;
  SparseMatrix pattern_;
  double least_stiffness_ = 1e-5;  ///< over the elastic one
};

}  // namespace upbead
