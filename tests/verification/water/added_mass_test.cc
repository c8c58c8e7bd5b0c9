// Claims: incompressible water in front of a rigid wall that accelerates gives the force, the moment and the pressure
// over the depth of the exact series, in reservoirs of any length, closed or open at their far end; 8 cells over the
// depth are enough for 0.1 %, and a closed end at three depths changes the force by 1.5e-4.
// Source: tests/reference/ref6_water.json, `added_mass` (series, checked against 14 zeta(3)/pi^3 rho h^2).
// Limits: 0.1 % of force and moment at 8 and 10 cells; pressures 0.5 % of the largest.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "reservoir.h"

namespace upbead::test {
namespace added_mass_test {

constexpr double infinity = std::numeric_limits<double>::infinity();

double read(const System& water, const std::string& reading) {
  return per_acceleration(water, 0., reading).real();
}

/// Force per unit of acceleration, in kg/m.
double added_mass(const ReservoirShape& shape, double density) {
  return read(Reservoir(shape, {density, infinity}).water(triangle(1., 1.)), "force");
}

std::string title(const Json& entry, int cells) {
  const std::string length = entry.contains("L")
                                 ? "L = " + Json(entry.at("L").get<double>() / entry.at("h").get<double>()).dump() +
                                       " h, " + (entry.at("far") == "p0" ? "p = 0" : "rigid") + " at its end"
                                 : "without end (closed at 6 h)";
  return length + ", " + std::to_string(cells) + " cells over the depth";
}

/// Compares one entry of the table on one mesh: force, lever arm, pressures. Returns the pressures for a figure.
std::vector<double> compare(Record& record, const Json& entry, int cells) {
  ReservoirShape shape;
  shape.depth = entry.at("h");
  shape.length = entry.value("L", 6. * shape.depth);
  shape.cells = cells;
  if (entry.value("far", "rigid") == "p0") shape.far = PressureCondition::open;
  const Reservoir reservoir(shape, incompressible_water(entry), entry.at("y"));
  const System water = reservoir.water(triangle(1., 1.));
  const double force = entry.at("added_mass"), arm = entry.at("lever_arm_over_h").get<double>() * shape.depth;
  record.at_most(title(entry, cells) + ": added mass", std::abs(read(water, "force") / force - 1.), 1e-3);
  record.at_most(title(entry, cells) + ": lever arm", std::abs(read(water, "moment") / read(water, "force") / arm - 1.),
                 1e-3);
  std::vector<double> pressures;
  for (std::size_t i = 0; i < entry.at("y").size(); ++i)
    pressures.push_back(read(water, "probes/y" + std::to_string(i) + "/pressure"));
  record.at_most(title(entry, cells) + ": pressure at five heights, over the largest",
                 largest_error(pressures, entry.at("p_over_acc")), 5e-3);
  return pressures;
}

TEST(AddedMass, ForceArmAndPressureOfAllReservoirs) {
  Record record("water_added_mass");
  const Json entries = reference("ref6_water").at("added_mass");
  for (const Json& entry : entries)
    for (const int cells : {8, 10}) {
      const std::vector<double> found = compare(record, entry, cells);
      if (cells == 10 && entry.value("L", 0.) < 20.)
        record.curve({"pressure on an accelerated wall, incompressible water", "height above the bottom (m)",
                      "pressure over acceleration (kg/m2)", title(entry, cells), entry.at("y"), entry.at("p_over_acc"),
                      found});
    }
}

TEST(AddedMass, ConvergesWithTheCells) {
  Record record("water_added_mass");
  const Json entry = reference("ref6_water").at("added_mass").at(3);  // closed at 3 h
  for (const int degree : {2, 3}) {
    std::vector<double> sizes, errors;
    for (const int cells : {4, 8, 16}) {
      ReservoirShape shape;
      shape.depth = entry.at("h");
      shape.length = entry.at("L");
      shape.cells = cells;
      shape.degree = degree;
      const double exact = entry.at("rho").get<double>() * shape.depth * shape.depth *
                           modal_force(shape.depth, shape.length, infinity, 0., PressureCondition::sealed).real();
      sizes.push_back(1. / cells);
      errors.push_back(std::abs(added_mass(shape, entry.at("rho")) / exact - 1.));
      record.measured("phi of degree " + std::to_string(degree) + ", " + std::to_string(cells) +
                          " cells over the depth: relative error of the added mass",
                      errors.back());
    }
    // At the level on the wall the pressure is like s log s, so no degree has an order above 2.
    record.at_least("order of the added mass, phi of degree " + std::to_string(degree), order(sizes, errors), 1.9);
  }
}

TEST(AddedMass, ClosingTheSeaThreeDepthsOffCostsLittle) {
  Record record("water_added_mass");
  const auto closed_at = [](double depths) {
    ReservoirShape shape;
    shape.length = depths * shape.depth;
    return added_mass(shape, 1025.);
  };
  const double far = closed_at(6.), three = closed_at(3.) / far - 1., four = closed_at(4.) / far - 1.;
  const auto exact = [](double depths) {
    return modal_force(1., depths, infinity, 0., PressureCondition::sealed).real();
  };
  record.at_most("closed at 3 h: change of the added mass from 6 h on the same cells", std::abs(three), 1.6e-4);
  record.at_most("closed at 3 h: this change against that of the series",
                 std::abs(three - (exact(3.) / exact(6.) - 1.)), 2e-6);
  record.at_most("closed at 4 h: the change, over that of 3 h", std::abs(four / three), 0.1);
}

}  // namespace added_mass_test
}  // namespace upbead::test
