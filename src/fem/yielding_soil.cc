#include "fem/yielding_soil.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <string>
#include <tuple>
#include <typeinfo>
#include <utility>

#include "algebra/fail_together.h"
#include "base/crew.h"
#include "base/numbers.h"
#include "fem/cell_pack.h"
#include "fem/followed_stress.h"
#include "system/part.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

using detail::Lanes;

/// Maps unknowns to displacements of the nodes of soil that yields, and nodal forces back to rows of unknowns.
class SoilNodes {
 public:
  /// The local number of a degree of freedom of the space.
  int number(int dof) { return number_.emplace(dof, size()).first->second; }
  int size() const { return static_cast<int>(number_.size()); }
  /// Call after all degrees of freedom have their numbers.
  void connect(const Unknowns& unknowns, int n_unknowns, const std::vector<Reading>& readings, const System* divided);

  /// Unknowns on which the displacements depend, ascending; -1 where another process counts for one.
  const std::vector<int>& rows() const { return rows_here_; }
  /// u has one more entry than nodes, which is zero: lanes without a cell take it.
  void displace(const Vector& x, Vector& u) const { u = of_unknowns_ * x; }
  /// p of the rows, from nodal forces.
  void gather(const Vector& F, Vector& p) const {
    const Vector of_all = of_unknowns_.transpose() * F;
    p = of_all(rows_);
  }
  /// Subtracts from readings the contribution of nodal forces.
  void subtract_from_readings(const Vector& F, Vector& readings) const { readings -= in_readings_ * F; }

 private:
  std::map<int, int> number_;
  std::vector<int> rows_, rows_here_;
  SparseMatrix of_unknowns_, in_readings_;  ///< displacements by unknowns; readings by nodal forces
};

/// The numbers that this process has for rows of the whole system.
std::vector<int> numbers_here(const std::vector<int>& rows, const System& part) {
  std::vector<int> here(rows.size(), -1);
  for (const auto& [number, whole] : part.part.counted)
    if (const auto at = std::lower_bound(rows.begin(), rows.end(), whole); at != rows.end() && *at == whole)
      here[static_cast<std::size_t>(at - rows.begin())] = number;
  return here;
}

void SoilNodes::connect(const Unknowns& unknowns, int n_unknowns, const std::vector<Reading>& readings,
                        const System* divided) {
  std::vector<Eigen::Triplet<double>> displacement, reading;
  for (const auto& [dof, node] : number_)
    for (const auto& [unknown, weight] : unknowns.expansion(static_cast<unsigned>(dof)))
      if (unknown < n_unknowns) {
        displacement.emplace_back(node, unknown, weight);
        rows_.push_back(unknown);
      }
  std::sort(rows_.begin(), rows_.end());
  rows_.erase(std::unique(rows_.begin(), rows_.end()), rows_.end());
  rows_here_ = divided != nullptr ? numbers_here(rows_, *divided) : rows_;
  for (std::size_t r = 0; r < readings.size(); ++r)
    for (const auto& [dof, weight] : readings[r].nodal_forces)
      if (const auto found = number_.find(static_cast<int>(dof)); found != number_.end())
        reading.emplace_back(static_cast<int>(r), found->second, weight);
  of_unknowns_.resize(size() + 1, n_unknowns);
  of_unknowns_.setFromTriplets(displacement.begin(), displacement.end());
  in_readings_.resize(static_cast<Eigen::Index>(readings.size()), size() + 1);
  in_readings_.setFromTriplets(reading.begin(), reading.end());
}

/// Cells of one kind, to be grouped into packs.
struct Waiting {
  std::vector<CellShapes> shapes;
  std::vector<SoilPoints> cells;
};
/// Kind of soil, number of nodes and of points.
using PackKey = std::tuple<std::string, std::size_t, std::size_t>;

/// The soil of the cells whose laws this process evaluates.
PointsOfCells own_points(const PointsOfCells& points, const SoilWork& work) {
  if (work.divided == nullptr) return points;
  return [&](unsigned cell, unsigned point) {
    return work.own_cells[cell] ? points(cell, point) : std::unique_ptr<SoilPoint>();
  };
}

int n_unknowns(const Unknowns& unknowns, const SoilWork& work) {
  return work.n_unknowns > 0 ? work.n_unknowns : unknowns.size();
}

