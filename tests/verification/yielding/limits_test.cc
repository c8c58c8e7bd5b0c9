// Claim: a saturated Mohr-Coulomb soil that is squeezed in plane strain fails at its undrained strength, q = 2 (c'
// cos phi' + p0 sin phi'), if water cannot leave and psi = 0, and at its drained strength, q = (k - 1) p0 + 2 c'
// sqrt(k), k = (1 + sin phi')/(1 - sin phi'), if water can leave. Undrained, the volume and so the mean effective
// stress of the plane are constant, elastic or not. Drained, psi = phi': with psi = 0 the soil yields under the same
// load, but its stress is not uniform as it flows, so that there is no exact solution to compare with.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "material/mohr_coulomb_law.h"
#include "tensor_mesh.h"
#include "yielding_march.h"

namespace upbead::test {
namespace limits_test {

constexpr double p0 = 100e3, pi = 3.14159265358979323846;
/// The load grows to 1.001 of the strength, and stays. The load above the strength is balanced by inertia alone; it
/// is kept small, as it makes the stresses non-uniform.
constexpr double top = 1.001, grown = 2., end = 3.5, step = 2.5e-3;

struct Soil {
  double friction_angle, cohesion, dilatancy_angle;
};

double undrained_strength(const Soil& s) {
  const double phi = s.friction_angle * pi / 180.;
  return 2. * (s.cohesion * std::cos(phi) + p0 * std::sin(phi));
}

/// The drained strength under a horizontal stress (Pa, compression positive).
double drained_strength(const Soil& s, double side = p0) {
  const double sine = std::sin(s.friction_angle * pi / 180.), k = (1. + sine) / (1. - sine);
  return (k - 1.) * side + 2. * s.cohesion * std::sqrt(k);
}

std::unique_ptr<Mesh> specimen() {
  const auto curve = [](const dealii::Point<dim>& p) -> std::string {
    if (p[1] < 1e-9) return "base";
    if (p[1] > 1. - 1e-9) return "top";
    return p[0] < 1e-9 ? "left" : p[0] > 1. - 1e-9 ? "right" : "";
  };
  return tensor_mesh(
      even_lines(0., 1., 6), even_lines(0., 1., 8), [](const dealii::Point<dim>&) { return "soil"; }, curve);
}

/// On smooth base and side, free on the right, squeezed by a load that grows. The water keeps its volume.
Scene squeezed(const Soil& s, double permeability, PressureCondition right, double strength) {
  Scene scene = column(sand(), piecewise_linear({0., grown, end}, {0., top * strength, top * strength}));
  scene.fluid.bulk_modulus = 2.2e12;
  Region& region = scene.regions["soil"];
  region.hydraulic_conductivity = permeability;
  region.flow = Flow::darcy;
  region.damping.reset();
  region.law = SoilLaw::mohr_coulomb;
  region.strength = Strength{s.friction_angle, s.cohesion, s.dilatancy_angle, 0.};
  scene.boundaries["base"].displacement = DisplacementCondition::roller;
  scene.boundaries["right"] = {DisplacementCondition::free, right};
  scene.boundaries["top"].pressure = PressureCondition::sealed;
  scene.probes["inside"].at = {0.3, 0.4};
  scene.probes["top"].at = {0.5, 1.};
  return scene;
}

/// The load at which some soil has yielded for the first time.
double first_yield(const YieldingMarch& found, double strength) {
  const auto& energy = found.response.energy;
  const auto yields = std::find_if(energy.begin(), energy.end(), [](const auto& e) { return e.plastic > 0.; });
  EXPECT_NE(yields, energy.end());
  const double t = found.response.ends.time[static_cast<std::size_t>(yields - energy.begin())];
  return top * strength * std::min(1., t / grown);
}

void check(const YieldingMarch& found, const Soil& s, double strength, bool drained, Record& record,
           const std::string& what) {
  const auto xx = found.history("probes/inside/effective_stress_xx"),
             yy = found.history("probes/inside/effective_stress_yy"),
             sinks = found.history("probes/top/displacement_y");
  record.at_most(what + "load at which it yields, relative", std::abs(first_yield(found, strength) / strength - 1.),
                 1.1 * step / grown);
  // inertia of the sides, which move outwards, causes a small pressure in the middle: the strength is that under the
  // stress there
  double most = 0.;
  for (Eigen::Index i = 0; i < xx.size(); ++i)
    most = std::max(most, (xx[i] - yy[i]) / (drained ? drained_strength(s, p0 - xx[i]) : strength));
  record.at_most(what + "difference of stresses that it bears at most, over that which fails it, less 1",
                 std::abs(most - 1.), 0.005);
  if (drained)
    record.at_most(what + "change of the horizontal effective stress, over p0", xx.cwiseAbs().maxCoeff() / p0, 0.02);
  else
    record.at_most(what + "change of the mean effective stress of the plane, over p0",
                   (xx + yy).cwiseAbs().maxCoeff() / (2. * p0), 0.01);
  const auto full = static_cast<Eigen::Index>(std::lround(grown / step));
  record.at_least(what + "how far it sinks under 1.001 of the strength in 1.5 s, over what it sank before",
                  sinks.tail(1)[0] / sinks[full] - 1., 10.);
}

class Squeezed : public ::testing::TestWithParam<double> {};

TEST_P(Squeezed, FailsAtItsUndrainedAndDrainedStrength) {
  Record record("yielding_limits");
  const auto mesh = specimen();
  const std::string of_angle = ", phi' = " + std::to_string(int(GetParam())) + " degrees: ";
  for (const bool drained : {false, true}) {
    const Soil s{GetParam(), GetParam() < 20. ? 40e3 : 10e3, drained ? GetParam() : 0.};
    const double strength = drained ? drained_strength(s) : undrained_strength(s);
    const Scene scene =
        squeezed(s, drained ? 100. : 1e-9, drained ? PressureCondition::open : PressureCondition::sealed, strength);
    const Region& region = scene.regions.at("soil");
    const auto law = std::make_shared<const MohrCoulombLaw>(
        elastic_law(*region.shear_modulus, *region.poissons_ratio),
        MohrCoulombStrength{s.friction_angle, s.cohesion, s.dilatancy_angle, 0.});
    const SoilPoints isotropic = [points = mohr_coulomb_points(law, {{-p0, -p0, 0., -p0}})](unsigned, unsigned q) {
      return points(q);
    };
    const YieldingMarch found(scene, *mesh, end, step, isotropic, 1e-8);
    check(found, s, strength, drained, record, (drained ? "drained" : "undrained") + of_angle);
  }
}

INSTANTIATE_TEST_SUITE_P(Angles, Squeezed, ::testing::Values(15.));
INSTANTIATE_TEST_SUITE_P(AnglesAtLength, Squeezed, ::testing::Values(0., 35.));

}  // namespace limits_test
}  // namespace upbead::test
