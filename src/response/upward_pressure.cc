#include "response/upward_pressure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "algebra/dense.h"
#include "fem/faces.h"
#include "fem/probes.h"
#include "response/rows_of_basis.h"
#include "upbead/dynamics/modal_response.h"

namespace upbead {

namespace {

constexpr int points_of_vertical = 48;

/// A cell of pores on a vertical.
struct Crossed {
  Cell cell;
  double low, high;  ///< y (m)
};

std::optional<std::array<double, 2>> crossing(const Cell& cell, double x) {
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const unsigned f : cell->face_indices()) {
    const auto &a = cell->face(f)->vertex(0), &b = cell->face(f)->vertex(1);
    if ((a[0] - x) * (b[0] - x) >= 0.) continue;  // verticals run beside the corners
    const double y = a[1] + (x - a[0]) / (b[0] - a[0]) * (b[1] - a[1]);
    low = std::min(low, y);
    high = std::max(high, y);
  }
  return high > low ? std::optional(std::array{low, high}) : std::nullopt;
}

bool is_surface(const Space& space, const Cell& cell, unsigned f) {
  if (outward_normal(cell, f)[1] < 1e-3) return false;  // a wall, or the bottom
  return cell->at_boundary(f) || space.region(cell->neighbor(f)).kind == RegionKind::water;
}

/// Two verticals through every face of the surface.
std::vector<UpwardPressure::Vertical> verticals_of(const Space& space) {
  std::vector<UpwardPressure::Vertical> list;
  for (const Cell& cell : space.dofs().active_cell_iterators()) {
    if (!space.has_pores(cell)) continue;
    for (const unsigned f : cell->face_indices())
      if (is_surface(space, cell, f))
        for (const double part : {0.25, 0.75}) {
          const auto at = cell->face(f)->vertex(0) + part * (cell->face(f)->vertex(1) - cell->face(f)->vertex(0));
          list.push_back({at[0], at[1], 0., {}});
        }
  }
  std::sort(list.begin(), list.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
  return list;
}

/// For each vertical its cells, from the surface down as far as one follows the other.
std::vector<std::vector<Crossed>> crossed_cells(const Space& space, const std::vector<UpwardPressure::Vertical>& list) {
  std::vector<std::vector<Crossed>> crossed(list.size());
  for (const Cell& cell : space.dofs().active_cell_iterators()) {
    if (!space.has_pores(cell)) continue;
    const auto box = cell->bounding_box();
    auto v =
        std::lower_bound(list.begin(), list.end(), box.lower_bound(0), [](const auto& a, double x) { return a.x < x; });
    for (; v != list.end() && v->x <= box.upper_bound(0); ++v)
      if (const auto part = crossing(cell, v->x))
        crossed[static_cast<std::size_t>(v - list.begin())].push_back({cell, (*part)[0], (*part)[1]});
  }
  for (std::size_t i = 0; i < list.size(); ++i) {
    auto& cells = crossed[i];
    std::sort(cells.begin(), cells.end(), [](const Crossed& a, const Crossed& b) { return a.high > b.high; });
    double next = list[i].top;
    std::size_t n = 0;
    while (n < cells.size() && std::abs(cells[n].high - next) < 1e-6 * (1. + std::abs(next))) next = cells[n++].low;
    cells.erase(cells.begin() + static_cast<std::ptrdiff_t>(n), cells.end());
  }
  return crossed;
}

}  // namespace

UpwardPressure::UpwardPressure(const Space& space, const Unknowns& unknowns) : verticals_(verticals_of(space)) {
  const auto crossed = crossed_cells(space, verticals_);
  std::vector<Eigen::Triplet<double>> entries;
  int n = 0;
  for (std::size_t i = 0; i < verticals_.size(); ++i) {
    Vertical& v = verticals_[i];
    if (crossed[i].empty()) continue;
    v.cell = crossed[i].front().high - crossed[i].front().low;
    const auto row_at = [&](const Cell& cell, double y) {
      return pressure_row(unknowns, cell, space.mapping().transform_real_to_unit_cell(cell, {v.x, y}));
    };
    const std::map<int, double> top = row_at(crossed[i].front().cell, v.top);
    auto in = crossed[i].begin();
    for (int k = 1; k <= points_of_vertical; ++k) {
      const double share = static_cast<double>(k) / points_of_vertical;
      const double y = v.top - share * share * (v.top - crossed[i].back().low);
      while (y < in->low && in + 1 != crossed[i].end()) ++in;
      for (const auto& [unknown, weight] : row_at(in->cell, y)) entries.emplace_back(n, unknown, weight);
      for (const auto& [unknown, weight] : top) entries.emplace_back(n, unknown, -weight);
      v.points.push_back({v.top - y, y, in->cell->material_id(), 0., 0.});
      ++n;
    }
  }
  rows_.resize(n, unknowns.size());
  rows_.setFromTriplets(entries.begin(), entries.end());
}

void UpwardPressure::see(const State& state, int step, int) {
  if (step == 0)
    for (Vertical& v : verticals_)
      for (Point& p : v.points) p.largest = p.time = 0.;
  take(rows_ * state.v, state.time);
}

void UpwardPressure::see(const PressureModel& model, const SampledLoads& loads) {
  const Series series = respond(model.model, loads);
  const Eigen::MatrixXd rows = rows_of_basis(rows_, model.basis);
  constexpr Eigen::Index at_once = 64;
  for (Eigen::Index first = 0; first < series.reading.cols(); first += at_once) {
    const Eigen::Index count = std::min(at_once, series.reading.cols() - first);
    const Eigen::MatrixXd excess = product(rows, series.reading.middleCols(first, count));
    for (Eigen::Index i = 0; i < count; ++i) take(excess.col(i), series.time[static_cast<std::size_t>(first + i)]);
  }
}

std::vector<double> UpwardPressure::memory() const {
  std::vector<double> list{has_seen_ ? 1. : 0.};
  for (const Vertical& v : verticals_)
    for (const Point& p : v.points) list.insert(list.end(), {p.largest, p.time});
  return list;
}

void UpwardPressure::recall(const std::vector<double>& memory) {
  auto next = memory.begin();
  has_seen_ = *next++ != 0.;
  for (Vertical& v : verticals_)
    for (Point& p : v.points) {
      p.largest = *next++;
      p.time = *next++;
    }
}

void UpwardPressure::take(const Eigen::Ref<const Vector>& excess, double time) {
  has_seen_ = true;
  Eigen::Index i = 0;
  for (Vertical& v : verticals_)
    for (Point& p : v.points) {
      const double now = excess[i++];
      if (now <= p.largest) continue;
      p.largest = now;
      p.time = time;
    }
}

}  // namespace upbead
