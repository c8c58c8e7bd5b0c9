// Claims about a prescribed uplift with friction node by node: on rigid ground the caisson is the exact block of eq.
// (4) with N' = W' - U(t), whatever the force, the history of U and its distribution; on real ground the normal
// forces of the nodes have the resultants N' and M' of the caisson's balance, and S decreases with the uplift.
// Sources: sliding/block.h, statics.
#include <gtest/gtest.h>

#include <cmath>

#include "contact_case.h"
#include "findings/effective_base.h"
#include "run/sliding/uplift.h"
#include "upbead/run/simulation.h"

namespace upbead::test {
namespace uplift_test {

constexpr double duration = 3., end = 6.;

TimeFunction half_sine(double peak) {
  return {{0., duration},
          {[](double) { return 0.; }, [peak](double t) { return peak * std::sin(std::acos(-1.) * t / duration); },
           [](double) { return 0.; }}};
}

UpliftChoice of_peak(double peak, UpliftCourse course, double lag = 0.) {
  UpliftChoice uplift;
  uplift.peak = peak;
  uplift.course = course;
  uplift.lag = lag;
  return uplift;
}

/// Linear in time from `first` to `last`, over the whole run.
UpliftChoice of_history(double first, double last) {
  UpliftChoice uplift;
  uplift.history = piecewise_linear({0., end}, {first, last});
  return uplift;
}

/// Transducers at the edges and the middle of the bottom, with different histories.
UpliftChoice of_transducers(double U) {
  UpliftChoice uplift = of_history(0.5 * U, U);
  const TimeFunction first = piecewise_linear({0., end}, {U / 9., U / 9.}),
                     second = piecewise_linear({0., end}, {0., U / 9.});
  uplift.parts = {{{{-9., 1.}, {0., 0.}}, first}, {{{-9., 0.}, {0., 1.}, {9., 0.}}, second}};
  uplift.history = sum(scaled(first, 4.5), scaled(second, 9.));
  return uplift;
}

Scene with_uplift(Scene scene, const UpliftChoice& uplift) {
  scene.regions[caisson_name].interface = ContactLaw{ContactKind::friction, friction};
  scene.sliding = SlidingChoice{friction, submerged_weight(), {}, 0., uplift, {}};
  return scene;
}

Run solved(Scene scene, const std::shared_ptr<const Mesh>& mesh, double until, double step) {
  scene.time.end = until;
  scene.time.step = step;
  return Simulation(scene, mesh).run();
}

/// A function sampled at many times, at which the triangle is exact.
History sampled(const TimeFunction& f) {
  History history;
  for (int i = 0; i <= 6000; ++i) {
    history.time.push_back(end * i / 6000.);
    history.value.push_back(f(history.time.back()));
  }
  return history;
}

struct Named {
  std::string name;
  UpliftChoice uplift;
};

void compare_with_block(const std::string& shape, const TimeFunction& force, const std::vector<Named>& courses) {
  Record record("contact_uplift");
  const double W = submerged_weight();
  const std::shared_ptr<const Mesh> mesh = breakwater_mesh(0.1);
  for (const auto& [course, uplift] : courses) {
    Scene scene = with_uplift(drained_section(force, 0.), uplift);
    stiffen(scene);
    const upbead::Run found = solved(scene, mesh, end, duration / 500.);
    History resistance = sampled(prescribed_uplift(uplift, force, end));
    for (double& value : resistance.value) value = friction * (W - value);
    const double S = slide(caisson_mass(), sampled(force), resistance).residual;
    ASSERT_TRUE(found.summary.contact && found.summary.contact->solved);
    record.at_most("S against that of the block, " + shape + ", uplift " + course,
                   std::abs(found.summary.contact->solved->slip / S - 1.), 1e-5);
  }
}

double most_force() {
  return 1.2 * friction * submerged_weight();
}

Named later_in_phase() {
  return {"in phase, later by a tenth", of_peak(0.3 * submerged_weight(), UpliftCourse::in_phase, 0.1 * duration)};
}

std::vector<Named> other_courses() {
  const double U = 0.3 * submerged_weight();
  return {{"constant", of_history(U, U)},
          {"falling", of_history(U, 0.)},
          {"held", of_peak(U, UpliftCourse::held)},
          {"in phase", of_peak(U, UpliftCourse::in_phase)},
          {"by transducers", of_transducers(U)}};
}

TEST(NodeContactUplift, OnRigidGroundIsTheExactBlock) {
  compare_with_block("triangle", triangle(most_force(), duration), {later_in_phase()});
}

TEST(NodeContactUplift, OnRigidGroundIsTheExactBlockOfOtherCoursesAtLength) {
  compare_with_block("triangle", triangle(most_force(), duration), other_courses());
}

TEST(NodeContactUplift, OnRigidGroundIsTheExactBlockUnderAHalfSineAtLength) {
  std::vector<Named> courses = other_courses();
  courses.push_back(later_in_phase());
  compare_with_block("half sine", half_sine(most_force()), courses);
}

/// Largest difference of the resultants of the nodes' normal forces from N' and M', over W' and W' B.
double unbalanced(const upbead::Run& found) {
  const EffectiveBase base = *effective_base(*found.simulation, found.response.ends, found.contact);
  const ContactHistory& nodes = *found.contact->history;
  const std::size_t n = nodes.position.size();
  double worst = 0.;
  for (std::size_t t = 0; t < base.force.size(); ++t) {
    double force = 0., moment = 0.;
    for (std::size_t i = 0; i < n; ++i) {
      force += nodes.normal_force[t * n + i];
      moment += nodes.normal_force[t * n + i] * nodes.position[i];
    }
    worst = std::max({worst, std::abs(force - base.force[t]) / base.weight,
                      std::abs(moment - base.moment[t]) / (base.weight * base.width)});
  }
  return worst;
}

TEST(NodeContactUplift, IsWhatTheNodesNoLongerPressWith) {
  Record record("contact_uplift");
  const double U = 0.25 * submerged_weight();
  const std::shared_ptr<const Mesh> dry = breakwater_mesh(0.25), wet = breakwater_mesh(0.25, with_sea());
  double last = 0.;
  for (const double peak : {0., 0.5 * U, U}) {
    const upbead::Run found = solved(
        with_uplift(drained_section(triangle(7e6, 0.15), 8.), of_peak(peak, UpliftCourse::held)), dry, 0.6, 0.15 / 32.);
    const std::string at = ", U over W' " + std::to_string(peak / submerged_weight()).substr(0, 5);
    record.at_most("forces of the nodes against N' and M', drained" + at, unbalanced(found), 1e-12);
    record.at_most("energy that is not accounted for, drained" + at, found.summary.energy->mismatch(), 1e-12);
    EXPECT_GT(found.summary.contact->solved->slip, last);
    last = found.summary.contact->solved->slip;
  }
  for (const UpliftDistribution spread : {UpliftDistribution::triangle, UpliftDistribution::uniform}) {
    UpliftChoice uplift = of_peak(U, UpliftCourse::in_phase, 0.03);
    uplift.distribution = spread;
    const upbead::Run found = solved(with_uplift(wet_section(triangle(7e6, 0.15), 8.), uplift), wet, 0.6, 0.15 / 32.);
    record.at_most(std::string("forces of the nodes against N' and M', with pore water and sea, spread ") +
                       (spread == UpliftDistribution::triangle ? "as a triangle" : "evenly"),
                   unbalanced(found), 1e-12);
  }
}

/// A pressure on the whole seaward wall, from `at_foot` at its foot (y = 6 m) to half of it at the water level.
Scene with_sea_in_gaps(Scene scene, double at_foot, GapSource gap) {
  Load& load = scene.loads["wave"];
  load.boundary = "front";
  load.kind = LoadKind::pressure;
  load.shape = {{6., 1.}, {15., 0.5}};
  load.history = triangle(at_foot, 0.3);
  scene.regions[caisson_name].interface->gap = gap;
  return scene;
}

TEST(NodeContactUplift, OfTheSeaInGapsIsBalancedToo) {
  const double U = 0.1 * submerged_weight();
  struct Section {
    std::string name;
    Scene scene;
    std::shared_ptr<const Mesh> mesh;
  };
  for (const auto& [name, scene, mesh] :
       {Section{"drained", drained_section(triangle(7e6, 0.15), 8.), breakwater_mesh(0.25)},
        Section{"with pore water and sea", wet_section(triangle(7e6, 0.15), 8.), breakwater_mesh(0.25, with_sea())}}) {
    const auto answer = [&, section = scene, on = mesh](GapSource gap) {
      const UpliftChoice uplift = of_peak(U, UpliftCourse::in_phase);
      return solved(with_sea_in_gaps(with_uplift(section, uplift), 1e5, gap), on, 0.6, 0.15 / 32.);
    };
    const upbead::Run sea = answer(GapSource::sea), pores = answer(GapSource::pores);
    const NodeContact &with = *sea.summary.contact->solved, &without = *pores.summary.contact->solved;
    EXPECT_LE(unbalanced(sea), 1e-12) << name;
    EXPECT_LE(sea.summary.energy->mismatch(), 1e-12) << name;
    EXPECT_GT(*with.gap_force, 1e5);
    EXPECT_FALSE(without.gap_force);
    EXPECT_GT(with.slip, without.slip);
    EXPECT_GT(with.opening_seaward, without.opening_seaward);
    EXPECT_LT(with.least_normal_force, without.least_normal_force);
  }
}

/// A load of kind force has there its share of the resultant; one on the other wall has none.
TEST(NodeContactUplift, OfTheSeaHasThePressureAtTheFeetOfTheWalls) {
  Scene scene = with_sea_in_gaps(
      with_uplift(drained_section(triangle(7e6, 0.15), 8.), of_peak(1e5, UpliftCourse::held)), 1e5, GapSource::sea);
  Load& force = scene.loads["force"] = scene.loads["wave"];
  force.kind = LoadKind::force;  // 0.75 of the pressure at the foot over 9 m
  force.history = triangle(1e6, 0.3);
  Load& behind = scene.loads["behind"] = scene.loads["wave"];
  behind.boundary = "back";
  behind.history = triangle(2e4, 0.2);
  scene.time.end = 0.6;
  const auto feet = pressures_at_feet(Simulation(scene, breakwater_mesh(0.1)));
  for (const double t : {0.05, 0.15, 0.21}) {
    const double course = triangle(1., 0.3)(t);
    EXPECT_NEAR(feet[0](t), course * (1e5 + 1e6 / (0.75 * 9.)), 1e-3);
    EXPECT_NEAR(feet[1](t), triangle(2e4, 0.2)(t), 1e-9);
  }
}

/// A shape that begins at the foot to the last digit, or in the lowest face, presses on the foot; one that begins above
/// that face does not.
TEST(NodeContactUplift, OfTheSeaIsNotLostWhereAShapeBeginsAtTheFoot) {
  const Scene scene = with_sea_in_gaps(
      with_uplift(drained_section(triangle(7e6, 0.15), 8.), of_peak(1e5, UpliftCourse::held)), 1e5, GapSource::sea);
  const auto pressure = [&](double begin, double end = 15.) {
    Scene other = scene;
    other.loads["wave"].shape = {{begin, 1.}, {end, 0.5}};
    return pressures_at_feet(Simulation(other, breakwater_mesh(0.1)))[0](0.15);
  };
  for (const double begin : {5.9, 6. - 1e-14, std::nextafter(6., 0.), 6., std::nextafter(6., 7.), 6. + 1e-14, 6.01})
    EXPECT_NEAR(pressure(begin), 1e5, begin < 5.95 ? 1e3 : 1e-2) << begin - 6.;
  EXPECT_EQ(pressure(16., 20.), 0.);
}

/// Under slow loads the edge pressures are those of Goda's statics: M_e = W' t - M_U - M_P and p_e of Stability,
/// waves/goda.h.
TEST(NodeContactUplift, SlowlyPressesAsGodaSays) {
  Record record("contact_uplift");
  const double W = submerged_weight(), U = 0.25 * W, P = 0.2 * W, arm = 8., B = 18.;
  Scene scene = drained_section(piecewise_linear({0., 20., 40.}, {0., P, 0.}), arm);
  scene.sliding = SlidingChoice{friction, W, {}, 0., of_peak(U, UpliftCourse::in_phase), {}};
  const upbead::Run found = solved(scene, breakwater_mesh(0.25), 40., 0.05);
  const double e = (P * arm + U * B / 6.) / (W - U), t = 0.5 * B - e;  // M_U = 2/3 U B about the heel
  const double heel = t <= B / 3. ? 2. * (W - U) / (3. * t) : 2. * (W - U) / B * (2. - 3. * t / B);
  record.at_most("heel pressure against Goda's", std::abs(*found.summary.base->peak_heel_pressure / heel - 1.), 2e-3);
  record.at_most(
      "margin against overturning, against Goda's",
      std::abs(*found.summary.base->least_overturning_margin / ((W * 0.5 * B - U * B * 2. / 3.) / (P * arm)) - 1.),
      2e-3);
  record.at_most("eccentricity", std::abs(found.summary.base->largest_eccentricity / e - 1.), 2e-3);
}

}  // namespace uplift_test
}  // namespace upbead::test
