// Claim: output of CFD programs is read as these write it: the four layouts of OpenFOAM's forces, and the tables of
// DualSPHysics and SWASH for one flow, give equal numbers; restarts are joined; what the files do not state is asked
// for by its key.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "case/cfd/flow_keys.h"
#include "case/cfd/flow_record.h"
#include "upbead/base/error.h"

namespace upbead::test {

namespace flow_test {

const std::string samples = UPBEAD_FLOWS, bore = UPBEAD_BORE;

FlowLoad load_of(const std::string& path, const std::string& file, const std::vector<std::string>& keys,
                 const FlowKeys& source) {
  const Document document(keys);
  FlowContext context{"", &document};
  context.beyond_given = {true, true};
  context.base = "";
  return understand(read_flow(path, file, {}), source, context);
}

/// The keys of the bore: x landward, z up, 0.1 m thick, still until 0.3 s.
FlowKeys bore_keys() {
  FlowKeys source;
  source.landward = FlowAxis::plus_x;
  source.up = FlowAxis::plus_z;
  source.origin = {-3.2, 0.};
  source.thickness = 0.1;
  source.still_time = {0., 0.3};
  return source;
}

FlowKeys pressure_keys(FlowQuantity quantity) {
  FlowKeys source = bore_keys();
  source.thickness.reset();
  source.quantity = quantity;
  return source;
}

double value_at(const std::vector<double>& time, const std::vector<double>& value, double t) {
  for (std::size_t i = 0; i < time.size(); ++i)
    if (std::abs(time[i] - t) < 1e-9) return value[i];
  throw std::out_of_range("no such time");
}

std::string refusal(const std::string& path, const FlowKeys& source, const std::string& file = "") {
  try {
    load_of(path, file, {}, source);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Flow, ForcesOfTheBoreAreThoseOfItsCheckNumbers) {
  const FlowRecord record = read_flow(bore + "/forces", "", {});
  ASSERT_TRUE(record.forces);
  EXPECT_EQ(record.forces->centre, (Triple{3.4, 0.05, 0.1}));
  const std::vector<std::array<double, 3>> expected{
      {0.05, 12.4010, 0.6397}, {0.95, 35.3951, 2.9727}, {1.1, 99.0939, 16.5734}, {2., 53.8900, 5.8910}};
  for (const auto& [t, force, moment] : expected) {
    std::vector<double> x, y;
    for (std::size_t i = 0; i < record.forces->time.size(); ++i) {
      x.push_back(record.forces->force[i][0]);
      y.push_back(record.forces->moment[i][1]);
    }
    constexpr double friction = 1e-4;  // relative; the expected numbers are of the pressure without shear stresses
    EXPECT_NEAR(value_at(record.forces->time, x, t), force, friction * force);
    EXPECT_NEAR(value_at(record.forces->time, y, t), moment, friction * moment);
  }
  EXPECT_EQ(record.forces->time.size(), 40U);
}

TEST(Flow, PatchSumsAreTheForcesToRoundOff) {
  const FlowLoad patch = load_of(bore + "/patch", "p_front.raw", {}, pressure_keys(FlowQuantity::pressure));
  const FlowLoad force = load_of(bore + "/forces", "", {}, bore_keys());
  EXPECT_NEAR(patch.peak_force, 866.93, 0.01);
  EXPECT_NEAR(force.peak_force, 866.93, 0.01);
  EXPECT_NEAR(*force.peak_arm, (16.5734 - 0.6397) / 86.693, 2e-4);
  EXPECT_NEAR(*patch.peak_arm, *force.peak_arm, 1e-3 * *force.peak_arm);
  EXPECT_DOUBLE_EQ(patch.peak_time, 1.1);
}

TEST(Flow, PressureLessItsWeightIsThePressureWithinWhatIsTold) {
  FlowKeys less = pressure_keys(FlowQuantity::pressure_less_weight);
  less.flow_density = 1000.;
  less.datum = 0.;
  const FlowLoad by_less = load_of(bore + "/patch", "p_rgh_front.raw", {}, less);
  const FlowLoad by_p = load_of(bore + "/patch", "p_front.raw", {}, pressure_keys(FlowQuantity::pressure));
  ASSERT_EQ(by_less.warnings.size(), 1U) << "the bore is full of air above still water";
  EXPECT_EQ(by_less.warnings[0].name, "flow_p_rgh");
  EXPECT_GE(by_p.peak_force, by_less.peak_force);
  EXPECT_LE(by_p.peak_force, by_less.peak_force * (1. + by_less.warnings[0].value));
  const std::vector<double>& low = by_less.pressure->pressure[1];  // well below still water both pressures are equal
  for (std::size_t t = 0; t < low.size(); ++t)
    EXPECT_NEAR(low[t], by_p.pressure->pressure[1][t], 2e-3 * by_p.pressure->pressure[1][9]) << t;
}

TEST(Flow, FourLayoutsGiveEqualNumbers) {
  const FlowRecord first = read_flow(samples + "/esi_parentheses", "", {});
  for (const char* layout : {"esi_plain", "foundation", "foundation_porous"}) {
    const FlowRecord other = read_flow(samples + "/" + layout, "", {});
    EXPECT_EQ(other.forces->time, first.forces->time) << layout;
    EXPECT_EQ(other.forces->centre, first.forces->centre) << layout;
    for (std::size_t i = 0; i < first.forces->time.size(); ++i) {
      EXPECT_NEAR(other.forces->force[i][0], first.forces->force[i][0], 1e-6 * first.forces->force[i][0]) << layout;
      EXPECT_NEAR(other.forces->moment[i][1], first.forces->moment[i][1], 1e-6 * first.forces->moment[i][1]) << layout;
    }
  }
}

TEST(Flow, TheLaterStartWinsFromItsFirstTimeOn) {
  const FlowRecord joined = read_flow(samples + "/foundation", "", {});
  const FlowRecord first = read_flow(samples + "/foundation/0/forces.dat", "", {});
  const FlowRecord second = read_flow(samples + "/foundation/0.8/forces.dat", "", {});
  const double start = second.forces->time.front();
  EXPECT_GT(first.forces->time.back(), start);
  std::vector<double> time;
  for (const double t : first.forces->time)
    if (t < start) time.push_back(t);
  time.insert(time.end(), second.forces->time.begin(), second.forces->time.end());
  EXPECT_EQ(joined.forces->time, time);
}

TEST(Flow, TimesThatRepeatAreTold) {
  const FlowRecord late = read_flow(samples + "/late_start", "", {});
  EXPECT_NE(text_of(late).find("repeat the time"), std::string::npos);
  for (std::size_t i = 1; i < late.time().size(); ++i) EXPECT_GT(late.time()[i], late.time()[i - 1]);
}

TEST(Flow, SecondRunOfTheSameStartIsTakenWhereItSaysTheSame) {
  const FlowRecord same = read_flow(samples + "/same_start", "", {});
  EXPECT_EQ(same.time().size(), 24U);
  EXPECT_NE(text_of(same).find("says the same"), std::string::npos);
}

TEST(Flow, DualSphysicsTablesAreThoseOfOpenFoam) {
  const FlowRecord semicolon = read_flow(samples + "/dualsphysics/PointsPress_semicolon.csv", "", {});
  const FlowRecord comma = read_flow(samples + "/dualsphysics/PointsPress_comma.csv", "", {});
  const FlowRecord probes = read_flow(bore + "/probes", "p", {});
  EXPECT_EQ(semicolon.points->rows.time, probes.points->rows.time);
  EXPECT_EQ(semicolon.points->rows.value, probes.points->rows.value);
  EXPECT_EQ(comma.points->rows.value, probes.points->rows.value);
  EXPECT_EQ(semicolon.points->at, probes.points->at);
  EXPECT_EQ(probes.points->at.size(), 5U) << "the sixth lies outside the mesh";
  EXPECT_NE(text_of(probes).find("Not Found"), std::string::npos);
  const FlowRecord gauge = read_flow(samples + "/dualsphysics/GaugesForce_Wall.csv", "", {});
  EXPECT_TRUE(gauge.forces && gauge.forces->moment.empty());
  EXPECT_DOUBLE_EQ(gauge.forces->force[0][0], 12.40048);
}

TEST(Flow, SwashTableHasTheTimesOfItsInput) {
  const FlowRecord table = read_flow(samples + "/swash/wall.tbl", "", {});
  ASSERT_TRUE(table.level);
  EXPECT_EQ(table.time().size(), 40U);
  EXPECT_DOUBLE_EQ(table.time().front(), 0.05);
  EXPECT_NEAR(table.time().back(), 2., 1e-12);
  FlowKeys source;
  source.quantity = FlowQuantity::hydrostatic;
  source.flow_density = 1000.;
  source.origin = {-3.2, 0.26};
  const FlowLoad load = load_of(samples + "/swash/wall.tbl", "", {}, source);
  double deepest = 0.;
  for (const double depth : table.level->depth) deepest = std::max(deepest, depth);
  EXPECT_NEAR(load.peak_force, 0.5 * 9810. * (deepest * deepest - 0.16 * 0.16), 1e-6);
  EXPECT_NEAR(load.force->centre[1], 0.1, 1e-12);
}

TEST(Flow, WhatTheFilesDoNotTellIsAskedForAllAtOnce) {
  const std::string forces = refusal(bore + "/forces", {});
  for (const char* key : {"'landward'", "'up'", "'origin'", "'thickness'", "'still_time'", "\"-x\""})
    EXPECT_NE(forces.find(key), std::string::npos) << key << " in " << forces;
  const std::string patch = refusal(bore + "/patch", {}, "p_front.raw");
  for (const char* key : {"'landward'", "'quantity'", "'origin'", "\"p_rgh\""})
    EXPECT_NE(patch.find(key), std::string::npos) << key << " in " << patch;
  EXPECT_NE(refusal(bore + "/patch", {}).find("add file = one of: p_front.raw, p_rgh_front.raw"), std::string::npos);
  EXPECT_NE(refusal(bore + "/patch", pressure_keys(FlowQuantity::pressure), "p_rgh_front.raw").find("another quantity"),
            std::string::npos);
  EXPECT_NE(refusal(bore, {}).find("name one of its folders: forces, patch, probes"), std::string::npos);
}

TEST(Flow, NewtonsAreToldWithTheirThickness) {
  const FlowLoad load = load_of(bore + "/forces", "", {}, bore_keys());
  EXPECT_NE(text_of("wall", load).find("99.09 N over a thickness of 0.1 m along y: 990.9 N/m"), std::string::npos)
      << text_of("wall", load);
}

TEST(Flow, AnyAxesGiveTheSameLoad) {
  const FlowLoad plain = load_of(bore + "/forces", "", {}, bore_keys());
  std::filesystem::create_directories("turned/0");
  std::ofstream force("turned/0/force.dat"), moment("turned/0/moment.dat");
  const char* head = "(total_x total_y total_z) (pressure_x pressure_y pressure_z) (viscous_x viscous_y viscous_z)\n";
  force << "# Force\n# CofR : (-0.05 0.1 -3.4)\n# Time " << head;
  moment << "# Moment\n# CofR : (-0.05 0.1 -3.4)\n# Time " << head;
  force.precision(12), moment.precision(12);
  const FlowRecord record = read_flow(bore + "/forces", "", {});
  for (std::size_t i = 0; i < record.forces->time.size(); ++i) {  // landward -z, up y: across = y x (-z) = -x
    const double t = record.forces->time[i], f = record.forces->force[i][0], m = record.forces->moment[i][1];
    force << t << " (0 0 " << -f << ") (0 0 " << -f << ") (0 0 0)\n";
    moment << t << " (" << -m << " 0 0) (" << -m << " 0 0) (0 0 0)\n";
  }
  force.close(), moment.close();
  FlowKeys source = bore_keys();
  source.landward = FlowAxis::minus_z;
  source.up = FlowAxis::plus_y;
  const FlowLoad turned = load_of("turned", "", {}, source);
  EXPECT_NEAR(turned.peak_force, plain.peak_force, 1e-9 * plain.peak_force);
  EXPECT_NEAR(*turned.peak_arm, *plain.peak_arm, 1e-9);
  EXPECT_NEAR(turned.force->centre[0], plain.force->centre[0], 1e-12);
  std::filesystem::remove_all("turned");
}

}  // namespace flow_test
}  // namespace upbead::test
