// Claims: the reduced model of a scene whose caisson may slip has, while it sticks, the response of the bonded scene,
// with an error below the tolerance; if friction is less than F_T requires, the caisson slips by a rigid motion that
// does not move the soil; a larger model slips equally far; scenes without an interface are refused.
#include "response/slip_reduction.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "fem/caisson/readings.h"
#include "response/reduction.h"
#include "scenes.h"
#include "sliding/coupled_slip.h"

namespace upbead::test {
namespace slip_reduction_test {

constexpr double duration = 0.15, end = 0.6, friction = 0.6;

/// A breakwater with an interface, and the same bonded.
struct Twins {
  Twins()
      : scene(breakwater(triangle(1.6e6, duration))),
        mesh(breakwater_mesh(0.5)),
        slipping((scene.time.end = end, scene), *mesh, true),
        glued(scene, *mesh),
        response(run(glued, end, duration / 32.)) {}

  double peak_shear() const { return response.ends.reading.row(glued.system.reading(reading::shear_force)).maxCoeff(); }
  SlipReduction reduced(double tolerance) const {
    Scene wanted = slipping.resolved;
    wanted.tolerance = tolerance;
    return reduce_slip(wanted, slipping.scene, UpliftKind::computed, response.ends);
  }
  /// With N_0 of `safety` times the value that F_T requires to stick.
  CoupledSliding slide(const SlipReduction& reduction, double safety, CoupledHistory* history = nullptr) const {
    const SlipLaw law = slip_law(reduction.system, friction, UpliftKind::computed, {reading::displacement_x});
    SampledLoads loads = sampled_loads(slipping.resolved, slipping.system);
    for (Eigen::MatrixXd* part : {&loads.begin, &loads.end}) {
      part->conservativeResize(2, Eigen::NoChange);
      part->row(1).setConstant(safety * peak_shear() / friction);
    }
    return CoupledSlip(slip_model(reduction.system, law), duration / 64.).slide(loads, history);
  }

  Scene scene;
  std::unique_ptr<Mesh> mesh;
  Compiled slipping, glued;
  Response response;
};

TEST(SlipReduction, SticksAsItsGluedTwinAndSlips) {
  const Twins twins;
  const SlipReduction reduction = twins.reduced(twins.scene.tolerance);
  ASSERT_TRUE(reduction.converged);
  EXPECT_LE(reduction.error.history, twins.scene.tolerance);
  EXPECT_LE(reduction.bonded_error, twins.scene.tolerance);
  EXPECT_GT(reduction.bonded_error, 0.);

  EXPECT_TRUE(twins.slide(reduction, 1.02).slip.slips.empty());
  CoupledHistory history;
  const CoupledSliding slid = twins.slide(reduction, 0.6, &history);
  EXPECT_GT(slid.slip.residual, 1e-3);
  EXPECT_NEAR(slid.peak_shear, 0.6 * twins.peak_shear(), 0.01 * slid.peak_shear) << "N' hardly moves here";
  EXPECT_GT(slid.dissipated, 0.);
  const double x = history.outputs(0, history.outputs.cols() - 1);
  EXPECT_NEAR(x, slid.slip.residual, 0.5 * slid.slip.residual) << "the caisson is carried along, its soil swings";

  const SlipReduction larger = twins.reduced(5e-5);
  EXPECT_GT(larger.n_vectors, reduction.n_vectors);
  for (const double safety : {0.9, 0.6, 0.3}) {
    const double residual = twins.slide(larger, safety).slip.residual;
    EXPECT_NEAR(twins.slide(reduction, safety).slip.residual, residual, 1e-3 * residual) << safety;
  }
}

TEST(SlipReduction, NeedsAnInterface) {
  const Twins twins;
  EXPECT_THROW(reduce_slip(twins.scene, twins.glued.scene, UpliftKind::prescribed, twins.response.ends),
               std::invalid_argument);
}

}  // namespace slip_reduction_test
}  // namespace upbead::test
