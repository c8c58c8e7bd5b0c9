#include "fem/yielding_soil.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <map>

#include "fem/kernels.h"

namespace upbead {

using namespace dealii;

namespace {

/// What a row of unknowns strains at a point, and for how much area the point stands.
struct Point {
  int first_entry;  ///< of its entries in the lists of the soil
  int n_entries;
  int cell;
  double area;  ///< m2
};

class YieldingSoil : public InternalForce {
 public:
  YieldingSoil(const Space& space, const Unknowns& unknowns, const CellLaws& laws);

  const std::vector<int>& rows() const override { return rows_; }
  void evaluate(const Vector& x, Vector& p) override;
  double commit(const Vector& x) override;
  double stored_beside_elastic() const override;

 private:
  void add_cell(const Space& space, const Cell& cell, const Unknowns& unknowns);
  void add_point(const std::map<int, PlaneStrain>& strain, int cell, double area);
  void number_rows();
  PlaneStrain strain(const Point& point, const Vector& x) const;

  CellLaws laws_;
  std::vector<ElasticLaw> elastic_;  ///< by active cell index
  std::vector<Point> points_;
  std::vector<int> unknown_;                     ///< of an entry
  std::vector<int> row_;                         ///< likewise, its place in rows_
  std::vector<PlaneStrain> shape_;               ///< strain by this unknown
  std::vector<HystereticLaw::State> committed_;  ///< by point
  HystereticLaw::State scratch_;
  std::vector<int> rows_;
};

YieldingSoil::YieldingSoil(const Space& space, const Unknowns& unknowns, const CellLaws& laws) : laws_(laws) {
  for (const Cell& cell : space.dofs().active_cell_iterators()) {
    elastic_.push_back(space.material(cell));
    if (laws_[cell->active_cell_index()]) add_cell(space, cell, unknowns);
  }
  number_rows();
}

/// As many points as the stiffness of the same cell has.
void YieldingSoil::add_cell(const Space& space, const Cell& cell, const Unknowns& unknowns) {
  FEValues<dim> values(space.mapping(), cell->get_fe(), QGauss<dim>(static_cast<unsigned>(space.degree()) + 1),
                       update_gradients | update_JxW_values);
  values.reinit(typename Triangulation<dim>::cell_iterator(cell));
  const Dofs dofs = dofs_of(cell);
  for (unsigned q = 0; q < values.n_quadrature_points; ++q) {
    std::map<int, PlaneStrain> strain;
    for (unsigned i = 0; i < dofs.size(); ++i) {
      const PlaneStrain of = strain_of(values, i, q);
      if (of.xx == 0. && of.yy == 0. && of.xy == 0.) continue;
      for (const auto& [unknown, weight] : unknowns.expansion(dofs[i])) {
        PlaneStrain& sum = strain[unknown];
        sum = {sum.xx + weight * of.xx, sum.yy + weight * of.yy, sum.xy + weight * of.xy};
      }
    }
    add_point(strain, static_cast<int>(cell->active_cell_index()), values.JxW(q));
  }
}

void YieldingSoil::add_point(const std::map<int, PlaneStrain>& strain, int cell, double area) {
  points_.push_back({static_cast<int>(unknown_.size()), static_cast<int>(strain.size()), cell, area});
  committed_.push_back(laws_[cell]->at_rest());
  for (const auto& [unknown, of] : strain) {
    unknown_.push_back(unknown);
    shape_.push_back(of);
  }
}

void YieldingSoil::number_rows() {
  rows_ = unknown_;
  std::sort(rows_.begin(), rows_.end());
  rows_.erase(std::unique(rows_.begin(), rows_.end()), rows_.end());
  for (const int unknown : unknown_)
    row_.push_back(static_cast<int>(std::lower_bound(rows_.begin(), rows_.end(), unknown) - rows_.begin()));
}

PlaneStrain YieldingSoil::strain(const Point& point, const Vector& x) const {
  PlaneStrain sum;
  for (int k = point.first_entry; k < point.first_entry + point.n_entries; ++k) {
    const double value = x[unknown_[k]];
    sum = {sum.xx + value * shape_[k].xx, sum.yy + value * shape_[k].yy, sum.xy + value * shape_[k].xy};
  }
  return sum;
}

void YieldingSoil::evaluate(const Vector& x, Vector& p) {
  p.setZero(static_cast<Eigen::Index>(rows_.size()));
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Point& point = points_[i];
    const PlaneStrain e = strain(point, x);
    scratch_ = committed_[i];
    const PlaneStress s = laws_[point.cell]->update(e, scratch_).stress, elastic = elastic_[point.cell].stress(e);
    const double xx = point.area * (elastic.xx - s.xx), yy = point.area * (elastic.yy - s.yy),
                 xy = 2. * point.area * (elastic.xy - s.xy);
    if (xx == 0. && yy == 0. && xy == 0.) continue;
    for (int k = point.first_entry; k < point.first_entry + point.n_entries; ++k)
      p[row_[k]] += xx * shape_[k].xx + yy * shape_[k].yy + xy * shape_[k].xy;
  }
}

double YieldingSoil::commit(const Vector& x) {
  double dissipated = 0.;
  for (std::size_t i = 0; i < points_.size(); ++i)
    dissipated += points_[i].area * laws_[points_[i].cell]->update(strain(points_[i], x), committed_[i]).dissipated;
  return dissipated;
}

double YieldingSoil::stored_beside_elastic() const {
  double sum = 0.;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const HystereticLaw::State& state = committed_[i];
    const PlaneStress s = elastic_[points_[i].cell].stress(state.strain);
    const double elastic = 0.5 * (s.xx * state.strain.xx + s.yy * state.strain.yy + 2. * s.xy * state.strain.xy);
    sum += points_[i].area * (laws_[points_[i].cell]->stored(state) - elastic);
  }
  return sum;
}

}  // namespace

std::unique_ptr<InternalForce> yielding_soil(const Space& space, const Unknowns& unknowns, const CellLaws& laws) {
  return std::make_unique<YieldingSoil>(space, unknowns, laws);
}

}  // namespace upbead
