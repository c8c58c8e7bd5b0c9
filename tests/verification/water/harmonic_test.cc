// Claims: compressible water in front of a wall that moves harmonically gives the exact complex force at every
// frequency. Below the cut-off frequency of the first mode, where no wave is radiated, it is that of the endless
// reservoir; above it, that of a reservoir whose far end absorbs plane waves of normal incidence, which checks the
// absorbing side against its closed form at a finite length.
// Source: tests/reference/ref6_water.json, `harmonic`, and modal_force in reservoir.cc, which is compared with the
// table. Limit: 0.5 % of the force.

#include <gtest/gtest.h>

#include <cmath>

#include "reservoir.h"

namespace upbead::test {
namespace harmonic_test {

using Complex = std::complex<double>;

struct Sea {
  double h = 0., rho = 0., c = 0.;
  explicit Sea(const Json& table) : h(table.at("h")), rho(table.at("rho")), c(table.at("c")) {}
};

Complex computed(const Sea& sea, double depths, double omega, PressureCondition far) {
  ReservoirShape shape;
  shape.depth = sea.h;
  shape.length = depths * sea.h;
  shape.cells = 10;
  shape.far = far;
  const System water = Reservoir(shape, {sea.rho, sea.rho * sea.c * sea.c}).water(triangle(1., 1.));
  return per_acceleration(water, omega, "force") / (sea.rho * sea.h * sea.h);
}

Complex of_table(const Json& row) {
  return {row.at("F_over_rho_a_h2_re").get<double>(), row.at("F_over_rho_a_h2_im").get<double>()};
}

double relative(const Complex& found, const Complex& exact) {
  return std::abs(found - exact) / std::abs(exact);
}

/// Largest error of the force in a reservoir of 3 h, over the force in the endless reservoir, as the force in a
/// closed or open reservoir vanishes at some frequencies.
double largest_error_in_three_depths(const Json& table, PressureCondition far) {
  const Sea sea(table);
  double worst = 0.;
  for (const Json& row : table.at("rows")) {
    const double omega = row.at("omega");
    const Complex found = computed(sea, 3., omega, far), exact = modal_force(sea.h, 3. * sea.h, sea.c, omega, far);
    worst = std::max(worst, std::abs(found - exact) / std::abs(of_table(row)));
  }
  return worst;
}

std::string title(const Json& row) {
  return "omega = " + row.at("omega_over_omega1").dump() + " omega1: ";
}

TEST(HarmonicWall, BelowTheCutOffAsInTheTable) {
  Record record("water_harmonic");
  const Json table = reference("ref6_water").at("harmonic").at(0);
  const Sea sea(table);
  for (const Json& row : table.at("rows")) {
    if (row.at("omega_over_omega1") > 1.) continue;
    const Complex found = computed(sea, 10., row.at("omega"), PressureCondition::sealed);
    record.at_most(title(row) + "force, reservoir closed at 10 h against the endless one",
                   relative(found, of_table(row)), 5e-3);
  }
}

TEST(HarmonicWall, EveryFarEndAsInClosedForm) {
  Record record("water_harmonic");
  const Json table = reference("ref6_water").at("harmonic").at(0);
  const std::vector<std::pair<PressureCondition, std::string>> ends{{PressureCondition::sealed, "closed"},
                                                                    {PressureCondition::open, "open"},
                                                                    {PressureCondition::absorbing, "absorbing"}};
  for (const auto& [far, name] : ends)
    record.at_most("reservoir of 3 h, " + name +
                       " at its end: largest error of the complex force at ten frequencies, over "
                       "the force without end",
                   largest_error_in_three_depths(table, far), 5e-3);
}

TEST(HarmonicWall, RadiatesThroughTheAbsorbingEnd) {
  Record record("water_harmonic");
  const Json table = reference("ref6_water").at("harmonic").at(0);
  const Sea sea(table);
  for (const Json& row : table.at("rows")) {
    const Complex exact = of_table(row);
    record.at_most(title(row) + "the modal sum of the tests against the table",
                   relative(modal_force(sea.h, 0., sea.c, row.at("omega"), PressureCondition::sealed), exact), 1e-6);
    if (row.at("omega_over_omega1") < 1.) continue;
    record.measured(title(row) + "force with an absorbing end at 3 h against the endless reservoir",
                    relative(computed(sea, 3., row.at("omega"), PressureCondition::absorbing), exact));
  }
}

}  // namespace harmonic_test
}  // namespace upbead::test
