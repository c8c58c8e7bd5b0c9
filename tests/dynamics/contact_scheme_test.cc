// Claims: the scheme with a contact law is SDIRK on the bonded system where nothing slips or lifts, the exact block
// where the ground is rigid, and the reference where it is elastic (tests/reference/ref7_sliding.json, parts B and
// C); nodes that stick do not creep, none penetrates, energy is balanced, and friction only dissipates.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "contact_systems.h"
#include "sample_system.h"
#include "system/interface.h"
#include "upbead/base/error.h"

namespace contact_scheme_test {

using namespace upbead;
using namespace upbead::test;
using Json = nlohmann::json;

constexpr int slip = 3;  ///< the first unknown of slip: after x, y and rotation

Json reference() {
  return Json::parse(std::ifstream(REFERENCE_FILE));
}

/// A block on n nodes over 18 m, whose ground is about as stiff as rubble on sand.
BlockOnNodes wide_block(int n) {
  BlockOnNodes block;
  block.position.clear();
  for (int i = 0; i < n; ++i) block.position.push_back(-9. + 18. * i / (n - 1));
  block.kx = 1.2e9 / n;
  block.ky = 2.4e9 / n;
  block.cx = 1e7 / n;
  block.cy = 2e7 / n;
  block.node_mass = 2e5 / n;
  block.link = 5e7 * n / 18.;
  return block;
}

double mean_slip(const State& state, int n) {
  return state.x.segment(slip, n).mean();
}

TEST(FrictionalContact, IsSdirkOnTheGluedSystemUnlessFrictionIsReached) {
  const System system = wide_block(7).system(triangle(1e6, 0.3), triangle(3e5, 0.2));
  const System as_one = bonded(system);
  const auto contact = make_contact_scheme(system);
  const auto plain = make_scheme(as_one);
  State a = at_rest(system), b = at_rest(as_one);
  for (int i = 0; i < 200; ++i) {
    a.time = b.time = 0.005 * i;
    contact->advance(a, 0.005);
    plain->advance(b, 0.005);
    ASSERT_EQ(a.x.head(slip), b.x) << i;
    ASSERT_EQ(a.a.head(slip), b.a) << i;
  }
  EXPECT_EQ(contact->n_solves(), plain->n_solves());
  EXPECT_EQ(contact->n_factorisations(), 1);
  EXPECT_TRUE(a.x.tail(14).isZero(0.));
  EXPECT_NEAR(contact->energy().work, plain->energy().work, 1e-14 * plain->energy().largest_work);
  EXPECT_EQ(contact->contact()->slip_steps + contact->contact()->open_steps, 0);
}

/// The block without mass, or with mass and dashpots, under a force that rises in 20 s to `share` of the friction
/// limit.
ContactMarch slowly_pushed(double share, bool inertia, double step) {
  BlockOnNodes block = wide_block(7);
  block.arm = -2.;
  const double P = share * block.friction * block.weight;
  System system = block.system(piecewise_linear({0., 20., 1e9}, {0., P, P}));
  if (!inertia) system.M = SparseMatrix(system.M.rows(), system.M.cols());
  return march_contact(system, 25., step);
}

TEST(FrictionalContact, WithoutInertiaIsTheSlowMotion) {
  for (const double share : {0.6, 0.9, 0.99}) {
    const ContactMarch quasi_static = slowly_pushed(share, false, 0.5), finer = slowly_pushed(share, false, 0.125);
    const ContactMarch dynamic = slowly_pushed(share, true, 0.01);
    const double S = mean_slip(quasi_static.states.back(), 7);
    EXPECT_GT(S, 1e-5);
    EXPECT_NEAR(S, mean_slip(dynamic.states.back(), 7), 0.02 * S) << share;
    EXPECT_NEAR(S, mean_slip(finer.states.back(), 7), 0.01 * S) << share;
    EXPECT_LE(quasi_static.mismatch(), 1e-12);
  }
}

TEST(FrictionalContact, WithoutInertiaNothingStopsABlockThatSlides) {
  EXPECT_THROW(slowly_pushed(1.05, false, 0.5), NumericsError);
}

// A constant force P > mu W for a time t, on rigid ground: S = (P - R) t^2 P / (2 m R). The stiffness of the ground,
// 1e16 N/m, leaves R/k / S = 1e-8.
TEST(FrictionalContact, OnRigidGroundIsTheExactBlock) {
  BlockOnNodes block;
  block.kx = block.ky = 1e16;
  block.inertia = 1e18;
  const double P = 3e6, t = 0.2, R = block.friction * block.weight;
  const double S = (P - R) * t * t * P / (2. * block.mass * R);
  const System system = block.system(
      TimeFunction({0., t}, {[](double) { return 0.; }, [P](double) { return P; }, [](double) { return 0.; }}));
  const ContactMarch result = march_contact(system, 0.5, 2.5e-4);
  EXPECT_NEAR(result.states.back().x[slip], S, 1e-6 * S);
  EXPECT_NEAR(result.energy.back().friction, R * S, 1e-6 * R * S);
  EXPECT_EQ(result.states.back().v[slip], 0.);
}

void compare_with_reference(const std::string& part, const std::string& residual) {
  const Json rows = reference()[part];
  int n_slides = 0;
  for (const Json& row : rows) {
    SCOPED_TRACE(row["td"].dump() + " s, " + row["Pm"].dump() + " N/m");
    BlockOnNodes block;
    block.mass = row["m"];
    block.inertia = 1e15;
    block.kx = row.contains("k") ? row["k"] : row["kb"];
    block.ky = 1e12;
    block.node_mass = row.value("mb", 0.);
    block.cx = row.value("cb", 0.);
    block.weight = row["R"].get<double>() / block.friction;
    const ContactMarch result = march_contact(block.system(triangle(row["Pm"], row["td"])), 1., 1e-3);
    const double S = row[residual];
    EXPECT_NEAR(result.states.back().x[slip], S, std::max(1e-4 * S, 1e-15));
    n_slides += result.report.slip_steps > 0;
  }
  EXPECT_GE(n_slides, 6);
}

// The references are exact to 1e-9; steps of 1 ms leave errors up to 3.4e-5.
TEST(FrictionalContact, OnABareSpringIsTheReference) {
  compare_with_reference("slider", "residual_slip");
}
TEST(FrictionalContact, OnAMassWithSpringAndDashpotIsTheReference) {
  compare_with_reference("stickslip", "residual_relative_slip");
}

// In a step in which no node slips all slips keep their values to the last bit, although the ground and with it the
// shear forces go on oscillating.
TEST(FrictionalContact, DoesNotCreepNorPenetrate) {
  const int n = 9;
  BlockOnNodes block = wide_block(n);
  block.cx = block.cy = 0.;
  block.arm = 0.;
  const ContactMarch result = march_contact(block.system(triangle(3e6, 0.3)), 3., 1e-3);
  int still = 0;
  for (std::size_t i = 1; i < result.states.size(); ++i) {
    const State &before = result.states[i - 1], &state = result.states[i];
    const InterfaceForces& forces = result.forces[i];
    ASSERT_GE(state.x.tail(n).minCoeff(), 0.);
    ASSERT_TRUE((forces.shear.array().abs() <= block.friction * forces.normal.array() + 1e-9 * block.weight).all());
    if (result.moving_steps[i] > result.moving_steps[i - 1]) continue;
    ++still;
    ASSERT_EQ(state.x.tail(2 * n), before.x.tail(2 * n)) << i;
    ASSERT_TRUE(state.v.tail(2 * n).isZero(0.)) << i;
  }
  EXPECT_GT(still, 1000);
  EXPECT_GT(result.states.back().x.segment(slip, n).minCoeff(), 0.01);
  EXPECT_GT(result.forces.back().shear.cwiseAbs().maxCoeff(), 1e3);
}

TEST(FrictionalContact, MirrorsWithTheForce) {
  const int n = 6;
  BlockOnNodes block = wide_block(n);
  block.arm = 2.;
  const ContactMarch a = march_contact(block.system(triangle(3e6, 0.3)), 1.5, 2e-3);
  const ContactMarch b = march_contact(block.system(triangle(-3e6, 0.3)), 1.5, 2e-3);
  const Vector to_land = a.states.back().x.segment(slip, n), to_sea = b.states.back().x.segment(slip, n);
  EXPECT_LT((to_land + to_sea.reverse()).norm(), 1e-9 * to_land.norm());
  EXPECT_EQ(a.report.impacts, b.report.impacts);
  EXPECT_GT(a.report.open_steps, 10);
  EXPECT_GT(to_land.minCoeff(), 0.01);
}

TEST(FrictionalContact, AccountsForItsEnergy) {
  for (const double arm : {-8., 0., 2.}) {
    BlockOnNodes block = wide_block(12);
    block.arm = arm;
    const ContactMarch result = march_contact(block.system(triangle(3e6, 0.3)), 2., 2e-3);
    EXPECT_LT(result.mismatch(), 1e-12);
    EXPECT_GT(result.least_friction_step(), -1e-14);
    EXPECT_GT(result.energy.back().friction, 0.3 * result.energy.back().largest_work);
    EXPECT_EQ(result.energy.back().lifted, 0.) << "it has come down";
  }
}

// Pulled up by more than its weight and dropped: the work of the pull first becomes potential energy of the weight;
// when the block lands, impacts take the energy that springs and dashpots do not.
TEST(FrictionalContact, StoresWhatItLifts) {
  BlockOnNodes block = wide_block(4);
  block.node_mass = 0.;
  const ContactMarch result = march_contact(block.system({}, triangle(2. * block.weight, 0.3)), 4., 2e-3);
  double highest = 0., lifted = 0.;
  for (const State& state : result.states) highest = std::max(highest, state.x.tail(4).mean());
  for (const EnergyAccount& energy : result.energy) lifted = std::max(lifted, energy.lifted);
  EXPECT_GT(highest, 0.05);
  EXPECT_NEAR(lifted, block.weight * highest, 1e-12 * lifted);
  EXPECT_LT(result.mismatch(), 1e-12);
  EXPECT_EQ(result.energy.back().lifted, 0.);
  int landings = 0;
  for (std::size_t i = 1; i < result.states.size(); ++i)
    for (int j = 0; j < 4; ++j)
      landings += result.states[i - 1].x[slip + 4 + j] > 0. && result.states[i].x[slip + 4 + j] == 0.;
  EXPECT_GE(landings, 4);
  EXPECT_GE(result.report.impacts, landings);
  EXPECT_LT(result.report.impacts, 40);
}

// A block that slides, and one that rocks as well. Measured on these steps: 2.6 and 2.7.
TEST(FrictionalContact, ConvergesWithTheStep) {
  for (const double arm : {-8., 2.}) {
    const int n = 20;
    BlockOnNodes block = wide_block(n);
    block.arm = arm;
    const System system = block.system(triangle(3e6, 0.3));
    const auto S = [&](double step) { return mean_slip(march_contact(system, 1.5, step).states.back(), n); };
    const double reference = S(1.25e-4);
    const std::vector<int> steps{1, 2, 4, 8};
    std::vector<double> errors;
    for (const int k : steps) errors.push_back(std::abs(S(4e-3 / k) / reference - 1.));
    EXPECT_LT(errors[0], 1e-2);
    EXPECT_LT(errors[2], 5e-4) << "steps after an impact, too, are of order 1, or errors do not fall steadily";
    RecordProperty("order_arm_" + std::to_string(arm), std::to_string(order(steps, errors)));
    EXPECT_GT(order(steps, errors), 1.4) << arm;
  }
}

// A block on its edges: at every landing the nodes close one after the other, and few bounce.
TEST(FrictionalContact, RocksWithoutChatter) {
  const int n = 20;
  BlockOnNodes block = wide_block(n);
  block.arm = 4.;
  for (const double step : {4e-3, 2e-3, 1e-3}) {
    const ContactMarch result = march_contact(block.system(triangle(3e6, 0.3)), 4., step);
    EXPECT_GT(result.report.impacts, n / 2);
    EXPECT_LT(result.report.impacts, 4 * n) << step;
    EXPECT_TRUE(result.states.back().x.tail(n).isZero(0.)) << "it has come to rest";
  }
}

// A moving wall that is connected to the block by a spring equals a load on the block and a spring to rigid ground.
TEST(FrictionalContact, LeavesOtherPrescribedUnknownsToTheirLoads) {
  const double spring = 4e8;
  const TimeFunction velocity = triangle(0.2, 0.2);
  const System bare = wide_block(3).system({});
  const int n = bare.size();
  Eigen::PermutationMatrix<Eigen::Dynamic> last_to_fourth(n + 1);
  for (int i = 0; i < n + 1; ++i) last_to_fourth.indices()[i] = i < slip ? i : i < n ? i + 1 : slip;
  const auto widened = [&](const SparseMatrix& A, double k) {
    Eigen::MatrixXd B = Eigen::MatrixXd::Zero(n + 1, n + 1);
    B.topLeftCorner(n, n) = Eigen::MatrixXd(A);
    B(0, 0) += k;
    B(n, n) = k;
    B(0, n) = B(n, 0) = -k;
    return SparseMatrix(Eigen::MatrixXd(last_to_fourth * B * last_to_fourth.transpose()).sparseView());
  };
  System walled = bare;
  walled.M = widened(bare.M, 0.);
  walled.C = widened(bare.C, 0.);
  walled.K = widened(bare.K, spring);
  walled.field.push_back(Field::displacement);
  ++walled.n_prescribed;
  walled.loads = {{"wall", Vector::Zero(n + 1), velocity, slip}};
  System loaded = bare;
  loaded.K.coeffRef(0, 0) += spring;
  const auto wall = [=](double t) { return t < 0.1 ? t * t : t < 0.2 ? 0.02 - std::pow(0.2 - t, 2) : 0.02; };
  loaded.loads = {{"push", spring * Vector::Unit(n, 0),
                   TimeFunction({0., 0.1, 0.2}, {[](double) { return 0.; }, wall, wall, wall}), -1}};
  const ContactMarch a = march_contact(walled, 1., 5e-4), b = march_contact(loaded, 1., 5e-4);
  EXPECT_GT(a.report.slip_steps, 10);
  EXPECT_LT((a.states.back().x.tail(6) - b.states.back().x.tail(6)).norm(), 1e-4 * b.states.back().x.tail(6).norm());
  EXPECT_LT(a.mismatch(), 1e-12);
}

TEST(FrictionalContact, StartsAnew) {
  const System system = wide_block(5).system(triangle(3e6, 0.3));
  const auto scheme = make_contact_scheme(system);
  const TimeGrid grid = make_time_grid(kinks(system), 1., 4e-3);
  const State first = march(system, *scheme, grid).final_state;
  const ContactReport report = *scheme->contact();
  EXPECT_EQ(march(system, *scheme, grid).final_state.x, first.x);
  EXPECT_EQ(scheme->contact()->slip_steps, report.slip_steps);
  EXPECT_EQ(scheme->contact()->forces.shear, report.forces.shear);
  EXPECT_EQ(make_scheme(system)->contact(), nullptr);
}

// Four steps at once while no node slips or opens: of order 4, so that the result is the same to the error of the
// scheme; no motion is missed, no state breaks the law, and a failed leap is undone completely, also in the balance
// of energy.
TEST(FrictionalContact, LeapsWhereNothingMoves) {
  const int n = 9;
  for (const double arm : {0., 2.}) {
    BlockOnNodes block = wide_block(n);
    block.arm = arm;
    const System system = block.system(triangle(3e6, 0.3));
    const ContactMarch steps = march_contact(system, 3., 2e-3), leaps = march_contact(system, 3., 2e-3, 4);
    const Vector there = steps.states.back().x.segment(slip, n), found = leaps.states.back().x.segment(slip, n);
    EXPECT_LT(leaps.states.size(), 0.6 * steps.states.size());
    EXPECT_LT(leaps.n_solves, 0.7 * steps.n_solves);
    EXPECT_EQ(leaps.n_factorisations, 2);
    EXPECT_NEAR(leaps.moving_steps.back(), steps.moving_steps.back(), 2);
    EXPECT_LT((found - there).norm(), 2e-3 * there.norm());
    EXPECT_LT(leaps.mismatch(), 1e-12);
    EXPECT_GT(leaps.least_friction_step(), -1e-14);
    for (std::size_t i = 1; i < leaps.states.size(); ++i) {
      const InterfaceForces& forces = leaps.forces[i];
      ASSERT_TRUE((forces.shear.array().abs() <= block.friction * forces.normal.array() + 1e-9 * block.weight).all());
      if (leaps.states[i].time - leaps.states[i - 1].time < 4e-3) continue;
      ASSERT_EQ(leaps.states[i].x.tail(2 * n), leaps.states[i - 1].x.tail(2 * n)) << i;
    }
  }
}

TEST(FrictionalContact, RefusesASystemWithoutInterface) {
  EXPECT_THROW(make_contact_scheme(oscillator(1., 0., 1., {})), std::invalid_argument);
}

}  // namespace contact_scheme_test
