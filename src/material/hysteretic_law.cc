#include "material/hysteretic_law.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "base/numbers.h"
#include "material/few_elements.h"
#include "material/soil_by_law.h"
#include "upbead/base/error.h"

namespace upbead {
namespace {

/// Components xx, yy, xy of the deviator of a strain; zz = -(xx + yy).
template <class Strain>
UPBEAD_IN_CLONES Strain deviator(const Strain& strain) {
  const auto mean = (strain.xx + strain.yy) / 3.;
  return {strain.xx - mean, strain.yy - mean, strain.xy};
}

template <class Strain>
UPBEAD_IN_CLONES Strain minus(const Strain& a, const Strain& b) {
  return {a.xx - b.xx, a.yy - b.yy, a.xy - b.xy};
}

/// a : b of two deviators.
template <class Strain>
UPBEAD_IN_CLONES auto product(const Strain& a, const Strain& b) {
  return a.xx * b.xx + a.yy * b.yy + (a.xx + a.yy) * (b.xx + b.yy) + 2. * a.xy * b.xy;
}

PlaneStrain deviator_of(const PlaneStress& s) {
  const double mean = (s.xx + s.yy + s.zz) / 3.;
  return {s.xx - mean, s.yy - mean, s.xy};
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
  const PlaneStrain s = deviator_of(stress);
  return std::sqrt(0.5 * product(s, s)) / strength();
}

std::vector<PlaneStrain> HystereticLaw::bearing(const PlaneStress& stress) const {
  const PlaneStrain s = deviator_of(stress);
  std::vector<PlaneStrain> plastic(elements_.size());
  const double length = std::sqrt(product(s, s));
  if (length == 0.) return plastic;
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
    plastic[i] = {share * s.xx, share * s.yy, share * s.xy};
  }
  return plastic;
}

/// The overlay of cells side by side. Energies and stresses are less those of elastic soil.
template <int n>
struct Overlay {
  using Number = typename Beside<n>::Number;
  using Strain = typename Beside<n>::Strain;
  using Stress = typename Beside<n>::Stress;

  /// h (Pa), the elastic strain at which it slides, and its plastic strain at rest.
  struct Element {
    Number h{}, most{}, most_squared{};
    Strain rest;
  };
  struct State {
    Strain strain;
    double n_moved = 0.;       ///< elements from here on have never slid in any cell
    std::vector<Strain> slid;  ///< plastic strains of the elements since rest
  };

  std::vector<Element> elements;
  double n_uneven = 0.;  ///< elements from here on are alike at rest
  std::vector<std::pair<std::shared_ptr<const HystereticLaw>, PlaneStress>> laws;  ///< by lane, with the stress at rest

  template <class Any, class Visit>
  static void visit(Any& state, const Visit& of_part) {
    of_part(state.strain);
    of_part(state.n_moved);
    for (auto& slid : state.slid) of_part(slid);
  }

  /// Missing elements of a law, and those of lanes without a cell, have no stiffness and never slide.
  void add(const Overlay<1>& one) {
    Element idle;
    idle.most += infinity;
    idle.most_squared += infinity;
    if (elements.size() < one.elements.size()) elements.resize(one.elements.size(), idle);
    for (std::size_t i = 0; i < one.elements.size(); ++i)
      set_lane(one.elements[i], static_cast<int>(laws.size()), elements[i]);
    n_uneven = std::max(n_uneven, one.n_uneven);
    laws.push_back(one.laws.front());
  }
  State at_rest() const { return {{}, 0., std::vector<Strain>(elements.size())}; }
  template <class One>
  State joined(const std::vector<const One*>& /*at_rest*/) const {
    return at_rest();
  }

  /// Elastic strain of an element at the deviator e.
  UPBEAD_IN_CLONES Strain elastic(const State& state, std::size_t i, const Strain& e) const {
    return minus(minus(e, elements[i].rest), state.slid[i]);
  }

  /// The share of its elastic strain by which an element slides: 1 - most/length where that is positive, else 0.
  UPBEAD_IN_CLONES static Number share_of(const Element& element, const Number& squared) {
    Number root;
    detail::square_root(element.most_squared / squared, root);
    return squared > element.most_squared ? 1. - root : Number{};
  }

  UPBEAD_IN_CLONES static void add(const Number& factor, const Strain& a, Strain& sum) {
    sum.xx += factor * a.xx;
    sum.yy += factor * a.yy;
    sum.xy += factor * a.xy;
  }

  /// The knees of the elements ascend: if one has never slid and does not slide now, neither do later ones that are
  /// alike at rest.
  UPBEAD_IN_CLONES bool ends_at(std::size_t i, const State& state) const {
    return static_cast<double>(i) >= std::max(state.n_moved, n_uneven);
  }

  UPBEAD_IN_CLONES void correct(const State& state, const Strain& strain, Stress& correction) const {
    const Strain e = deviator(strain);
    Strain sum;
    for (std::size_t i = 0; i < elements.size(); ++i) {
      const Strain left = elastic(state, i, e);
      const Number squared = product(left, left);
      Strain now = state.slid[i];
      if (detail::holds_anywhere(squared > elements[i].most_squared))
        add(share_of(elements[i], squared), left, now);
      else if (ends_at(i, state))
        break;
      add(elements[i].h, now, sum);
    }
    correction = {2. * sum.xx, 2. * sum.yy, 2. * sum.xy, -2. * (sum.xx + sum.yy)};
  }

