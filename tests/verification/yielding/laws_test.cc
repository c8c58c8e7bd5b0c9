// Claims about the laws alone: Masing's loops close; G and damping over strain are those of the closed form; no
// random path releases energy; Mohr-Coulomb's tangents are those of differences; every return ends on its plane, edge
// or corner.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include "material/hysteretic_law.h"
#include "material/mohr_coulomb_law.h"
#include "record.h"

namespace upbead::test {
namespace laws_test {

constexpr double G = 60e6, gamma_r = 5e-4, pi = 3.14159265358979323846;
const ElasticLaw small_strain = elastic_law(G, 0.3);

PointMaker overlay(int n) {
  return hysteretic_points(std::make_shared<const HystereticLaw>(
      small_strain,
      backbone(
          G, [](double gamma) { return 1. / (1. + gamma / gamma_r); }, 1e-3 * gamma_r, 30. * gamma_r, n)));
}

/// Commits a strain; its stress, from that at rest on, and the energy dissipated.
PlaneStress follow(SoilPoint& soil, const PlaneStrain& strain, double& dissipated) {
  PlaneStress correction;
  soil.correct(strain, correction);
  soil.commit(strain, dissipated);
  return difference(small_strain.stress(strain), correction);
}

double shear(SoilPoint& soil, double gamma, double& dissipated) {
  return follow(soil, {0., 0., 0.5 * gamma}, dissipated).xy;
}

/// A hyperbola's damping under Masing's rules, x = gamma/gamma_r.
double masing_damping(double x) {
  return 4. / pi * (1. + 1. / x) * (1. - std::log1p(x) / x) - 2. / pi;
}

TEST(HystereticLaw, LoopsModulusAndDampingOverStrain) {
  Record record("yielding_laws");
  const PointMaker points = overlay(200);
  std::vector<double> strain, exact_G, found_G, exact_D, found_D;
  double open = 0.;
  for (const double x : {0.03, 0.1, 0.3, 1., 3., 10., 25.}) {
    const double top = x * gamma_r;
    const auto soil = points(0);
    double before = 0., loop = 0., after = 0.;
    const double tau = shear(*soil, top, before);
    for (int i = 1; i <= 4000; ++i) shear(*soil, top * std::cos(2. * pi * i / 4000), loop);
    open = std::max(open, std::abs(shear(*soil, top, after) / tau - 1.));
    strain.push_back(x);
    exact_G.push_back(1. / (1. + x));
    found_G.push_back(tau / (G * top));
    exact_D.push_back(masing_damping(x));
    found_D.push_back(loop / (2. * pi * tau * top));
  }
  double of_G = 0., of_D = 0.;
  for (std::size_t i = 0; i < strain.size(); ++i) {
    of_G = std::max(of_G, std::abs(found_G[i] / exact_G[i] - 1.));
    of_D = std::max(of_D, std::abs(found_D[i] / exact_D[i] - 1.));
  }
  record.at_most("Masing's loops, 200 elements: stress after a full cycle, relative", open, 1e-12);
  record.at_most("G / G_max, gamma / gamma_r from 0.03 to 25, relative", of_G, 1e-3);
  record.at_most("damping over strain, 0.03 to 25, relative", of_D, 5e-3);
  record.curve({"damping by Masing's rules", "gamma / gamma_r", "D", "overlay", strain, exact_D, found_D});
  record.curve({"modulus", "gamma / gamma_r", "G / G_max", "overlay", strain, exact_G, found_G});
}

PlaneStrain random_strain(std::mt19937& random, double size) {
  std::normal_distribution<double> normal(0., size);
  const double xx = normal(random), yy = normal(random);
  return {xx, yy, normal(random)};
}

TEST(HystereticLaw, MillionRandomPathsTakeEnergy) {
  const PointMaker points = overlay(12);
  std::mt19937 random(24);
  double least = 0.;
  for (int path = 0; path < 1000000; ++path) {
    const auto soil = points(0);
    PlaneStrain at;
    const double size = gamma_r * std::pow(10., -2. + 3. * (path % 10) / 9.);
    for (int i = 0; i < 3; ++i) {
      const PlaneStrain step = random_strain(random, size);
      at = {at.xx + step.xx, at.yy + step.yy, at.xy + step.xy};
      double dissipated = 0.;
      soil->commit(at, dissipated);
      least = std::min(least, dissipated);
    }
  }
  Record record("yielding_laws");
  record.at_most("overlay, 10^6 random paths of 3 steps: most energy given back (J/m3)", -least, 0.);
}

TEST(MohrCoulombLaw, MillionRandomPathsTakeEnergyAndStayWithin) {
  std::mt19937 random(11);
  double least = 0., outside = 0.;
  for (int kind = 0; kind < 1000; ++kind) {
    const double phi = 5. * (kind % 9), psi = phi * (kind % 4) / 3., cohesion = kind % 3 == 0 && phi > 0. ? 0. : 20e3;
    const auto law = std::make_shared<const MohrCoulombLaw>(
        small_strain, MohrCoulombStrength{phi, cohesion, psi, kind % 5 == 0 ? 3e3 : 0.});
    const PlaneStress pressed{-50e3, -80e3, 0., -60e3};
    const PlaneStress rest = law->excess(pressed) > 0. ? law->returned(pressed) : pressed;
    const PointMaker points = mohr_coulomb_points(law, {rest});
    for (int path = 0; path < 1000; ++path) {
      const PlaneStrain strain = random_strain(random, 1e-3);
      double dissipated = 0.;
      const PlaneStress s = sum(rest, follow(*points(0), strain, dissipated));
      const double size = std::abs(s.xx) + std::abs(s.yy) + std::abs(s.zz) + 1e4;
      outside = std::max(outside, law->excess(s) / size);
      least = std::min(least, dissipated / (size * 1e-3));
    }
  }
  Record record("yielding_laws");
  record.at_most("Mohr-Coulomb, 10^6 random paths: stress outside its planes, over the stresses", outside, 1e-8);
  record.at_most("Mohr-Coulomb, 10^6 random paths: most energy given back, over stress times strain", -least, 1e-9);
}

/// The required position of a returned stress: which of the sorted principal stresses are equal, and whether it is at
/// the limits of shear and of tension.
struct Kind {
  const char* name;
  double xx, yy, zz;  ///< the trial stress (kPa)
  int equal;          ///< 0 none, 1 the two largest, 2 the two smallest, 3 all
  bool shears, parts;
};

TEST(MohrCoulombLaw, ReturnsToEveryPlaneEdgeAndCorner) {
  Record record("yielding_laws");
  const double tension = 4., cohesion = 10., k = 3.;
  const MohrCoulombLaw law(elastic_law(6e4, 0.3), {30., cohesion, 10., tension});  // in kPa
  const Kind kinds[] = {{"plane of shear", -50, -500, -200, 0, true, false},
                        {"edge of compression", -50, -500, -50, 1, true, false},
                        {"edge of extension", -50, -500, -500, 2, true, false},
                        {"plane of tension", 20, 0, -5, 0, false, true},
                        {"edge of tension", 20, 19, -20, 1, false, true},
                        {"corner of tension", 300, 310, 305, 3, false, true},
                        {"edge of shear and tension", 130, -50, 20, 0, true, true},
                        {"corner of shear, tension and compression", 88.6, -3, 88.6, 1, true, true},
                        {"corner of shear, tension and extension", 108.6, -0.1, -0.1, 2, true, true}};
  for (const Kind& kind : kinds) {
    double worst = 0.;
    for (int turn = 0; turn < 6; ++turn) {  // for every order of x, y and z
      const double of[] = {kind.xx, kind.yy, kind.zz};
      const int order[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
      const int* o = order[turn];
      MohrCoulombLaw::State state{{of[o[0]], of[o[1]], 0., of[o[2]]}, {}};
      const PlaneStress s = law.update({}, state).stress;
      std::array<double, 3> sorted{s.xx, s.yy, s.zz};
      std::sort(sorted.begin(), sorted.end(), std::greater<>());
      if (kind.shears) worst = std::max(worst, std::abs(k * sorted[0] - sorted[2] - 2. * cohesion * std::sqrt(k)));
      if (kind.parts) worst = std::max(worst, std::abs(sorted[0] - tension));
      if (kind.equal & 1) worst = std::max(worst, std::abs(sorted[0] - sorted[1]));
      if (kind.equal & 2) worst = std::max(worst, std::abs(sorted[1] - sorted[2]));
      worst = std::max({worst, law.excess(s), std::abs(s.xy)});
    }
    record.at_most(std::string("return to the ") + kind.name + ", in all orders: distance (kPa)", worst, 1e-7);
  }
}

/// Columns of the tangent by central differences; left out if another plane yields in between.
TEST(MohrCoulombLaw, TangentIsThatOfDifferences) {
  Record record("yielding_laws");
  const MohrCoulombLaw law(small_strain, {30., 10e3, 5., 2e3});
  const MohrCoulombLaw::State pressed{{-40e3, -60e3, 5e3, -50e3}, {}};
  constexpr double step = 1e-8;
  std::mt19937 random(5);
  double worst = 0.;
  int compared = 0;
  for (int i = 0; i < 3000; ++i) {
    const PlaneStrain at = random_strain(random, 1e-3);
    MohrCoulombLaw::State after = pressed;
    const Tangent T = law.update(at, after).tangent;
    for (int j = 0; j < 3; ++j) {
      std::array<PlaneStress, 3> s;
      for (int side = -1; side <= 1; ++side) {
        PlaneStrain moved = at;
        (j == 0 ? moved.xx : j == 1 ? moved.yy : moved.xy) += (j == 2 ? 0.5 : 1.) * side * step;
        MohrCoulombLaw::State other = pressed;
        s[static_cast<std::size_t>(side + 1)] = law.update(moved, other).stress;
      }
      for (int c = 0; c < 3; ++c) {
        const auto part = [c](const PlaneStress& p) { return c == 0 ? p.xx : c == 1 ? p.yy : p.xy; };
        const double up = (part(s[2]) - part(s[1])) / step, down = (part(s[1]) - part(s[0])) / step;
        if (std::abs(up - down) > 1e-3 * G) continue;
        ++compared;
        worst = std::max(worst,
                         std::abs(T[static_cast<std::size_t>(c)][static_cast<std::size_t>(j)] - 0.5 * (up + down)) / G);
      }
    }
  }
  record.at_most("Mohr-Coulomb: tangent against differences, over G", worst, 1e-3);
  record.at_least("Mohr-Coulomb: share of 27,000 entries compared", compared / 27000., 0.98);
}

}  // namespace laws_test
}  // namespace upbead::test
