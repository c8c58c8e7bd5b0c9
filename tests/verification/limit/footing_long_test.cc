// Claims: the loads of strips that are pushed into ground with friction, and aside on undrained ground, tend to those
// of plasticity theory from above.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "footing.h"
#include "record.h"

namespace upbead::test {
namespace {

using Cells = std::array<double, 3>;  // size at the edge (m), growth, largest (m)

std::string with(const FootingAnswer& answer) {
  return ", " + std::to_string(answer.unknowns) + " unknowns";
}

Footing on(const Footing& footing, const Cells& cells) {
  Footing f = footing;
  f.degree = 3;
  f.edge = cells[0];
  f.growth = cells[1];
  f.largest = cells[2];
  f.near = f.width;
  f.below = f.depth;
  return f;
}

/// h = 0.5: associated flow is along the normal of the exact curve there.
TEST(FootingLong, PushedAsideFollowsGreen) {
  Record record("footing");
  Footing f;
  f.soil = {0., 1., 0., 1e12};
  f.shear_modulus = 1e3;
  f.width = 2.5;
  f.depth = 1.2;
  f.settlement = 0.03;
  f.sideways = std::sqrt(3.);
  double before = 1.;
  for (const Cells& cells : {Cells{0.05, 1.4, 0.4}, Cells{0.02, 1.4, 0.25}}) {
    const FootingAnswer answer = push(on(f, cells));
    const double h = std::abs(answer.shear.back());
    const double exact = 1. + 0.5 * std::acos(-1.) + std::acos(h) + std::sqrt(1. - h * h);
    const double error = answer.load.back() / exact - 1.;
    record.at_least("pushed aside: V above Green's at its H" + with(answer), error, 0.);
    record.at_most("pushed aside: error of V" + with(answer), error, before < 1. ? 0.03 : 0.06);
    before = error;
  }
}

/// gamma = B = 1.
TEST(FootingLong, WithWeightTendsToMartins) {
  Record record("footing");
  Footing f;
  f.soil = {30., 0., 30., 1e12};
  f.unit_weight = 1.;
  f.shear_modulus = 1e4;
  f.width = 2.2;
  f.depth = 1.1;
  f.settlement = 0.003;
  double before = 1.;
  for (const Cells& cells : {Cells{0.04, 1.2, 0.2}, Cells{0.02, 1.15, 0.15}}) {
    const FootingAnswer answer = push(on(f, cells));
    const double error = 2. * answer.load.back() / 14.754 - 1.;
    record.at_least("N_gamma, 30 degrees: load above the exact one" + with(answer), error, 0.);
    record.at_most("N_gamma, 30 degrees: error" + with(answer), error, before < 1. ? 0.7 * before : 0.1);
    before = error;
  }
}

}  // namespace
}  // namespace upbead::test
