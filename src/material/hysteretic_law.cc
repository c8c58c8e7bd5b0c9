#include "material/hysteretic_law.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "upbead/base/error.h"

namespace upbead {
namespace {

/// Components xx, yy, xy of the deviator; zz = -(xx + yy).
PlaneStrain deviator(const PlaneStrain& strain) {
  const double mean = (strain.xx + strain.yy) / 3.;
  return {strain.xx - mean, strain.yy - mean, strain.xy};
}

PlaneStrain difference(const PlaneStrain& a, const PlaneStrain& b) {
  return {a.xx - b.xx, a.yy - b.yy, a.xy - b.xy};
}

double bulk_modulus(const ElasticLaw& law) {
  return law.lambda + 2. / 3. * law.G;
}

/// a : b of two deviators.
double product(const PlaneStrain& a, const PlaneStrain& b) {
  return a.xx * b.xx + a.yy * b.yy + (a.xx + a.yy) * (b.xx + b.yy) + 2. * a.xy * b.xy;
}

/// Adds 2 of_deviator (I_dev) - 2 of_direction (n n), with respect to (eps_xx, eps_yy, gamma).
void add_tangent(double of_deviator, double of_direction, const PlaneStrain& n, Tangent& tangent) {
  const double direction[] = {n.xx, n.yy, n.xy};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) tangent[i][j] -= 2. * of_direction * direction[i] * direction[j];
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) tangent[i][j] += 2. * of_deviator * ((i == j) - 1. / 3.);
  tangent[2][2] += of_deviator;  // gamma = 2 eps_xy
}

/// Intersection of the line of slope G through the origin with the line through the first two points: the polygon
/// then keeps both points and begins with slope G.
BackbonePoint first_knee(double G, const std::vector<BackbonePoint>& points) {
  if (points.size() == 1) return {points[0].tau / G, points[0].tau};
  const double slope = (points[1].tau - points[0].tau) / (points[1].gamma - points[0].gamma);
  const double gamma = (points[0].tau - slope * points[0].gamma) / (G - slope);
  return {gamma, G * gamma};
}

[[noreturn]] void refuse(double gamma) {
  throw InputError(
      Place{},
      "the shear stress does not grow ever more slowly with the strain at a strain of " + std::to_string(gamma),
      "give moduli that fall with the strain, and more slowly than 1/strain");
}

}  // namespace

std::vector<BackbonePoint> backbone(double G, const std::function<double(double)>& modulus_ratio, double from,
                                    double to, int n) {
  std::vector<BackbonePoint> points;
  for (int i = 0; i < n; ++i) {
    const double gamma = from * std::pow(to / from, n > 1 ? double(i) / (n - 1) : 0.);
    points.push_back({gamma, G * gamma * modulus_ratio(gamma)});
  }
  return points;
}

std::vector<BackbonePoint> with_strength(const std::vector<BackbonePoint>& points, double tau_max) {
  std::vector<BackbonePoint> kept;
  BackbonePoint last;
  for (const BackbonePoint& point : points) {
    if (point.tau >= tau_max) {
      const double share = (tau_max - last.tau) / (point.tau - last.tau);
      kept.push_back({last.gamma + share * (point.gamma - last.gamma), tau_max});
      break;
    }
    kept.push_back(point);
    last = point;
  }
  return kept;
}

std::vector<BackbonePoint> concave(const std::vector<BackbonePoint>& points) {
  std::vector<BackbonePoint> kept;
  const auto before_last = [&] { return kept.size() > 1 ? kept[kept.size() - 2] : BackbonePoint(); };
  const auto slope = [](const BackbonePoint& a, const BackbonePoint& b) {
    return (b.tau - a.tau) / (b.gamma - a.gamma);
  };
  for (const BackbonePoint& point : points) {
    while (!kept.empty() && slope(kept.back(), point) >= slope(before_last(), kept.back())) kept.pop_back();
    if (kept.empty() || point.tau >= kept.back().tau) kept.push_back(point);
  }
  return kept;
}