  UPBEAD_IN_CLONES void commit(State& state, const Strain& strain, Number& dissipated) const {
    const Strain e = deviator(strain), e_before = deviator(state.strain);
    for (std::size_t i = 0; i < elements.size(); ++i) {
      const Element& element = elements[i];
      const Strain left = elastic(state, i, e);
      const Number squared = product(left, left);
      if (!detail::holds_anywhere(squared > element.most_squared)) {
        if (ends_at(i, state)) break;
        continue;
      }
      const Number share = share_of(element, squared), along = product(elastic(state, i, e_before), left);
      Number length;
      detail::square_root(squared, length);
      dissipated += share > Number{} ? element.h * share * (element.most * length + along) : Number{};
      add(share, left, state.slid[i]);
      state.n_moved = std::max(state.n_moved, static_cast<double>(i + 1));
    }
    state.strain = strain;
  }

  /// sum h (|e - q|^2 + 2 r : q) less sum h |e|^2; q is the plastic strain since rest, r that at rest.
  UPBEAD_IN_CLONES void stored(const State& state, const Strain& strain, Number& energy) const {
    const Strain e = deviator(strain);
    energy = Number{};
    for (std::size_t i = 0; i < static_cast<std::size_t>(state.n_moved); ++i) {
      const Strain& q = state.slid[i];
      energy += elements[i].h * (product(q, q) - 2. * product(q, minus(e, elements[i].rest)));
    }
  }

  /// Least distance of the elements' elastic strains from sliding.
  UPBEAD_IN_CLONES void margin(const State& state, const Strain& strain, Number& least) const {
    const Strain e = deviator(strain);
    least = Number{} + infinity;
    for (std::size_t i = 0; i < elements.size(); ++i) {
      const Strain left = elastic(state, i, e);
      Number length;
      detail::square_root(product(left, left), length);
      const Number distance = elements[i].most - length;
      least = distance < least ? distance : least;
    }
  }

  double mobilised(const State& /*state*/, int lane, const PlaneStress& change) const {
    const auto& [law, rest] = laws[static_cast<std::size_t>(lane)];
    return law->mobilised(sum(rest, change));
  }
};

namespace {

/// The overlay of a cell.
Overlay<1> overlay_of(std::shared_ptr<const HystereticLaw> law, std::vector<PlaneStrain> rest) {
  Overlay<1> overlay;
  rest.resize(law->elements().size());
  PlaneStress stress;
  for (std::size_t i = 0; i < rest.size(); ++i) {
    const auto [h, y] = law->elements()[i];
    const double most = y / (std::sqrt(2.) * h);
    overlay.elements.push_back({h, most, most * most, rest[i]});
    stress = {stress.xx - 2. * h * rest[i].xx, stress.yy - 2. * h * rest[i].yy, stress.xy - 2. * h * rest[i].xy,
              stress.zz + 2. * h * (rest[i].xx + rest[i].yy)};
    if (i > 0 && (rest[i].xx != rest[i - 1].xx || rest[i].yy != rest[i - 1].yy || rest[i].xy != rest[i - 1].xy))
      overlay.n_uneven = static_cast<double>(i);
  }
  overlay.laws.emplace_back(std::move(law), stress);
  return overlay;
}

}  // namespace

PointMaker hysteretic_points(std::shared_ptr<const HystereticLaw> law, std::vector<PlaneStrain> plastic_at_rest) {
  auto overlay = std::make_shared<const Overlay<1>>(overlay_of(std::move(law), std::move(plastic_at_rest)));
  return [overlay](unsigned) { return std::make_unique<SoilBy<Overlay, 1>>(overlay, overlay->at_rest()); };
}

namespace {

/// Number of points of the backbone that the elements of the overlay are found from, and their range of strain, over
/// the reference strain: up to 97 % of the strength of the hyperbola.
constexpr int n_points = 1000;
constexpr double first_strain = 0.001, last_strain = 30.;

/// The points of the overlay for G = 1: over the reference strain where the strength alone is given, which then is 1.
std::vector<BackbonePoint> unit_curve(const RegionSoil& soil, double strength) {
  const auto hyperbola = [](double gamma) { return 1. / (1. + gamma); };
  if (!soil.curve) return with_few_elements(1., backbone(1., hyperbola, first_strain, last_strain, n_points));
  const auto [from, to] = soil.curve->range.value_or(
      std::array<double, 2>{first_strain * soil.curve->reference_strain, last_strain * soil.curve->reference_strain});
  const auto points = concave(backbone(1., soil.curve->modulus_ratio, from, to, n_points));
  return with_few_elements(1., soil.strength ? with_strength(points, strength) : points);
}

std::function<CellPoints(const CellSoil&)> make(const RegionSoil& soil) {
  const bool differs = soil.curve && soil.strength;  // from cell to cell
  const auto known = differs ? std::vector<BackbonePoint>() : unit_curve(soil, 1.);
  return [=](const CellSoil& cell) -> CellPoints {
    const double G = cell.elastic.G, strength = soil.strength ? soil.strength->shear(cell.mean) : 0.;
    std::vector<BackbonePoint> points = differs ? unit_curve(soil, strength / G) : known;
    for (BackbonePoint& point : points) {
      if (!soil.curve) point = {point.gamma * strength / G, point.tau * strength / G};
      point.tau *= G;
    }
    const auto law = std::make_shared<const HystereticLaw>(cell.elastic, points);
    const PlaneStress& rest = cell.at_rest.front();
    return {hysteretic_points(law, law->bearing(rest)), law->mobilised(rest) > 1. + 1e-9};
  };
}

}  // namespace

const SoilLawRow hysteretic_row{
    "hysteretic",
    "hysteretic soil",
    SoilNeeds::curve_or_strength,
    RestStress::given,
    "it yields along the curve of strain up to its strength, and turns back by Masing's rules",
    make,
    compacting_point};

}  // namespace upbead
