#include "reliability/union_form.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <numeric>
#include <openturns/OT.hxx>

namespace upbead {

namespace {

using Coordinates = std::vector<double>;

double product_of(const Coordinates& a, const Coordinates& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.);
}

double beyond(double z) {
  return 0.5 * std::erfc(z * std::sqrt(0.5));
}

/// Half-space x . normal >= distance, in coordinates of the span of all normals.
struct HalfSpace {
  Coordinates normal;
  double distance = 0.;
};

/// Directions closer to the span of the others than this are in it.
constexpr double in_span = 1e-7;

/// By Gram and Schmidt.
std::vector<HalfSpace> in_their_span(const std::vector<DesignPoint>& points) {
  std::vector<Coordinates> basis;
  for (const DesignPoint& point : points) {
    Coordinates rest = point.alpha;
    for (int twice = 0; twice < 2; ++twice)
      for (const Coordinates& e : basis) {
        const double along = product_of(rest, e);
        for (std::size_t k = 0; k < rest.size(); ++k) rest[k] -= along * e[k];
      }
    const double length = std::sqrt(product_of(rest, rest));
    if (length < in_span) continue;
    for (double& x : rest) x /= length;
    basis.push_back(rest);
  }
  std::vector<HalfSpace> list;
  for (const DesignPoint& point : points) {
    HalfSpace half{{}, point.index};
    for (const Coordinates& e : basis) half.normal.push_back(product_of(point.alpha, e));
    list.push_back(half);
  }
  return list;
}

/// Where a line crosses a plane, and how many half-spaces it then is in more.
struct Crossing {
  double z = 0.;
  int more = 0;
};

/// Integral of phi(z)/S over z from the plane of half-space i on, along its normal through w; w is normal to it.
double along_normal(const std::vector<HalfSpace>& halves, std::size_t i, const Coordinates& w,
                    std::vector<Crossing>& crossings) {
  const HalfSpace& one = halves[i];
  int inside = 0;
  crossings.clear();
  for (std::size_t k = 0; k < halves.size(); ++k) {
    if (k == i) {
      ++inside;
      continue;
    }
    const double rate = product_of(halves[k].normal, one.normal);
    const double rest = halves[k].distance - product_of(halves[k].normal, w);
    if (rate * one.distance >= rest) ++inside;
    if (rate == 0.) continue;
    const double z = rest / rate;
    if (z > one.distance) crossings.push_back({z, rate > 0. ? 1 : -1});
  }
  std::sort(crossings.begin(), crossings.end(), [](const Crossing& a, const Crossing& b) { return a.z < b.z; });
  double sum = 0., before = beyond(one.distance);
  for (const Crossing& crossing : crossings) {
    const double now = beyond(crossing.z);
    sum += (before - now) / inside;
    before = now;
    inside = std::max(inside + crossing.more, 1);  // it is in its own, whatever round-off says of a plane that it meets
  }
  return sum + before / inside;
}

/// A sum of 2^14 - 1 terms: 2e-4 of a probability, in the tests.
constexpr std::size_t n_lines = 16383;

}  // namespace

double probability_of_any(const std::vector<DesignPoint>& points) {
  const std::vector<HalfSpace> halves = in_their_span(points);
  const std::size_t size = halves.front().normal.size();
  const boost::math::normal normal;
  double largest = 0., all = 0., sum = 0.;
  for (const HalfSpace& half : halves) {
    largest = std::max(largest, beyond(half.distance));
    all += beyond(half.distance);
  }
  if (halves.size() == 1) return largest;
  const OT::Sample sobol = OT::SobolSequence(size).generate(n_lines);
  Coordinates v(size), w(size);
  std::vector<Crossing> crossings;
  for (std::size_t line = 0; line < n_lines; ++line) {
    for (std::size_t k = 0; k < size; ++k) v[k] = boost::math::quantile(normal, sobol(line, k));
    for (std::size_t i = 0; i < halves.size(); ++i) {
      const Coordinates& a = halves[i].normal;
      const double along = product_of(v, a);
      for (std::size_t k = 0; k < size; ++k) w[k] = v[k] - along * a[k];
      sum += along_normal(halves, i, w, crossings);
    }
  }
  return std::clamp(sum / n_lines, largest, std::min(all, 1.));
}

}  // namespace upbead
