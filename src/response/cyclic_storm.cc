#include "response/cyclic_storm.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "upbead/base/error.h"

namespace upbead {

namespace {

const double gamma_of_scheme = 1. - std::sqrt(0.5);  ///< Alexander, SIAM J. Numer. Anal. 14 (1977) 1006
constexpr int most_active_sets = 100;
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

}  // namespace

CappedFlow::CappedFlow(const PoreFlow& flow, const Vector& cap)
    : flow_(flow),
      cap_(cap.cwiseMax(0.)),
      p_(Vector::Zero(cap.size())),
      shed_(Vector::Zero(cap.size())),
      at_cap_(static_cast<std::size_t>(cap.size()), false) {
  for (const double pressure : cap_)
    if (std::isfinite(pressure)) rounding_ = std::max(rounding_, 1e-10 * pressure);
}

double CappedFlow::stored() const {
  return flow_.storage.dot(p_);
}

/// S + implicit K, with rows and columns of 1 at nodes whose pressure is given.
SparseMatrix CappedFlow::matrix(const std::vector<bool>& held, double implicit) const {
  std::vector<Eigen::Triplet<double>> entries;
  const SparseMatrix& K = flow_.conductance;
  for (Eigen::Index i = 0; i < K.rows(); ++i) {
    const bool given = held[static_cast<std::size_t>(i)];
    entries.emplace_back(i, i, flow_.storage[i]);
    for (SparseMatrix::InnerIterator it(K, i); it && !given; ++it)
      if (!held[static_cast<std::size_t>(it.col())]) entries.emplace_back(i, it.col(), implicit * it.value());
  }
  SparseMatrix sum(K.rows(), K.cols());
  sum.setFromTriplets(entries.begin(), entries.end());
  return sum;
}

/// Pressures, with p = cap where it is held and 0 where it is drained.
Vector CappedFlow::solve_with(const std::vector<bool>& held, const Vector& right, double implicit) {
  std::vector<bool> given = held;
  for (std::size_t i = 0; i < given.size(); ++i) given[i] = given[i] || flow_.drained[i];
  if (!factors_ || factored_for_ != implicit || factored_held_ != given) {
    factors_ = std::make_shared<const Factorisation>(matrix(given, implicit));
    factored_for_ = implicit;
    factored_held_ = given;
  }
  Vector at = Vector::Zero(right.size());
  for (std::size_t i = 0; i < held.size(); ++i)
    if (held[i] && !flow_.drained[i]) at[static_cast<Eigen::Index>(i)] = cap_[static_cast<Eigen::Index>(i)];
  Vector b = right - implicit * (flow_.conductance * at);
  for (std::size_t i = 0; i < given.size(); ++i)
    if (const auto n = static_cast<Eigen::Index>(i); given[i]) b[n] = flow_.storage[n] * at[n];
  return factors_->solve(b);
}

/// (S + implicit K) p = known + implicit (source - r).
CappedFlow::Stage CappedFlow::solve(const Vector& known, const Vector& source, double implicit) {
  const Vector right = known + implicit * source;
  Stage stage;
  for (int i = 0; i < most_active_sets; ++i) {
    stage.p = solve_with(at_cap_, right, implicit);
    const Vector left_over = (right - flow_.storage.cwiseProduct(stage.p)) / implicit - flow_.conductance * stage.p;
    stage.r = Vector::Zero(right.size());
    stage.outflow = 0.;
    bool same = true;
    for (std::size_t k = 0; k < at_cap_.size(); ++k) {
      const auto n = static_cast<Eigen::Index>(k);
      if (flow_.drained[k]) {
        stage.outflow += left_over[n];
        continue;
      }
      if (at_cap_[k]) stage.r[n] = left_over[n];
      const bool next = at_cap_[k] ? left_over[n] > 0. : stage.p[n] > cap_[n] + rounding_;
      same = same && next == at_cap_[k];
      at_cap_[k] = next;
    }
    if (same) return stage;
  }
  throw NumericsError("the soil that liquefies in a step of the storm was not found");
}

void CappedFlow::step(const Vector& source, double dt) {
  const double g = gamma_of_scheme;
  const Stage first = solve(flow_.storage.cwiseProduct(p_), source, g * dt);
  const Vector known = flow_.storage.cwiseProduct(p_ + (1. - g) / g * (first.p - p_));
  const Stage second = solve(known, source, g * dt);
  p_ = second.p;
  shed_ += dt * ((1. - g) * first.r + g * second.r);
  outflow_ += dt * ((1. - g) * first.outflow + g * second.outflow);
}

namespace {

constexpr int levels = 5;  ///< lengths of the steps that begin a part, each twice the one before
constexpr double left_in_calm = 0.01, longest_calm = 1000.;  ///< as declared for [cycles] calm

/// The course of a storm; calls for each step.
class Storm {
 public:
  Storm(const PoreFlow& flow, const Cycles& cycles, const std::vector<StormCell>& cells, int steps)
      : flow_(flow), cycles_(cycles), cells_(cells), steps_(steps), water_(flow, cap()), source_at_nodes_(nodes()) {
    source_at_nodes_.setZero();
    for (std::vector<double>* list : {&found_.pressure, &found_.largest_ratio, &found_.ratio_time, &found_.liquefied_at,
                                      &found_.compaction, &found_.drained})
      list->assign(cells.size(), nothing);
    for (const unsigned cell : flow.cells)
      if (cells[cell].counts) found_.largest_ratio[cell] = found_.ratio_time[cell] = 0.;
    pressed_.resize(nodes(), static_cast<Eigen::Index>(flow.cells.size()));
    found_.time = found_.ratio = {0.};
  }

