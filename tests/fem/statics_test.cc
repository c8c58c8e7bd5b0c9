// Claim: slow loads give the static answers. A column under pressure q settles by q L / E_oed and its effective stress
// is -q. Source: oedometer,
// E_oed = 2 G (1 - nu) / (1 - 2 nu). Tolerance: 1e-8 for what remains of the motion after a slow ramp of a drained
// column, far below 1 for a mistake.

#include <gtest/gtest.h>

#include "scenes.h"

namespace upbead::test {
namespace statics_test {

TEST(Statics, ColumnSettlesByTheOedometricModulus) {
  Region soil = sand();
  soil.flow = Flow::drained;
  Scene scene = column(soil, piecewise_linear({0., 1., 1000.}, {0., 1e5, 1e5}));
  scene.time.inertia = false;
  scene.probes["top"].at = {0.5, 10.};
  scene.probes["middle"].at = {0.5, 5.};
  const auto mesh = column_mesh(10., 4);
  const Compiled compiled(scene, *mesh);
  const Response response = run(compiled, 999., 50.);
  const double E = 2. * 32.647e6 * (1. - 0.33) / (1. - 0.66);
  EXPECT_NEAR(history(compiled, response, "probes/top/displacement_y").tail<1>()[0], -1e5 * 10. / E, 1e-8 * 1e6 / E);
  EXPECT_NEAR(history(compiled, response, "probes/middle/effective_stress_yy").tail<1>()[0], -1e5, 1e-3);
  EXPECT_NEAR(history(compiled, response, "probes/middle/strain_yy").tail<1>()[0], -1e5 / E, 1e-8 * 1e5 / E);
}

TEST(Uplift, OfAUniformPressureIsThatTimesTheWidth) {
  Scene scene = breakwater(triangle(1., 0.1));
  const auto mesh = breakwater_mesh(0.5);
  const Compiled compiled(scene, *mesh);
  State state = at_rest(compiled.system);
  for (int i = 0; i < state.v.size(); ++i)
    if (compiled.system.field[static_cast<std::size_t>(i)] == Field::pressure_impulse) state.v[i] = 3.;
  const auto value = [&](const char* name) {
    const System& system = compiled.system;
    return evaluate(system.readings[static_cast<std::size_t>(system.reading(name))], state, {0.});
  };
  EXPECT_NEAR(value("uplift"), 3. * 18., 1e-9);
  EXPECT_NEAR(value("uplift_moment"), 0., 1e-9);
}

}  // namespace statics_test
}  // namespace upbead::test
