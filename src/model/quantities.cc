#include "model/quantities.h"

#include <cmath>

#include "base/numbers.h"
#include "base/text.h"

namespace upbead {

std::string cure_of_unit(const MeantUnit& unit, double meant) {
  return "if it was meant in " + std::string(unit.name) + ", write " + significant(meant, 4);
}

Quantity of(Quantity share, double whole, const char* unit, const char* usual, std::vector<MeantUnit> meant) {
  for (double* bound : {&share.low, &share.high, &share.common_low, &share.common_high}) *bound *= whole;
  if (!meant.empty()) share.meant = std::move(meant);
  share.unit = unit;
  share.usual = usual;
  return share;
}

std::optional<NumberedWarning> implausible(const std::string& key, double value, const Quantity& q) {
  if (value == 0. || !std::isfinite(value) || (value >= q.low && value <= q.high)) return std::nullopt;
  const double limit = value < q.low ? q.low : q.high;
  std::string text =
      key + " = " + significant(value, 4) + (q.unit == std::string("1") ? "" : " " + std::string(q.unit));
  text += value < q.low ? " is less than is ever found (" : " is more than is ever found (";
  text += significant(limit) + (*q.usual != '\0' ? "; " + std::string(q.usual) : "") + ")";
  std::string cure;
  for (const MeantUnit& unit : q.meant)
    if (const double meant = unit.in_si(value); meant >= q.common_low && meant <= q.common_high) {
      if (!cure.empty() && !q.tells_all) break;
      cure += cure.empty() ? cure_of_unit(unit, meant)
                           : ", in " + std::string(unit.name) + ", write " + significant(meant, 4);
    }
  if (cure.empty()) cure = "check " + key + " and its unit";
  return NumberedWarning{"implausible", value, limit, q.unit, text, cure, true};
}

bool is_unit_load(double value) {
  const double exponent = std::log10(value);
  return std::abs(exponent - std::round(exponent)) < 1e-9;
}

void judge(const std::string& key, const std::optional<double>& value, const Quantity& quantity,
           NumberedWarnings& list) {
  if (!value) return;
  if (auto warning = implausible(key, *value, quantity)) list.push_back(std::move(*warning));
}

namespace quantities {

namespace {
constexpr double g = 9.81;
const std::vector<MeantUnit> pascals{{"kPa", 1e3}, {"MPa", 1e6}, {"GPa", 1e9}};
const std::vector<MeantUnit> of_weight{{"t/m3", 1e3}, {"kN/m3", 1e3 / g}};
const std::vector<MeantUnit> percents{{"percent", 1e-2}};
const std::vector<MeantUnit> lengths{{"cm", 1e-2}, {"mm", 1e-3}};
const std::vector<MeantUnit> durations{{"ms", 1e-3}};

double pores_of_void_ratio(double e) {
  return e / (1. + e);
}
double tangent_of_degrees(double angle) {
  return std::tan(angle * pi / 180.);
}
double inverse(double value) {
  return 1. / value;
}
}  // namespace

// From mud (G_max 1e5 to 1e6) to steel (8e10). Sand and gravel under 10 to 500 kPa: Hardin and Richart (1963), Seed and
// Idriss (1970), 1e7 to 3e8.
const Quantity modulus{"Pa", 1e5, 1e12, 1e6, 3e11, pascals, "sand has 1e7 to 3e8"};
// Concrete and its fill, steel; cells smeared over a section, timber.
const Quantity caisson_modulus{"Pa", 1e8, 1e12, 5e9, 3e11, pascals, "concrete has 3e10"};
// As a share of the weight of the soil above its base, rho' g H: G_max/sigma' of clays is 100 and more, of sands 500
// and more (Hardin and Black 1968); secant moduli at failure are ten times sigma'.
const Quantity soil_modulus{"Pa", 1e4, 1e12, 1e6, 3e9, pascals, "sand has 1e7 to 3e8"};
// Light fills (cellular concrete 400, wood 500) to steel 7850 and lead 11,300.
const Quantity density{"kg/m3", 400., 2e4, 1e3, 8e3, of_weight, "caissons with fill have 1800 to 2400"};
// Coal, light aggregates to iron ore; quartz 2650: Lambe and Whitman (1969), table 3.1. Soils have less in bulk.
const Quantity grain_density{"kg/m3", 1700., 8e3, 2e3, 5e3, of_weight, "quartz has 2650"};
// Fresh water 998, sea water 1020 to 1030, brine up to 1300.
const Quantity water_density{"kg/m3", 900., 1300., 990., 1050., of_weight, "sea water has 1030"};
// 2.2e9; with some percent of air 1e7 (Verruijt 1969), for which there is `saturation`.
const Quantity water_modulus{"Pa", 5e6, 1e10, 1e9, 3e9, pascals, "water has 2.2e9"};
// Quartz 3.7e10, calcite 7e10, clay minerals from 1e9: Mavko, Mukerji and Dvorkin (2009), appendix.
const Quantity grain_modulus{"Pa", 1e8, 1e12, 5e9, 2e11, pascals, "quartz has 3.7e10"};
// Water 0 to 40 C: 1.8e-3 to 0.65e-3; pore fluids of centrifuges, a hundred times as much (Stewart et al. 1998).
const Quantity viscosity{
    "Pa s", 2e-4, 0.6, 5e-4, 2e-3, {{"mPa s (cP)", 1e-3}, {"m2/s, the kinematic one", 1e3}}, "water has 1e-3"};
const Quantity atmosphere{"Pa", 3e4, 2e5, 8e4, 1.1e5, {{"kPa", 1e3}, {"hPa", 1e2}, {"bar", 1e5}}};
// Mean effective stress of a reference modulus: usually 98 or 100 kPa, of models a hundredth.
const Quantity stress_scale{"Pa", 500., 1e7, 1e4, 1e6, pascals};
// Clay 1e-11 to gravel 1: Lambe and Whitman (1969), fig. 19.5; rock armour, linearised, more.
const Quantity conductivity{"m/s",
                            1e-13,
                            10.,
                            1e-12,
                            0.5,
                            {{"cm/s", 1e-2}, {"m/day", 1. / 86400.}, {"mm/s", 1e-3}},
                            "sand has 1e-5 to 1e-3, rubble 0.01 to 1",
                            true};
const Quantity darcy_conductivity{"m/s", 1e-13, 2., 1e-12, 0.5, conductivity.meant, conductivity.usual, true};
const Quantity permeability{"m2", 1e-20, 1e-6, 1e-19, 5e-8, {{"darcy", 9.87e-13}, {"cm2", 1e-4}}};
// Soils 0.2 (well graded) to 0.9 (mud, peat); sands 0.3 to 0.5, rubble and armour 0.35 to 0.6: Lambe and Whitman
// (1969), table 3.2; The Rock Manual (2007), table 3.11. Rock has less than soils.
const char* const pores =
    "sand has 0.3 to 0.5, rubble 0.35 to 0.5; it is a share of 1, not the void ratio e, n = e/(1 + e)";
const Quantity porosity_of_soil{"1", 0.15, 0.9, 0.25, 0.65, {{"void ratio", 0., pores_of_void_ratio}}, pores};
const Quantity porosity_of_coarse{"1", 0.15, 0.65, 0.25, 0.6, {{"void ratio", 0., pores_of_void_ratio}}, pores};
const Quantity porosity{"1", 1e-3, 0.9, 0.25, 0.65, {{"void ratio", 0., pores_of_void_ratio}}, pores};
// Soils at 1 % of shear strain come to 0.25 to 0.3: Seed and Idriss (1970); Vucetic and Dobry (1991).
const Quantity damping{"1", 1e-5, 0.35, 5e-3, 0.3, percents, "soils have 0.01 to 0.25; 5 percent are 0.05"};
const Quantity reference_strain{"1", 1e-6, 0.02, 1e-5, 0.01, percents, "sand has 2e-4 to 1e-3"};
// Volumetric threshold of sands 1e-4 to 2e-4, of plastic soils up to 1e-3: Vucetic (1994).
const Quantity threshold_strain{"1", 1e-7, 2e-3, 1e-6, 1e-3, percents, "sand has about 1e-4"};
const Quantity smallest_damping{"1", 1e-5, 0.1, 1e-3, 0.06, percents, "soils have 0.005 to 0.05"};
const Quantity largest_damping{"1", 1e-5, 0.45, 0.05, 0.35, percents, "soils have 0.15 to 0.3"};
const Quantity tortuosity{"1", 1., 10., 1., 3., {}};
// Concrete on rubble 0.5 to 0.7 (Goda 2000), up to that of keys in rock.
const Quantity friction{"1",
                        0.1,
                        1.5,
                        0.2,
                        1.,
                        {{"degrees", 0., tangent_of_degrees}, {"percent", 1e-2}},
                        "concrete on rubble has 0.5 to 0.7"};
// Goda's lambda: vertical walls 1, behind blocks 0.8 (Takahashi, Tanimoto and Shimosako 1990); less with slits.
const Quantity pressure_factor{"1", 0.15, 2., 0.3, 1.5, {{"percent", 1e-2}}, "walls have 0.7 to 1.2"};
// F_T over P of an impulsive wave: 0.4 in the field, 0.8 in models (Shimosako and Takahashi 1994), above 1 in swing.
const Quantity shear_ratio{"1", 0.05, 3., 0.2, 2., {{"percent", 1e-2}}, "impulses have 0.4 to 1.2"};
// Shear stress over effective stress that liquefies sand in one cycle or ten: 0.1 to 0.6 (Seed and Idriss 1971).
const Quantity cyclic_resistance{"1", 0.02, 2., 0.05, 1., percents};
// K_0 of normally consolidated soils 0.3 to 1, of strongly overconsolidated ones up to 3 (Mayne and Kulhawy 1982).
const Quantity rest_coefficient{"1", 0.2, 3.5, 0.3, 3., percents};
// Rubble stands at 1 : 1.3 and flatter (The Rock Manual 2007).
const Quantity slope{
    "1 : n", 1.,  30.,
    1.2,     15., {{"a tangent", 0., inverse}, {"degrees", 0., [](double a) { return 1. / tangent_of_degrees(a); }}}};
// Soils 15 to 55 degrees; none for undrained strength, which programs without an angle of zero take as a small one.
const Quantity friction_angle{"degrees", 5., 60., 12., 58., {{"radians", 180. / pi}}, "sand has 28 to 40"};
// Soft clay 5 kPa to rock 1e8; less than 50 Pa bears nothing.
const Quantity cohesion{"Pa", 50., 2e8, 500., 1e8, pascals, "soft clay has 1e4 to 4e4"};
// A layer of gravel of 0.1 m in water has 1e3.
const Quantity surcharge{"Pa", 30., 1e6, 300., 3e5, pascals, "1 m of stone in water has 1e4"};
const Quantity sliding_limit{"m", 1e-4, 5., 0.01, 1., lengths, "0.3 is usual"};
const Quantity settlement_limit{"m", 1e-4, 2., 0.01, 1., lengths, "0.1 to 0.3 are usual"};
const Quantity tilt_limit{"rad", 1e-5, 0.1, 1e-4, 0.05, {{"degrees", pi / 180.}, {"mrad", 1e-3}, {"percent", 1e-2}}};
// A factor below 1 is no equilibrium.
const Quantity safety_limit{"1", 0.95, 20., 1., 10., percents, "1.2 is usual"};
const Quantity strength_limit{"1", 0.5, 20., 0.9, 10., percents, "1 to 1.5 are usual"};
const Quantity ratio_limit{"1", 1e-6, 1., 1e-3, 1., percents};
const Quantity pressure_limit{"Pa", 2e3, 2e7, 5e4, 5e6, pascals, "400e3 to 600e3 are usual"};
// Half the period of the longest swell is 15 s, of a seiche minutes.
const Quantity load_duration{"s", 1e-5, 40., 5e-3, 20., durations, "impacts last 0.01 to 0.5, halves of waves 3 to 10"};
const Quantity frequency{
    "Hz", 1e-4, 2e3,
    0.01, 100., {{"ms of a period", 0., [](double ms) { return 1e3 / ms; }}, {"seconds of a period", 0., inverse}}};
// The highest wave that was measured had 32 m.
const Quantity wave_height{"m", 1e-3, 40., 0.05, 25., lengths};
const Quantity wave_period{"s",
                           0.1,
                           60.,
                           0.5,
                           25.,
                           {{"ms", 1e-3}, {"minutes", 60.}, {"Hz", 0., inverse}},
                           "wind waves and swell have 3 to 25"};
// In radians up to pi/2; nobody knows a direction to a degree.
const Quantity wave_angle{"degrees", 1.6, 90., 2., 90., {{"radians", 180. / pi}}};
// The deepest breakwaters stand in 65 m of water.
const Quantity depth{"m", 5e-3, 120., 0.05, 100., lengths};
const Quantity bed_slope{"1", 1e-5, 0.34, 1e-3, 0.3, {{"percent", 1e-2}, {"1 : n", 0., inverse}}};
const Quantity storm_duration{
    "s", 600., 2e6, 3600., 6e5, {{"hours", 3600.}, {"minutes", 60.}, {"days", 86400.}}, "storms last hours to days"};
const Quantity level{"m", 1e-4, 20., 0.01, 10., lengths};
// G of some 1e7 to 3e8 times one to four, in plane strain.
const Quantity stiffness{"N/m2", 3e5, 1e12, 1e7, 1e10, pascals};
// Largest force over the weight; waves on caissons have 0.1 to 1, impacts more.
const Quantity load_on_weight{"N/m", 2e-3, 30., 0.02, 5., {{"kN/m", 1e3}, {"MN/m", 1e6}, {"t/m", 1e3 * g}}};
const Quantity gravity{"m/s2",
                       9.6,
                       4000.,
                       9.78,
                       9.84,
                       {{"cm/s2", 1e-2}, {"mm/s2", 1e-3}, {"ft/s2", 0.3048}, {"g", g}},
                       "the earth has 9.81, centrifuges a multiple"};

// Peak ground velocities in the near field of the largest earthquakes come to 3 m/s; ground under waves is slower.
const Quantity velocity{"m/s",
                        0.,
                        5.,
                        1e-3,
                        3.,
                        {{"cm/s", 1e-2}, {"mm/s", 1e-3}},
                        "of an acceleration in gal or cm/s2 a hundred times too large"};

}  // namespace quantities

}  // namespace upbead