class SoilOfCells : public YieldingSoil {
 public:
  SoilOfCells(const Space& space, const Unknowns& unknowns, const std::vector<Reading>& readings,
              const PointsOfCells& points, const SoilWork& work);

  const std::vector<int>& rows() const override { return nodes_.rows(); }
  void evaluate(const Vector& x, Vector& p) override;
  double commit(const Vector& x) override;
  const Vector& added_to_readings() const override { return added_; }
  double stored_beside_elastic() const override { return stored_sum_; }
  double exerted() const override { return exerted_; }
  const std::vector<double>& dissipated() const override { return lost_; }
  std::vector<std::vector<BorneStress>> borne() override;
  double share_skipped() const override {
    const double updates = layout_.sum(n_updates_), skipped = layout_.sum(n_skipped_);
    return updates > 0. ? skipped / updates : 0.;
  }
  std::vector<double> memory() const override;
  void recall(const std::vector<double>& memory) override;

 private:
  void make_packs(std::map<PackKey, Waiting>& waiting, bool by_points);
  /// Tells soil that asks elsewhere for its stress the strains of displacements u.
  void foresee(const Vector& u);
  /// Calls `work` for each pack, on several threads, with displacements u; then sums the packs' nodal forces.
  void sum_forces(const Vector& u, const std::function<void(std::size_t)>& work, Vector& F);
  void commit_pack(std::size_t pack);
  /// Values of the whole system; those that this process does not hold are zero.
  const Vector& whole(const Vector& x);
  void add_up(std::vector<std::vector<BorneStress>>& found) const;

  bool skips_;
  const System* divided_;
  Layout layout_;
  Vector whole_;
  SoilNodes nodes_;
  std::vector<CellPack> packs_;
  std::vector<double> lost_;                  ///< by active cell index (J/m)
  std::vector<PackNumber> lost_of_, stored_;  ///< by pack (J/m): dissipated in the last commit; stored, less that of D
  std::vector<char> rested_;                  ///< by pack, whether the last evaluation skipped it
  double n_updates_ = 0., n_skipped_ = 0.;    ///< of cells
  Crew crew_;
  std::vector<std::vector<dealii::Point<dim>>> at_;  ///< points of quadrature by active cell index
  FollowedStress followed_;
  Vector added_;  ///< contributions to readings
  double exerted_ = 0., stored_sum_ = 0.;
  Vector u_, committed_, F_, elastic_F_, total_;
};

SoilOfCells::SoilOfCells(const Space& space, const Unknowns& unknowns, const std::vector<Reading>& readings,
                         const PointsOfCells& points, const SoilWork& work)
    : skips_(work.skip),
      divided_(work.divided),
      layout_(divided_ != nullptr ? layout_of(*divided_) : Layout()),
      crew_(work.threads),
      followed_(space, unknowns, n_unknowns(unknowns, work), readings, own_points(points, work), work.followed),
      added_(Vector::Zero(static_cast<Eigen::Index>(readings.size()))) {
  std::map<PackKey, Waiting> waiting;
  for (const Cell& cell : space.dofs().active_cell_iterators()) {
    const unsigned index = cell->active_cell_index();
    std::unique_ptr<SoilPoint> soil = points(index, 0);
    lost_.push_back(soil ? 0. : -1.);
    at_.emplace_back();
    if (!soil) continue;
    CellShapes shapes = shapes_of(space, cell);
    for (auto& node : shapes.dofs)
      for (int& dof : node) dof = nodes_.number(dof);
    at_.back() = shapes.at;
    if (divided_ != nullptr && !work.own_cells[index]) continue;
    const SoilPoint& first = *soil;
    Waiting& others = waiting[{typeid(first).name(), shapes.dofs.size(), shapes.area.size()}];
    SoilPoints& of_cell = others.cells.emplace_back();
    for (std::size_t q = 0; q < shapes.area.size(); ++q)
      of_cell.push_back(soil ? std::move(soil) : points(index, static_cast<unsigned>(q)));
    others.shapes.push_back(std::move(shapes));
  }
  nodes_.connect(unknowns, n_unknowns(unknowns, work), readings, divided_);
  make_packs(waiting, work.by_points);
  nodes_.displace(Vector::Zero(n_unknowns(unknowns, work)), committed_);
}