HystereticLaw::HystereticLaw(const ElasticLaw& small_strain, const std::vector<BackbonePoint>& points)
    : elastic_(small_strain) {
  BackbonePoint last;
  double slope = small_strain.G;
  std::vector<BackbonePoint> polygon = points;
  if (polygon.empty() || !(polygon[0].tau <= slope * polygon[0].gamma * (1. + 1e-12)))
    refuse(polygon.empty() ? 0. : polygon[0].gamma);
  polygon[0] = first_knee(slope, points);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const bool ends = i + 1 == polygon.size();
    const double next = ends ? 0. : (polygon[i + 1].tau - polygon[i].tau) / (polygon[i + 1].gamma - polygon[i].gamma);
    const double h = slope - next;
    if (!(polygon[i].gamma > last.gamma) || !(next >= 0.) || !(h > 0.)) refuse(polygon[i].gamma);
    elements_.push_back({h, h * polygon[i].gamma});
    last = polygon[i];
    slope = next;
  }
}

double HystereticLaw::strength() const {
  double sum = 0.;
  for (const Element& element : elements_) sum += element.y;
  return sum;
}

double HystereticLaw::mobilised(const PlaneStress& stress) const {
  const double mean = (stress.xx + stress.yy + stress.zz) / 3.;
  const PlaneStrain s{stress.xx - mean, stress.yy - mean, stress.xy};
  return std::sqrt(0.5 * product(s, s)) / strength();
}

HystereticLaw::State HystereticLaw::bearing(const PlaneStress& stress) const {
  const double mean = (stress.xx + stress.yy + stress.zz) / 3.;
  const PlaneStrain s{stress.xx - mean, stress.yy - mean, stress.xy};
  State state = at_rest();
  const double length = std::sqrt(product(s, s));
  if (length == 0.) return state;
  // the elements yield one after another: finds gamma at which the backbone has this shear stress
  double gamma = 0., borne = 0., slope = elastic_.G;
  const double tau = std::min(length / std::sqrt(2.), strength());
  for (const auto& [h, y] : elements_) {
    const double next = std::min(y / h, gamma + (tau - borne) / slope);
    borne += slope * (next - gamma);
    gamma = next;
    if (gamma < y / h) break;
    slope -= h;
  }
  for (std::size_t i = 0; i < elements_.size(); ++i) {
    const double share = -std::min(gamma, elements_[i].y / elements_[i].h) / (std::sqrt(2.) * length);
    state.plastic[i] = {share * s.xx, share * s.yy, share * s.xy};
  }
  return state;
}

LawAnswer HystereticLaw::update(const PlaneStrain& strain, State& state) const {
  const PlaneStrain e = deviator(strain), e_before = deviator(state.strain);
  LawAnswer answer{elastic_.stress(strain)};
  PlaneStress& s = answer.stress;
  for (std::size_t i = 0; i < elements_.size(); ++i) {
    const auto [h, y] = elements_[i];
    PlaneStrain& plastic = state.plastic[i];
    const PlaneStrain elastic = difference(e, plastic);
    const double length = std::sqrt(product(elastic, elastic)), most = y / (std::sqrt(2.) * h);
    if (length > most) {
      const PlaneStrain n{elastic.xx / length, elastic.yy / length, elastic.xy / length};
      const PlaneStrain before = difference(e_before, plastic);
      const double slid = length - most;
      answer.dissipated += h * slid * (most + product(before, n));
      plastic = {plastic.xx + slid * n.xx, plastic.yy + slid * n.yy, plastic.xy + slid * n.xy};
      add_tangent(h * most / length, h * most / length, n, answer.tangent);
    } else {
      add_tangent(h, 0., {}, answer.tangent);
    }
    s = {s.xx - 2. * h * plastic.xx, s.yy - 2. * h * plastic.yy, s.xy - 2. * h * plastic.xy,
         s.zz + 2. * h * (plastic.xx + plastic.yy)};
  }
  const double bulk = bulk_modulus(elastic_);
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) answer.tangent[i][j] += bulk;
  state.strain = strain;
  return answer;
}

double HystereticLaw::stored(const State& state) const {
  const double volume = state.strain.xx + state.strain.yy;
  double sum = 0.5 * bulk_modulus(elastic_) * volume * volume;
  for (std::size_t i = 0; i < elements_.size(); ++i) {
    const PlaneStrain elastic = difference(deviator(state.strain), state.plastic[i]);
    sum += elements_[i].h * product(elastic, elastic);
  }
  return sum;
}

}  // namespace upbead
