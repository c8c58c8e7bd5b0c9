// Claims: the load under a rough strip that is pushed into undrained ground tends to (2 + pi) c from above.

#include "footing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "record.h"

namespace upbead::test {
namespace {

TEST(Footing, OnClayIsThatOfPrandtl) {
  Record record("footing");
  Footing f;
  f.soil = {0., 1., 0., 1e12};
  f.shear_modulus = 1e3;
  f.width = f.near = 2.5;
  f.depth = f.below = 1.2;
  f.settlement = 0.04;
  f.degree = 3;
  double before = 1.;
  for (const auto& [edge, largest, growth] : {std::array{0.05, 0.4, 1.3}, std::array{0.005, 0.25, 1.35}}) {
    f.edge = edge;
    f.largest = largest;
    f.growth = growth;
    const FootingAnswer answer = push(f);
    ASSERT_TRUE(answer.report.complete);
    const double error = answer.load.back() / (2. + std::acos(-1.)) - 1.;
    const std::string with = ", " + std::to_string(answer.unknowns) + " unknowns";
    record.at_least("N_c: load above the exact one" + with, error, 0.);
    if (before < 1.)
      record.at_most("N_c: error of the load" + with, error, std::min(0.01, 0.4 * before));
    else
      record.measured("N_c: error of the load" + with, error);
    before = error;
  }
}

}  // namespace
}  // namespace upbead::test
