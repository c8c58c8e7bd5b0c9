#include "fem/yielding_soil.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <map>
#include <utility>

#include "fem/followed_stress.h"
#include "fem/kernels.h"

namespace upbead {

using namespace dealii;

namespace {

/// Of several numbered things the strain that each makes of a point, all points one after the other.
struct Shapes {
  std::vector<int> number;
  std::vector<PlaneStrain> strain;

  int size() const { return static_cast<int>(number.size()); }
  void append(const std::map<int, PlaneStrain>& of_point) {
    for (const auto& [i, of] : of_point) {
      number.push_back(i);
      strain.push_back(of);
    }
  }
};

/// Where the entries of a point end, and for how much area it stands.
struct Point {
  std::unique_ptr<SoilPoint> soil;
  int cell;
  double area;                       ///< m2
  int end_of_unknowns, end_of_sums;  ///< in the lists; they begin where those of the point before end
};

void add(std::map<int, PlaneStrain>& sums, int number, double weight, const PlaneStrain& of) {
  PlaneStrain& sum = sums[number];
  sum = {sum.xx + weight * of.xx, sum.yy + weight * of.yy, sum.xy + weight * of.xy};
}

/// Readings in which a nodal force counts, and how much, by degree of freedom.
std::vector<Row> readings_of_dofs(const Space& space, const std::vector<Reading>& readings) {
  std::vector<Row> of_dof(space.dofs().n_dofs());
  for (std::size_t r = 0; r < readings.size(); ++r)
    for (const auto& [dof, weight] : readings[r].nodal_forces) of_dof[dof].emplace_back(static_cast<int>(r), weight);
  return of_dof;
}

class SoilOfCells : public YieldingSoil {
 public:
  SoilOfCells(const Space& space, const Unknowns& unknowns, const std::vector<Reading>& readings,
              const PointsOfCells& points, const std::vector<FollowedReading>& followed);

  const std::vector<int>& rows() const override { return rows_; }
  void evaluate(const Vector& x, Vector& p) override;
  double commit(const Vector& x) override;
  const Vector& added_to_readings() const override { return added_; }
  double stored_beside_elastic() const override;
  double exerted() const override { return exerted_.norm(); }
  const std::vector<double>& dissipated() const override { return lost_; }
  std::vector<BorneStress> borne(unsigned cell) const override;

 private:
  void add_point(const FEValues<dim>& values, unsigned q, const Dofs& dofs, const Unknowns& unknowns,
                 const std::vector<Row>& readings);
  void number_rows();
  PlaneStrain strain(std::size_t point, const Vector& x) const;
  /// Of the elastic stress less that of the soil (N/m), at a strain.
  PlaneStress correction(const Point& point, const PlaneStrain& strain, const PlaneStress& s) const;

