#include <algorithm>
#include <cmath>
#include <limits>

#include "upbead/model/scene.h"

namespace upbead {

namespace {

/// Integral of |f| and total variation of f' over [0, end], f taken as linear between many points of each smooth piece.
struct Shape {
  double integral = 0., variation = 0.;
};

std::vector<double> points_of(const TimeFunction& f, double end) {
  std::vector<double> corners{0., end}, points;
  for (const double kink : f.kinks())
    if (kink > 0. && kink < end) corners.push_back(kink);
  std::sort(corners.begin(), corners.end());
  constexpr int parts = 64;
  for (std::size_t i = 0; i + 1 < corners.size(); ++i)
    for (int j = 0; j < parts; ++j) points.push_back(corners[i] + (corners[i + 1] - corners[i]) * j / parts);
  for (const double sample : f.samples())
    if (sample > 0. && sample < end) points.push_back(sample);
  points.push_back(end);
  std::sort(points.begin(), points.end());
  return points;
}

Shape shape_of(const TimeFunction& f, double end) {
  const std::vector<double> t = points_of(f, end);
  Shape shape;
  double slope = 0.;
  for (std::size_t i = 0; i + 1 < t.size(); ++i) {
    const double step = t[i + 1] - t[i], inside = t[i] + 0.5 * step;
    if (step <= 1e-12 * end) continue;
    const double a = f(t[i], inside), b = f(t[i + 1], inside);
    shape.integral += 0.5 * (std::abs(a) + std::abs(b)) * step;
    shape.variation += std::abs((b - a) / step - slope);
    slope = (b - a) / step;
  }
  return shape;
}

}  // namespace

double bandwidth(const Scene& scene) {
  if (shortest_duration(scene) == 0.) return std::numeric_limits<double>::infinity();
  constexpr double least_share = 0.01;
  double largest = 0.;
  for (const auto& [name, load] : scene.loads) {
    const Shape shape = shape_of(load.history, scene.time.end);
    if (shape.integral > 0.) largest = std::max(largest, std::sqrt(shape.variation / (least_share * shape.integral)));
  }
  return largest;
}

}  // namespace upbead