void SoilOfCells::make_packs(std::map<PackKey, Waiting>& waiting, bool by_points) {
  for (auto& [key, all] : waiting)
    for (std::size_t begin = 0; begin < all.cells.size(); begin += detail::lanes) {
      const auto part = [&](auto& list) {
        const auto first = list.begin() + static_cast<std::ptrdiff_t>(begin);
        const auto n = std::min<std::ptrdiff_t>(detail::lanes, list.end() - first);
        return std::vector(std::make_move_iterator(first), std::make_move_iterator(first + n));
      };
      packs_.emplace_back(part(all.shapes), side_by_side(part(all.cells), by_points), nodes_.size());
    }
  lost_of_.resize(packs_.size());
  stored_.resize(packs_.size());
  rested_.resize(packs_.size());
}

void SoilOfCells::foresee(const Vector& u) {
  for (CellPack& pack : packs_) {
    if (!pack.soil(0).asks()) continue;
    pack.take(u);
    for (int q = 0; q < pack.n_points(); ++q) pack.soil(q).foresee(pack.strain(q));
  }
}

void SoilOfCells::sum_forces(const Vector& u, const std::function<void(std::size_t)>& work, Vector& F) {
  detail::fail_together(divided_ != nullptr ? divided_->sharing : Sharing(), [&] {
    crew_.share(static_cast<int>(packs_.size()), [&](int i) {
      const auto pack = static_cast<std::size_t>(i);
      packs_[pack].take(u);
      packs_[pack].clear_forces();
      work(pack);
    });
  });
  // one pack after another, so that the sum does not depend on the number of threads
  F.setZero(nodes_.size() + 1);
  for (const CellPack& pack : packs_) pack.give(F);
  layout_.add_up(F);
}

const Vector& SoilOfCells::whole(const Vector& x) {
  if (divided_ == nullptr) return x;
  whole_.setZero(divided_->part.n_whole);
  for (std::size_t i = 0; i < divided_->part.number.size(); ++i)
    whole_[divided_->part.number[i]] = x[static_cast<Eigen::Index>(i)];
  return whole_;
}

void SoilOfCells::evaluate(const Vector& x, Vector& p) {
  nodes_.displace(whole(x), u_);
  foresee(u_);
  const auto correct = [this](std::size_t i) {
    CellPack& pack = packs_[i];
    rested_[i] = skips_ && pack.rests();
    if (rested_[i]) return;
    PackStress correction;
    for (int q = 0; q < pack.n_points(); ++q) {
      pack.soil(q).correct(pack.strain(q), correction);
      pack.add_force(q, correction);
    }
  };
  sum_forces(u_, correct, F_);
  for (std::size_t i = 0; i < packs_.size(); ++i) {
    n_updates_ += packs_[i].n_cells();
    if (rested_[i]) n_skipped_ += packs_[i].n_cells();
  }
  nodes_.gather(F_, p);
}

void SoilOfCells::commit_pack(std::size_t i) {
  CellPack& pack = packs_[i];
  PackStress correction;
  Lanes &lost = lost_of_[i].value, &stored = stored_[i].value;
  lost = stored = Lanes{};
  PackNumber margin, least;
  least.value += infinity;
  for (int q = 0; q < pack.n_points(); ++q) {
    const PackTensor strain = pack.strain(q);
    pack.soil(q).correct(strain, correction);
    pack.add_force(q, correction);
    Lanes of_point{}, energy{};
    pack.soil(q).commit(strain, of_point);
    pack.soil(q).stored_beside_elastic(strain, energy);
    lost += pack.area(q) * of_point;
    stored += pack.area(q) * energy;
    pack.soil(q).margin(strain, margin.value);
    least.value = margin.value < least.value ? margin.value : least.value;
  }
  pack.settle(least);
}

