// Claims: the load under a rough strip that is pushed into undrained ground, and into ground with friction under a
// surcharge, tends to that of Prandtl and Reissner from above. Cohesion has the effect of a surcharge c / tan phi.

#include "footing.h"

#include <gtest/gtest.h>

#include <cmath>

#include "from_above.h"

namespace upbead::test {
namespace footing_test {

TEST(Footing, OnClayIsThatOfPrandtl) {
  Record record("footing");
  Footing f = on_clay();
  f.settlement = 0.04;
  std::vector<std::pair<int, double>> errors;
  for (const FootingAnswer& answer : push(f, 5)) {
    ASSERT_TRUE(answer.report.complete);
    errors.emplace_back(answer.unknowns, answer.load.back() / (2. + std::acos(-1.)) - 1.);
  }
  tends_from_above(record, "N_c, undrained", errors, 0.01);
}

Footing on_sand() {
  Footing f;
  f.soil = {30., 0., 30., 1e12};
  f.surcharge = 1.;
  f.width = 5.25;
  f.depth = 2.25;
  f.largest = 0.75;
  f.settlement = 0.008;
  return f;
}

TEST(Footing, WithFrictionIsThatOfReissnerAtLength) {
  Record record("footing");
  std::vector<std::pair<int, double>> errors;
  for (const FootingAnswer& answer : push(on_sand(), 4)) {
    ASSERT_TRUE(answer.report.complete);
    errors.emplace_back(answer.unknowns, answer.load.back() / 18.401 - 1.);
  }
  tends_from_above(record, "N_q, 30 degrees", errors, 0.01);
}

/// With the hydrostatic stress c / tan phi added, both are the same problem (Caquot): N_c = (N_q - 1)/tan phi on any
/// cells.
TEST(Footing, CohesionIsASurcharge) {
  Record record("footing");
  Footing f = on_sand();
  const double N_q = push(f, 1).back().load.back(), tangent = std::tan(std::acos(-1.) / 6.);
  f.surcharge = 0.;
  f.soil.cohesion = tangent;
  const double N_c = push(f, 1).back().load.back() / tangent;
  record.at_most("N_c, 30 degrees, over (N_q - 1)/tan phi, less 1", std::abs(N_c * tangent / (N_q - 1.) - 1.), 1e-4);
}

}  // namespace footing_test
}  // namespace upbead::test
