// An element that slides at the strain g takes 4 y (x - g) in a cycle of amplitude x > g (Masing 1926), so an overlay
// takes 4 F(x), F = sum y_i (x - g_i)+: convex, straight between knees. Fewer elements are a polygon P with fewer
// corners: the fewest within a tunnel about F, found by drawing each line as far as it goes (Imai and Iri, Comput.
// Vision Graph. 36 (1986) 31). The corners are the knees, the bends the y_i. The sum of h_i = y_i/g_i is G, which
// decides where the tunnel's middle lies.
#include "material/few_elements.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"

namespace upbead {
namespace {

constexpr double tolerance = 0.02, between_knees = 0.001;  ///< the latter is kept for amplitudes between knees
constexpr double least_damping = 0.004;
constexpr double widest = 0.0165;  ///< of tunnels that are tried: stress and energy err together

/// Stress, and a quarter of the energy per cycle, of a law at the strains of its knees.
struct Curve {
  explicit Curve(const HystereticLaw& law) {
    double slope = law.elastic().G, last = 0., stress = 0., energy = 0.;
    for (const auto& [h, y] : law.elements()) {
      const double gamma = y / h;
      stress += slope * (gamma - last);
      energy += strength * (gamma - last);
      x.push_back(gamma);
      tau.push_back(stress);
      F.push_back(energy);
      last = gamma;
      slope -= h;
      strength += y;
    }
  }

  /// Number of the first knee from which all is to be within the tolerance.
  std::size_t first() const {
    std::size_t i = 0;
    while (i + 1 < x.size() && 2. * F[i] < pi * least_damping * tau[i] * x[i] && 4. * x[i] < x.back()) ++i;
    return i;
  }

  std::vector<double> x, tau, F;
  double strength = 0.;
};

/// Elements as knees and yield stresses, from the largest knee down.
struct Polygon {
  std::vector<double> knee, y;

  bool is_convex() const {
    for (std::size_t i = 0; i < knee.size(); ++i)
      if (!(y[i] > 0.) || !(knee[i] > 0.) || (i > 0 && !(knee[i] < knee[i - 1]))) return false;
    return !knee.empty();
  }
  double stiffness() const {
    double sum = 0.;
    for (std::size_t i = 0; i < knee.size(); ++i) sum += y[i] / knee[i];
    return sum;
  }
};

class Tunnel {
 public:
  /// `deeper`: how far below the first strain it reaches, over that; with elements there c is almost 1. `width`: half
  /// of it, over F; narrower where the soil is soft, as few and wide pieces bend the stress, too; wide at strains below
  /// the first. Its middle lies at 1 + (c - 1) tau/(G gamma).
  Tunnel(const Curve& curve, double G, double width, double deeper)
      : curve_(curve), first_(curve.x[curve.first()]), lowest_(deeper * first_) {
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
      const double below = first_ / curve.x[i];
      share_.push_back(curve.tau[i] / (G * curve.x[i]));
      width_.push_back(std::min(0.5, width * std::pow(share_[i], 0.3) * std::max(1., below * below)));
    }
  }

  /// From the last knee down; empty where the tunnel is closed.
  Polygon polygon(double c) const {
    Polygon found;
    const auto n = curve_.x.size();
    std::size_t j = n - 1;
    double slope = curve_.strength, a = curve_.x[j], at_a = middle(j, c) * curve_.F[j];
    while (true) {
      const auto line = [&](std::size_t i) { return at_a + slope * (curve_.x[i] - a); };
      std::size_t i = j + 1;
      while (i > 0 && curve_.x[i - 1] >= lowest_ && line(i - 1) >= lower(i - 1, c)) --i;
      if (i == 0 || curve_.x[i - 1] < lowest_) break;
      if (i == n) return {};
      const double above = line(i) - lower(i, c), under = lower(i - 1, c) - line(i - 1);
      const double knee = curve_.x[i - 1] + (curve_.x[i] - curve_.x[i - 1]) * under / (under + above);
      at_a += slope * (knee - a);
      a = knee;
      j = i - 1;
      const double next = steepest(a, at_a, j, c);
      found.knee.push_back(a);
      found.y.push_back(slope - next);
      slope = next;
    }
    found.knee.push_back(a - at_a / slope);
    found.y.push_back(slope);
    return found;
  }

