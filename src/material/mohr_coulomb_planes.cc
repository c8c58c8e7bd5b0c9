#include "material/mohr_coulomb_planes.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "upbead/base/error.h"

namespace upbead {

namespace {

double dot(const Principals& a, const Principals& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Principals times_D(double lambda, double G, const Principals& b) {
  const double mean = lambda * (b[0] + b[1] + b[2]);
  return {mean + 2. * G * b[0], mean + 2. * G * b[1], mean + 2. * G * b[2]};
}

struct PlaneSet {
  std::array<int, 3> planes{};
  int n = 0;
};

/// All sets of up to three of the six planes, smaller sets first.
const std::vector<PlaneSet>& sets_of_planes() {
  static const std::vector<PlaneSet> sets = [] {
    std::vector<PlaneSet> found;
    for (unsigned bits = 1; bits < 64; ++bits) {
      PlaneSet set;
      for (int i = 0; i < 6; ++i)
        if (bits & (1u << i) && ++set.n <= 3) set.planes[static_cast<std::size_t>(set.n - 1)] = i;
      if (set.n <= 3) found.push_back(set);
    }
    std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.n < b.n; });
    return found;
  }();
  return sets;
}

}  // namespace

MohrCoulombPlanes::MohrCoulombPlanes(const ElasticLaw& elastic, double k_, double m_, double strength_, double tension_)
    : k(k_),
      m(m_),
      strength(strength_),
      tension(tension_),
      constrained_(elastic.constrained_modulus()),
      lambda_(elastic.lambda),
      G_(elastic.G) {
  // the plane of shear; two planes that form an edge with it; the three planes of tension
  a_ = {{{k, 0., -1.}, {0., k, -1.}, {k, -1., 0.}, {1., 0., 0.}, {0., 1., 0.}, {0., 0., 1.}}};
  const std::array<Principals, n_planes> b{
      {{m, 0., -1.}, {0., m, -1.}, {m, -1., 0.}, {1., 0., 0.}, {0., 1., 0.}, {0., 0., 1.}}};
  limit_ = {strength, strength, strength, tension, tension, tension};
  for (int i = 0; i < n_planes; ++i) {
    Db_[i] = times_D(elastic.lambda, elastic.G, b[i]);
    aD_[i] = times_D(elastic.lambda, elastic.G, a_[i]);
  }
  for (int i = 0; i < n_planes; ++i)
    for (int j = 0; j < n_planes; ++j) aDb_[i][j] = dot(a_[i], Db_[j]);
}

/// Gaussian elimination with pivoting; false where the planes are linearly dependent.
bool MohrCoulombPlanes::solve(const std::array<int, 3>& set, int n, const Principals& rhs, Principals& l) const {
  std::array<std::array<double, 4>, 3> A{};
  double largest = 0.;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      A[i][j] = aDb_[set[i]][set[j]];
      largest = std::max(largest, std::abs(A[i][j]));
    }
    A[i][3] = rhs[i];
  }
  for (int c = 0; c < n; ++c) {
    int pivot = c;
    for (int i = c + 1; i < n; ++i)
      if (std::abs(A[i][c]) > std::abs(A[pivot][c])) pivot = i;
    if (!(std::abs(A[pivot][c]) > 1e-14 * largest)) return false;
    std::swap(A[c], A[pivot]);
    for (int i = c + 1; i < n; ++i) {
      const double factor = A[i][c] / A[c][c];
      for (int j = c; j < 4; ++j) A[i][j] -= factor * A[c][j];
    }
  }
  for (int i = n - 1; i >= 0; --i) {
    double sum = A[i][3];
    for (int j = i + 1; j < n; ++j) sum -= A[i][j] * l[j];
    l[i] = sum / A[i][i];
  }
  return true;
}

bool MohrCoulombPlanes::try_set(const Principals& trial, double small, Return& on) const {
  Principals over{}, l{};
  for (int i = 0; i < on.n; ++i) over[i] = dot(a_[on.planes[i]], trial) - limit_[on.planes[i]];
  if (!solve(on.planes, on.n, over, l)) return false;
  on.stress = trial;
  for (int i = 0; i < on.n; ++i) {
    if (-constrained_ * l[i] > small) return false;
    for (int c = 0; c < 3; ++c) on.stress[c] -= l[i] * Db_[on.planes[i]][c];
  }
  for (int i = 0; i < n_planes; ++i)
    if (!(dot(a_[i], on.stress) - limit_[i] <= small)) return false;
  return true;
}

MohrCoulombPlanes::Return MohrCoulombPlanes::from(const Principals& trial) const {
  const double small =
      1e-10 * (std::max({std::abs(trial[0]), std::abs(trial[1]), std::abs(trial[2])}) + std::abs(strength));
  Return on;
  for (const PlaneSet& set : sets_of_planes()) {
    on.planes = set.planes;
    on.n = set.n;
    if (try_set(trial, small, on)) return on;
  }
  throw NumericsError("no stress within the Mohr-Coulomb planes was found for a strain");
}

std::array<Principals, 3> MohrCoulombPlanes::tangent(const Return& on) const {
  std::array<Principals, 3> T{};
  for (int c = 0; c < 3; ++c) {
    Principals rhs{}, l{};
    for (int i = 0; i < on.n; ++i) rhs[i] = aD_[on.planes[i]][c];
    solve(on.planes, on.n, rhs, l);
    for (int r = 0; r < 3; ++r) {
      T[r][c] = lambda_ + (r == c ? 2. * G_ : 0.);
      for (int i = 0; i < on.n; ++i) T[r][c] -= Db_[on.planes[i]][r] * l[i];
    }
  }
  return T;
}

}  // namespace upbead
