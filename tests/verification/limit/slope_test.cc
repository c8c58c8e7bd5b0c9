// Claims: strength reduction finds the factors of safety of a vertical cut in clay, between the bounds of limit
// analysis, and of a slope of Griffiths and Lane (1999).

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "fem/rest_state.h"
#include "record.h"
#include "slope.h"

namespace upbead::test {
namespace slope_test {

constexpr double H = Slope::height, weight = slope_weight;

std::vector<double> lines(double from, double to, double size) {
  return even_lines(from, to, std::max(1, static_cast<int>(std::lround((to - from) / size))));
}

std::string side(double x, double left, double right) {
  return x < left + 1e-9 || x > right - 1e-9 ? "sides" : "";
}

/// The face is at x = 0, the surface of the ground in front of it at y = 0.
std::unique_ptr<Mesh> cut_mesh(double size) {
  constexpr double behind = 1.5 * H, before = H, below = 0.5 * H;
  return tensor_mesh(
      joined(lines(-behind, 0., size), lines(0., before, size)), joined(lines(-below, 0., size), lines(0., H, size)),
      [](const dealii::Point<dim>& p) -> std::string { return p[1] > 0. && p[0] > 0. ? "" : "soil"; },
      [](const dealii::Point<dim>& p) -> std::string {
        if (const std::string found = side(p[0], -behind, before); !found.empty()) return found;
        if (p[1] < 1e-9 - below) return "base";
        return p[1] > H - 1e-9 || (p[0] > -1e-9 && p[1] > -1e-9) ? "surface" : "";
      });
}

/// The middle of the bracket, which is no wider than that.
double factor_of(const SafetyFactor& F, double widest = 0.01) {
  if (!F.lower || !F.upper || *F.upper - *F.lower > widest * *F.lower) return NAN;
  return 0.5 * (*F.lower + *F.upper);
}

/// gamma H / c at collapse: 3.7752 to 3.7776 (Pastor, Thai and Francescato 2009). Clay that bears any tension keeps its
/// volume: close to its limit the search loses digits, and its bracket stays open by 2 %, which it tells.
TEST(Slope, VerticalCutInClayTendsToItsCriticalHeight) {
  Record record("slopes");
  const Scene scene = slope_scene({0., weight * H / 3.7764, 0., 1e12});
  std::vector<double> F;
  for (const double size : {2.5, 1.25}) {
    const SafetyFactor found = safety_factor(scene, *cut_mesh(size), {});
    EXPECT_NE(found.why, "");
    F.push_back(factor_of(found, 0.025));
    const std::string with = ", cells of H/" + std::to_string(std::lround(H / size));
    record.at_least("vertical cut: F - 1" + with, F.back() - 1., 0.);
  }
  record.at_most("vertical cut: F - 1 over that of cells twice as large", (F[1] - 1.) / (F[0] - 1.), 0.6);
  record.at_most("vertical cut: F - 1 of cells without size, by both", std::abs(2. * F[1] - F[0] - 1.), 0.015);
}

TEST(Slope, OfGriffithsAndLaneHasTheirFactor) {
  Record record("slopes");
  const Scene scene = slope_scene({20., 0.05 * weight * H, 0., 1e12});
  record.at_most("slope: F over 1.4, less 1, cells of H/8",
                 std::abs(factor_of(safety_factor(scene, *Slope().mesh(), {})) / 1.4 - 1.), 0.02);
}

}  // namespace slope_test
}  // namespace upbead::test
