// Claim: a rigid region has the mass, centre and moment of inertia of its rectangle, and overrides replace them.
// Source: m (b^2 + h^2) / 12. Tolerance: round-off.

#include <gtest/gtest.h>

#include "fem/compile.h"
#include "scenes.h"

namespace upbead::test {
namespace rigid_body_test {

Body caisson_of(const Scene& scene) {
  const auto mesh = breakwater_mesh(0.5);
  return Compiled(scene, *mesh).scene.bodies.at(0);
}

TEST(RigidBody, IsEvenlyFilledByDefault) {
  const Body body = caisson_of(breakwater(triangle(1., 0.1)));
  const double mass = 2100. * 18. * 16.;
  EXPECT_NEAR(body.mass, mass, 1e-9 * mass);
  EXPECT_NEAR(body.centre[0], 0., 1e-12);
  EXPECT_NEAR(body.centre[1], 14., 1e-12);
  EXPECT_NEAR(body.moment_of_inertia, mass * (18. * 18. + 16. * 16.) / 12., 1e-9 * mass);
}

TEST(RigidBody, TakesMassCentreAndInertiaFromTheScene) {
  Scene scene = breakwater(triangle(1., 0.1));
  Region& caisson = scene.regions["caisson"];
  caisson.density.reset();
  caisson.mass = 5e5;
  caisson.centre_of_gravity = std::array<double, 2>{0.5, 13.};
  caisson.moment_of_inertia = 3e7;
  const Body body = caisson_of(scene);
  EXPECT_EQ(body.mass, 5e5);
  EXPECT_EQ(body.centre[1], 13.);
  EXPECT_EQ(body.moment_of_inertia, 3e7);
}

}  // namespace rigid_body_test
}  // namespace upbead::test
