// Claim: on a rigid caisson a load on a face is exactly its resultant F_x, F_y and M, for any table of intensities; a
// force at a point of the body is the same load as one on a face with that resultant. Source: statics. Tolerance:
// round-off.

#include <gtest/gtest.h>

#include "scenes.h"

namespace upbead::test {
namespace loads_test {

/// The front of the default caisson reaches from y = 6 to y = 22 m.
LoadOnCaisson resultant(const Load& load) {
  Scene scene = breakwater(triangle(1., 0.1));
  scene.loads.clear();
  scene.loads["load"] = load;
  const auto mesh = breakwater_mesh(0.5);
  return Compiled(scene, *mesh).loads_on_caisson.at(0);
}

Load on_front(LoadKind kind, std::vector<std::array<double, 2>> shape) {
  Load load;
  load.boundary = "front";
  load.kind = kind;
  load.shape = std::move(shape);
  return load;
}

TEST(Loads, UniformForceActsAtHalfHeight) {
  const LoadOnCaisson r = resultant(on_front(LoadKind::force, {}));
  EXPECT_NEAR(r.force_x, 1., 1e-13);
  EXPECT_NEAR(r.force_y, 0., 1e-13);
  EXPECT_NEAR(*r.arm(), 8., 1e-12);
}

TEST(Loads, TableOfIntensitiesIsIntegratedExactlyAcrossFaces) {
  // A triangle from y = 9.1 to 13.3 with its top at 10.7: centroid (9.1 + 10.7 + 13.3)/3 - 6 above the bottom.
  const std::vector<std::array<double, 2>> shape{{9.1, 0.}, {10.7, 2.}, {13.3, 0.}};
  EXPECT_NEAR(*resultant(on_front(LoadKind::force, shape)).arm(), (9.1 + 10.7 + 13.3) / 3. - 6., 1e-12);
  EXPECT_NEAR(resultant(on_front(LoadKind::force, shape)).force_x, 1., 1e-13);
  EXPECT_NEAR(resultant(on_front(LoadKind::traction, shape)).force_x, 0.5 * 2. * 4.2, 1e-12);
}

TEST(Loads, PressurePushesAgainstTheOuterNormal) {
  const LoadOnCaisson r = resultant(on_front(LoadKind::pressure, {}));
  EXPECT_NEAR(r.force_x, 16., 1e-12);  // 16 m high, landward
  EXPECT_NEAR(r.force_y, 0., 1e-12);
}

TEST(Loads, IntensityIsZeroBeyondItsTable) {
  EXPECT_NEAR(resultant(on_front(LoadKind::traction, {{8., 1.}, {11., 1.}})).force_x, 3., 1e-12);
}

TEST(Loads, ForceAtAPointOfTheBody) {
  Load load;
  load.region = "caisson";
  load.at = {-9., 14.};
  load.direction = {1., 0.5};
  const LoadOnCaisson r = resultant(load);
  EXPECT_NEAR(r.force_x, 1., 1e-13);
  EXPECT_NEAR(r.force_y, 0.5, 1e-13);
  EXPECT_NEAR(r.moment, 1. * 8. + 9. * 0.5, 1e-12);  // about the middle of the bottom, overturning positive
}

TEST(Loads, FaceAndPointLoadsOfEqualResultantAreTheSameRightHandSide) {
  Scene scene = breakwater(triangle(1., 0.1));
  Load point;
  point.region = "caisson";
  point.at = {-9., 14.};
  point.history = triangle(1., 0.1);
  scene.loads["point"] = point;
  const auto mesh = breakwater_mesh(0.5);
  const Compiled compiled(scene, *mesh);
  const auto& loads = compiled.system.loads;
  EXPECT_LE((loads[0].vector - loads[1].vector).cwiseAbs().maxCoeff(), 1e-12);
}

}  // namespace loads_test
}  // namespace upbead::test