  StormFound run() {
    for (std::size_t part = 0; part < cycles_.number.size(); ++part) run_part(part);
    found_.duration = time_;
    const Vector p = flow_.at_middle * water_.pressure();
    for (std::size_t c = 0; c < flow_.cells.size(); ++c)
      found_.pressure[flow_.cells[c]] = p[static_cast<Eigen::Index>(c)];
    run_calm();
    found_.calm = time_ - found_.duration;
    tell_volumes();
    return std::move(found_);
  }

 private:
  int steps_of_level() const { return std::max(steps_ / 4, 1); }
  Eigen::Index nodes() const { return static_cast<Eigen::Index>(flow_.node.size()); }

  Vector cap() const {
    std::vector<double> stress;
    std::vector<bool> counts;
    for (const unsigned cell : flow_.cells) {
      stress.push_back(cells_[cell].effective_stress);
      counts.push_back(cells_[cell].counts);
    }
    return at_nodes(flow_, stress, counts);
  }

  /// Water that each cell presses out to its nodes, S f (m2/s): nodes x cells.
  SparseMatrix source(std::size_t part) const {
    std::vector<double> rate(flow_.cells.size(), 0.);
    std::vector<bool> builds(rate.size(), false);
    for (std::size_t c = 0; c < rate.size(); ++c) {
      const StormCell& cell = cells_[flow_.cells[c]];
      builds[c] = cell.strength && cell.counts;
      if (builds[c])
        rate[c] = flow_.cell_storage[c] *
                  pressure_of_cycle(*cell.strength, cycles_.share(part) * cell.shear, cell.effective_stress) /
                  cycles_.period[part];
    }
    return spread_to_nodes(flow_, rate, builds);
  }

  void run_part(std::size_t part) {
    const double duration = cycles_.number[part] * cycles_.period[part], end = time_ + duration;
    const SparseMatrix spread = source(part);
    const Vector at_nodes = spread * Vector::Ones(spread.cols()), of_cells = spread.transpose() * Vector::Ones(nodes());
    double dt = duration / steps_ / (1 << levels);
    for (int n = 1; time_ < end * (1. - 1e-12); ++n) {
      take(at_nodes, std::min(dt, end - time_));
      if (n % steps_of_level() == 0 && n <= levels * steps_of_level()) dt *= 2.;
    }
    time_ = end;
    pressed_ += duration * spread;
    found_.source += duration * of_cells.sum();
    source_at_nodes_ += duration * at_nodes;
    compact(part);
  }

  void compact(std::size_t part) {
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      const StormCell& cell = cells_[i];
      if (!cell.compaction) continue;
      double& strain = found_.compaction[i];
      if (std::isnan(strain)) strain = 0.;
      strain = compaction_after(*cell.compaction, cycles_.share(part) * cell.shear / cell.modulus, cycles_.number[part],
                                strain);
    }
  }

  void run_calm() {
    const double begin = time_, end = begin + cycles_.calm.value_or(longest_calm * begin);
    const Vector none = Vector::Zero(nodes());
    const double enough = left_in_calm * *std::max_element(found_.ratio.begin(), found_.ratio.end());
    double dt = begin / steps_ / (1 << levels);
    for (int n = 1; time_ < end * (1. - 1e-12) && (cycles_.calm || found_.ratio.back() > enough); ++n) {
      take(none, std::min(dt, end - time_));
      if (n % steps_of_level() == 0) dt *= 2.;
    }
  }

  void take(const Vector& source, double dt) {
    water_.step(source, dt);
    time_ += dt;
    const Vector p = flow_.at_middle * water_.pressure();
    double largest = 0.;
    for (std::size_t c = 0; c < flow_.cells.size(); ++c) {
      const unsigned i = flow_.cells[c];
      if (!cells_[i].counts) continue;
      // the cap is met at nodes; what the middle of a cell has beyond it is of the cells' size
      const double ratio = std::min(p[static_cast<Eigen::Index>(c)] / cells_[i].effective_stress, 1.);
      largest = std::max(largest, ratio);
      if (ratio >= liquefied_ratio && std::isnan(found_.liquefied_at[i])) found_.liquefied_at[i] = time_;
      if (ratio <= found_.largest_ratio[i]) continue;
      found_.largest_ratio[i] = ratio;
      found_.ratio_time[i] = time_;
    }
    found_.time.push_back(time_);
    found_.ratio.push_back(largest);
  }

  /// The water that nodes shed comes off the cells there, in proportion to what they press out.
  void tell_volumes() {
    Vector kept = Vector::Ones(nodes());
    for (Eigen::Index n = 0; n < nodes(); ++n)
      if (water_.shed()[n] > 0.)
        kept[n] = source_at_nodes_[n] > 0. ? std::max(1. - water_.shed()[n] / source_at_nodes_[n], 0.) : 0.;
    const Vector pressed = pressed_.transpose() * kept;
    for (std::size_t c = 0; c < flow_.cells.size(); ++c)
      found_.drained[flow_.cells[c]] = pressed[static_cast<Eigen::Index>(c)] / flow_.area[c];
    found_.stored = water_.stored();
    found_.outflow = water_.outflow();
    found_.shed = water_.shed().sum();
  }

  const PoreFlow& flow_;
  const Cycles& cycles_;
  const std::vector<StormCell>& cells_;
  int steps_;
  CappedFlow water_;
  Vector source_at_nodes_;  ///< since the beginning (m2)
  SparseMatrix pressed_;    ///< water pressed out so far, with what is shed: nodes x cells (m2)
  StormFound found_;
  double time_ = 0.;
};

}  // namespace

StormFound run_storm(const PoreFlow& flow, const Cycles& cycles, const std::vector<StormCell>& cells, int steps) {
  return Storm(flow, cycles, cells, steps).run();
}

}  // namespace upbead