 private:
  double middle(std::size_t i, double c) const { return 1. + (c - 1.) * share_[i]; }
  double lower(std::size_t i, double c) const { return (middle(i, c) - width_[i]) * curve_.F[i]; }
  double upper(std::size_t i, double c) const { return (middle(i, c) + width_[i]) * curve_.F[i]; }

  /// The slope of the line down from (a, at_a) that touches the tunnel's upper side, which is convex: the slope of a
  /// chord rises up to there.
  double steepest(double a, double at_a, std::size_t from, double c) const {
    double most = -infinity;
    for (std::size_t i = from + 1; i-- > 0;) {
      if (curve_.x[i] >= a * (1. - 1e-12)) continue;
      const double slope = (at_a - upper(i, c)) / (a - curve_.x[i]);
      if (slope < most) break;
      most = slope;
    }
    return most;
  }

  const Curve& curve_;
  double first_, lowest_;
  std::vector<double> share_, width_;
};

/// The polygon whose stiffness is G; what is left after three improvements of c shifts all knees but the last, beside
/// which the energy changes fast where the strength cuts the curve off.
Polygon fitted(const Tunnel& tunnel, double G) {
  double c = 1., shift = 1.;
  Polygon polygon;
  for (int i = 0; i < 3; ++i) {
    polygon = tunnel.polygon(c);
    if (polygon.knee.empty()) return {};
    const double last = polygon.y[0] / polygon.knee[0];
    shift = (polygon.stiffness() - last) / (G - last);
    c /= shift;
  }
  for (std::size_t i = 1; i < polygon.knee.size(); ++i) polygon.knee[i] *= shift;
  return polygon;
}

std::vector<BackbonePoint> backbone_of(const Polygon& polygon, double G) {
  std::vector<BackbonePoint> points;
  double slope = G, last = 0., stress = 0.;
  for (std::size_t i = polygon.knee.size(); i-- > 0;) {
    stress += slope * (polygon.knee[i] - last);
    last = polygon.knee[i];
    slope -= polygon.y[i] / polygon.knee[i];
    points.push_back({last, stress});
  }
  return points;
}

/// Largest relative difference of energy, stress and damping ratio at the knees of `exact`.
double largest_error(const Polygon& polygon, const Curve& exact) {
  double worst = 0.;
  for (std::size_t i = exact.first(); i < exact.x.size(); ++i) {
    double energy = 0., stress = 0.;
    for (std::size_t k = 0; k < polygon.knee.size(); ++k) {
      energy += polygon.y[k] * std::max(0., exact.x[i] - polygon.knee[k]);
      stress += polygon.y[k] * std::min(1., exact.x[i] / polygon.knee[k]);
    }
    energy /= exact.F[i];
    stress /= exact.tau[i];
    for (const double ratio : {energy, stress, energy / stress}) worst = std::max(worst, std::abs(ratio - 1.));
  }
  return worst;
}

}  // namespace

std::vector<BackbonePoint> with_few_elements(double G, const std::vector<BackbonePoint>& points) {
  const Curve curve(HystereticLaw(elastic_law(G, 0.), points));
  if (curve.first() == 0 || curve.first() + 1 == curve.x.size()) return points;
  for (double width = widest; width > 0.25 * tolerance; width *= 0.93)
    for (const double deeper : {0.5, 0.2, 0.05}) {
      const Polygon polygon = fitted(Tunnel(curve, G, width, deeper), G);
      if (!polygon.is_convex() || polygon.knee.size() >= curve.x.size()) continue;
      if (largest_error(polygon, curve) <= tolerance - between_knees) return backbone_of(polygon, G);
    }
  return points;
}

}  // namespace upbead