  std::vector<ElasticLaw> elastic_;  ///< by active cell index
  std::vector<Point> points_;
  Shapes unknowns_, sums_;  ///< by unknowns, and by readings: of the displacements whose nodal forces they sum up
  std::vector<int> row_;    ///< of an entry of unknowns_, its place in rows_
  std::vector<int> rows_;
  std::vector<double> lost_;                ///< by active cell index (J/m)
  std::vector<dealii::Point<dim>> places_;  ///< of the points
  std::vector<std::size_t> first_;          ///< point of each active cell, and where the last one's end
  FollowedStress followed_;
  Vector x_;        ///< committed
  Vector exerted_;  ///< by the soil in its rows, at x_
  Vector added_;    ///< to readings
};

SoilOfCells::SoilOfCells(const Space& space, const Unknowns& unknowns, const std::vector<Reading>& readings,
                         const PointsOfCells& points, const std::vector<FollowedReading>& followed)
    : followed_(space, unknowns, readings, points, followed),
      x_(Vector::Zero(unknowns.size())),
      added_(Vector::Zero(static_cast<Eigen::Index>(readings.size()))) {
  const std::vector<Row> of_dof = readings_of_dofs(space, readings);
  for (const Cell& cell : space.dofs().active_cell_iterators()) {
    elastic_.push_back(space.material(cell));
    const unsigned index = cell->active_cell_index();
    first_.push_back(points_.size());
    std::unique_ptr<SoilPoint> soil = points(index);
    lost_.push_back(soil ? 0. : -1.);
    if (!soil) continue;
    // as many points as the stiffness of the cell has
    FEValues<dim> values(space.mapping(), cell->get_fe(), QGauss<dim>(static_cast<unsigned>(space.degree()) + 1),
                         update_gradients | update_quadrature_points | update_JxW_values);
    values.reinit(typename Triangulation<dim>::cell_iterator(cell));
    for (unsigned q = 0; q < values.n_quadrature_points; ++q) {
      points_.push_back({soil ? std::move(soil) : points(index), static_cast<int>(index), values.JxW(q), 0, 0});
      places_.push_back(values.quadrature_point(q));
      add_point(values, q, dofs_of(cell), unknowns, of_dof);
    }
  }
  first_.push_back(points_.size());
  number_rows();
}

void SoilOfCells::add_point(const FEValues<dim>& values, unsigned q, const Dofs& dofs, const Unknowns& unknowns,
                            const std::vector<Row>& readings) {
  std::map<int, PlaneStrain> by_unknown, by_reading;
  for (unsigned i = 0; i < dofs.size(); ++i) {
    const PlaneStrain of = strain_of(values, i, q);
    if (of.xx == 0. && of.yy == 0. && of.xy == 0.) continue;
    for (const auto& [unknown, weight] : unknowns.expansion(dofs[i])) add(by_unknown, unknown, weight, of);
    for (const auto& [reading, weight] : readings[dofs[i]]) add(by_reading, reading, weight, of);
  }
  unknowns_.append(by_unknown);
  sums_.append(by_reading);
  points_.back().end_of_unknowns = unknowns_.size();
  points_.back().end_of_sums = sums_.size();
}

void SoilOfCells::number_rows() {
  rows_ = unknowns_.number;
  std::sort(rows_.begin(), rows_.end());
  rows_.erase(std::unique(rows_.begin(), rows_.end()), rows_.end());
  for (const int unknown : unknowns_.number)
    row_.push_back(static_cast<int>(std::lower_bound(rows_.begin(), rows_.end(), unknown) - rows_.begin()));
}

PlaneStrain SoilOfCells::strain(std::size_t point, const Vector& x) const {
  PlaneStrain sum;
  for (int k = point > 0 ? points_[point - 1].end_of_unknowns : 0; k < points_[point].end_of_unknowns; ++k) {
    const double value = x[unknowns_.number[k]];
    const PlaneStrain& of = unknowns_.strain[k];
    sum = {sum.xx + value * of.xx, sum.yy + value * of.yy, sum.xy + value * of.xy};
  }
  return sum;
}

PlaneStress SoilOfCells::correction(const Point& point, const PlaneStrain& strain, const PlaneStress& s) const {
  const PlaneStress elastic = elastic_[point.cell].stress(strain);
  return {point.area * (elastic.xx - s.xx), point.area * (elastic.yy - s.yy), 2. * point.area * (elastic.xy - s.xy)};
}

void SoilOfCells::evaluate(const Vector& x, Vector& p) {
  p.setZero(static_cast<Eigen::Index>(rows_.size()));
  int k = 0;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const PlaneStrain e = strain(i, x);
    const PlaneStress c = correction(points_[i], e, points_[i].soil->stress(e));
    for (; k < points_[i].end_of_unknowns; ++k) {
      const PlaneStrain& of = unknowns_.strain[k];
      p[row_[k]] += c.xx * of.xx + c.yy * of.yy + c.xy * of.xy;
    }
  }
}

/// A nodal force on the ground is K x - p, summed up over its cells.
double SoilOfCells::commit(const Vector& x) {
  double dissipated = 0.;
  added_.setZero();
  exerted_.setZero(static_cast<Eigen::Index>(rows_.size()));
  int j = 0, k = 0;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const double area = points_[i].area;
    const PlaneStrain e = strain(i, x);
    const PlaneStress s = points_[i].soil->stress(e), c = correction(points_[i], e, s);
    for (; j < points_[i].end_of_unknowns; ++j) {
      const PlaneStrain& of = unknowns_.strain[j];
      exerted_[row_[j]] += area * (s.xx * of.xx + s.yy * of.yy + 2. * s.xy * of.xy);
    }
    for (; k < points_[i].end_of_sums; ++k) {
      const PlaneStrain& of = sums_.strain[k];
      added_[sums_.number[k]] -= c.xx * of.xx + c.yy * of.yy + c.xy * of.xy;
    }
    const double lost = area * points_[i].soil->commit(e);
    lost_[points_[i].cell] += lost;
    dissipated += lost;
  }
  followed_.commit(x, added_);
  x_ = x;
  return dissipated;
}

std::vector<BorneStress> SoilOfCells::borne(unsigned cell) const {
  std::vector<BorneStress> list;
  for (std::size_t i = first_[cell]; i < first_[cell + 1]; ++i)
    list.push_back({places_[i], points_[i].soil->borne(), points_[i].soil->mobilised()});
  return list;
}

double SoilOfCells::stored_beside_elastic() const {
  double sum = 0.;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const PlaneStrain e = strain(i, x_);
    const PlaneStress s = elastic_[points_[i].cell].stress(e);
    const double elastic = 0.5 * (s.xx * e.xx + s.yy * e.yy + 2. * s.xy * e.xy);
    sum += points_[i].area * (points_[i].soil->stored() - elastic);
  }
  return sum;
}

}  // namespace

std::unique_ptr<YieldingSoil> yielding_soil(const Space& space, const Unknowns& unknowns,
                                            const std::vector<Reading>& readings, const PointsOfCells& points,
                                            const std::vector<FollowedReading>& followed) {
  return std::make_unique<SoilOfCells>(space, unknowns, readings, points, followed);
}

}  // namespace upbead
