// Claim: numbers that soils, water, caissons, waves and loads have in practice pass in silence; a number in a unit that
// was mistaken is told, with the unit that was meant.
#include "model/quantities.h"

#include <gtest/gtest.h>

#include <limits>

namespace upbead {
namespace quantities_test {

namespace q = quantities;

struct Mistaken {
  const Quantity* quantity;
  double right;       ///< in SI
  double given;       ///< in the other unit
  const char* meant;  ///< "in MPa"
};

const std::vector<Mistaken> rows{
    {&q::modulus, 4.9e7, 49., "in MPa"},
    {&q::density, 2100., 2.1, "in t/m3"},
    {&q::density, 2100., 20.6, "in kN/m3"},
    {&q::grain_density, 2650., 2.65, "in t/m3"},
    {&q::water_density, 1030., 1.03, "in t/m3"},
    {&q::water_modulus, 2.2e9, 2.2, "in GPa"},
    {&q::water_modulus, 2.2e9, 2.2e6, "in kPa"},
    {&q::grain_modulus, 3.6e10, 36., "in GPa"},
    {&q::viscosity, 1.07e-3, 1.07, "in mPa s"},
    {&q::viscosity, 1.07e-3, 1.07e-6, "in m2/s"},
    {&q::atmosphere, 101325., 101.3, "in kPa"},
    {&q::stress_scale, 98e3, 98., "in kPa"},
    {&q::darcy_conductivity, 1e-4, 8.64, "in m/day"},
    {&q::darcy_conductivity, 0.2, 20., "in cm/s"},
    {&q::permeability, 1e-11, 10., "in darcy"},
    {&q::porosity_of_coarse, 0.4, 0.95, "in void ratio"},
    {&q::porosity_of_coarse, 0.4, 0.7, "in void ratio"},
    {&q::damping, 0.05, 0.5, "in percent"},
    {&q::reference_strain, 5e-4, 0.05, "in percent"},
    {&q::friction, 0.6, 31., "in degrees"},
    {&q::friction, 0.6, 60., "in percent"},
    {&q::friction_angle, 35., 0.61, "in radians"},
    {&q::cohesion, 2e4, 20., "in kPa"},
    {&q::surcharge, 2e4, 20., "in kPa"},
    {&q::sliding_limit, 0.3, 30., "in cm"},
    {&q::pressure_limit, 6e5, 600., "in kPa"},
    {&q::load_duration, 0.15, 150., "in ms"},
    {&q::wave_height, 8., 800., "in cm"},
    {&q::wave_period, 12., 12000., "in ms"},
    {&q::wave_angle, 15., 0.26, "in radians"},
    {&q::depth, 15., 1500., "in cm"},
    {&q::depth, 15., 15000., "in mm"},
    {&q::bed_slope, 0.02, 50., "in 1 : n"},
    {&q::bed_slope, 0.01, 1., "in percent"},
    {&q::storm_duration, 10800., 3., "in hours"},
    {&q::storm_duration, 10800., 180., "in minutes"},
    {&q::level, 1.5, 150., "in cm"},
    {&q::stiffness, 1e8, 1e5, "in kPa"},
    {&q::gravity, 9.81, 9810., "in mm/s2"},
    {&q::gravity, 9.81, 1., "in g"},
    {&q::velocity, 0.3, 30., "in cm/s"},
};

TEST(Quantities, AreSilentInSIAndTellTheUnitThatWasMeant) {
  for (const Mistaken& row : rows) {
    EXPECT_FALSE(implausible("key", row.right, *row.quantity)) << row.right << " " << row.quantity->unit;
    const auto told = implausible("key", row.given, *row.quantity);
    ASSERT_TRUE(told) << row.given << " " << row.meant;
    EXPECT_EQ(told->name, "implausible");
    EXPECT_NE(told->text().find(row.meant), std::string::npos) << told->text();
    EXPECT_EQ(told->value, row.given);
  }
}

TEST(Quantities, OfModelsAndCentrifugesPassToo) {
  // a 1/20 model at 1 g, and a 1/100 model at 100 g with a pore fluid a hundred times as viscous
  EXPECT_FALSE(implausible("k", 4e7 / 20, q::modulus));
  EXPECT_FALSE(implausible("k", 8. / 20, q::wave_height));
  EXPECT_FALSE(implausible("k", 0.15 / 4.5, q::load_duration));
  EXPECT_FALSE(implausible("k", 0.75, q::depth));
  EXPECT_FALSE(implausible("k", 981., q::gravity)) << "the mesh tells whether it is cm/s2";
  EXPECT_FALSE(implausible("k", 0.107, q::viscosity));
  EXPECT_FALSE(implausible("k", 0.15 / 100, q::load_duration));
}

TEST(Quantities, ZeroAndInfinityAreNoUnit) {
  EXPECT_FALSE(implausible("k", 0., q::damping));
  EXPECT_FALSE(implausible("k", std::numeric_limits<double>::infinity(), q::water_modulus));
  const auto told = implausible("regions.sand.porosity", 0.01, q::porosity_of_soil);
  ASSERT_TRUE(told);
  EXPECT_EQ(told->text().find("if it was meant"), std::string::npos) << "no unit makes it one";
  EXPECT_EQ(told->limit, 0.15);
}

}  // namespace quantities_test
}  // namespace upbead