/// The nodal force of the ground is K x - p, summed over its cells.
double SoilOfCells::commit(const Vector& x) {
  nodes_.displace(whole(x), committed_);
  foresee(committed_);
  const auto elastic = [this](std::size_t i) {
    CellPack& pack = packs_[i];
    for (int q = 0; q < pack.n_points(); ++q) pack.add_force(q, pack.elastic_stress(pack.strain(q)));
  };
  sum_forces(committed_, elastic, elastic_F_);
  sum_forces(
      committed_, [this](std::size_t i) { commit_pack(i); }, F_);
  nodes_.gather(elastic_F_ - F_, total_);
  exerted_ = total_.norm();
  added_.setZero();
  if (divided_ == nullptr || counts_for_prescribed(*divided_)) nodes_.subtract_from_readings(F_, added_);
  followed_.commit(whole(x), added_);
  double dissipated = 0.;
  stored_sum_ = 0.;
  Vector lost = Vector::Zero(static_cast<Eigen::Index>(lost_.size()));
  for (std::size_t i = 0; i < packs_.size(); ++i)
    for (int lane = 0; lane < packs_[i].n_cells(); ++lane) {
      lost[packs_[i].cell(lane)] = lost_of_[i].value[lane];
      dissipated += lost_of_[i].value[lane];
      stored_sum_ += stored_[i].value[lane];
    }
  layout_.add_up(lost);
  for (std::size_t i = 0; i < lost_.size(); ++i)  // below zero stands for no soil, and round-off may not come there
    if (lost_[i] >= 0.) lost_[i] = std::max(lost_[i] + lost[static_cast<Eigen::Index>(i)], 0.);
  return dissipated;
}

void SoilOfCells::add_up(std::vector<std::vector<BorneStress>>& found) const {
  const auto each = [&](const auto& see) {
    Eigen::Index i = 0;
    for (std::vector<BorneStress>& cell : found)
      for (BorneStress& point : cell)
        for (double* number :
             {&point.change.xx, &point.change.yy, &point.change.xy, &point.change.zz, &point.mobilised})
          see(*number, i++);
    return i;
  };
  Vector all(each([](double, Eigen::Index) {}));
  each([&](double number, Eigen::Index i) { all[i] = number; });
  layout_.add_up(all);
  each([&](double& number, Eigen::Index i) { number = all[i]; });
}

/// By packs: the stress of one cell costs as much as those of eight.
std::vector<std::vector<BorneStress>> SoilOfCells::borne() {
  std::vector<std::vector<BorneStress>> found(at_.size());
  PackStress c;
  for (CellPack& pack : packs_) {
    pack.take(committed_);
    for (int q = 0; q < pack.n_points(); ++q) {
      const PackTensor strain = pack.strain(q);
      const PackStress s = pack.elastic_stress(strain);
      pack.soil(q).correct(strain, c);
      for (int lane = 0; lane < pack.n_cells(); ++lane) {
        const auto cell = static_cast<std::size_t>(pack.cell(lane));
        const PlaneStress change{s.xx[lane] - c.xx[lane], s.yy[lane] - c.yy[lane], s.xy[lane] - c.xy[lane],
                                 s.zz[lane] - c.zz[lane]};
        found[cell].push_back({at_[cell][static_cast<std::size_t>(q)], change, pack.soil(q).mobilised(lane, change)});
      }
    }
  }
  if (divided_ == nullptr) return found;
  for (std::size_t cell = 0; cell < found.size(); ++cell)
    for (std::size_t q = found[cell].size(); q < at_[cell].size(); ++q) found[cell].push_back({at_[cell][q], {}, 0.});
  add_up(found);
  return found;
}

std::vector<double> SoilOfCells::memory() const {
  std::vector<double> memory{exerted_, stored_sum_, n_updates_, n_skipped_};
  memory.insert(memory.end(), committed_.begin(), committed_.end());
  memory.insert(memory.end(), lost_.begin(), lost_.end());
  for (const CellPack& pack : packs_) pack.remember(memory);
  followed_.remember(memory);
  return memory;
}

void SoilOfCells::recall(const std::vector<double>& memory) {
  if (memory.size() != this->memory().size()) throw NumericsError("the checkpoint does not belong to this soil");
  const double* from = memory.data();
  for (double* number : {&exerted_, &stored_sum_, &n_updates_, &n_skipped_}) *number = *from++;
  for (double& number : committed_) number = *from++;
  for (double& number : lost_) number = *from++;
  for (CellPack& pack : packs_) from = pack.recall(from);
  followed_.recall(from);
}

}  // namespace

std::unique_ptr<YieldingSoil> yielding_soil(const Space& space, const Unknowns& unknowns,
                                            const std::vector<Reading>& readings, const PointsOfCells& points,
                                            const SoilWork& work) {
  return std::make_unique<SoilOfCells>(space, unknowns, readings, points, work);
}

}  // namespace upbead
