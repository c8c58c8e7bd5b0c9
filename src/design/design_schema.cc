#include "design/design_tables.h"

namespace upbead {

namespace {

/// Lengths that no formula overflows with (m).
const Range length = from_to(1e-3, 1e4);

TableSchema<Water> fluid_schema() {
  TableSchema<Water> table;
  table.key("density", &Water::density).unit("kg/m3").range(from_to(1., 1e4)).doc("density of the sea water");
  return table;
}

void declare_depths(TableSchema<Section>& table) {
  table.key("water_depth", &Section::water_depth).unit("m").range(length).required().doc("depth h at the wall");
  table.key("foundation_depth", &Section::foundation_depth)
      .unit("m")
      .range(length)
      .required()
      .doc("depth h' of the caisson's bottom below still water");
  table.key("berm_depth", &Section::berm_depth)
      .unit("m")
      .range(length)
      .required()
      .doc("depth d of the top of the mound's armour below still water");
  table.key("crest", &Section::crest)
      .unit("m")
      .range(from_to(0., 1e4))
      .required()
      .doc("height h_c of the crest above still water");
  table.key("width", &Section::width).unit("m").range(length).required().doc("width B of the caisson");
  table.key("berm_width", &Section::berm_width)
      .unit("m")
      .range(from_to(0., 1e4))
      .required()
      .doc("width B_M of the mound's berm in front of the caisson");
  table.key("bed_slope", &Section::bed_slope)
      .range(from_to(0., 1.))
      .required()
      .doc("slope tan(theta) of the sea bed in front");
}

void declare_weights(TableSchema<Section>& table) {
  table.key("weight", &Section::weight)
      .unit("N/m")
      .range(from_to(1., 1e12))
      .required()
      .doc("weight W of the caisson with its fill, in air");
  table.key("submerged_weight", &Section::submerged_weight)
      .formerly("buoyant_weight")
      .unit("N/m")
      .range(from_to(1., 1e12))
      .required()
      .doc("weight W' of the caisson in still water");
  table.key("centroid", &Section::centroid)
      .unit("m")
      .range(length)
      .fallback("width / 2")
      .doc("distance t from the landward heel to the line of W'");
  table.key("friction", &Section::friction)
      .range(from_to(0.01, 10.))
      .doc("friction coefficient mu between the caisson and the mound");
}

void declare_blocks(TableSchema<Section>& table) {
  table.key("blocks", &Section::dissipating_blocks)
      .doc(
          "true: wave-dissipating blocks cover the wall; changes the standards of the three factors below, to be "
          "checked "
          "in Takahashi, Tanimoto and Shimosako (1990)");
  table.key("lambda_1", &Section::lambda_1)
      .range(from_to(0., 2.))
      .fallback("1; with blocks 1 up to H/h = 0.3, 1.2 - (2/3) H/h up to 0.6, 0.8 beyond")
      .doc("factor lambda_1 of the pressure by alpha_1, and of eta*");
  table.key("lambda_2", &Section::lambda_2)
      .range(from_to(0., 2.))
      .fallback("1; with blocks 0")
      .doc("factor lambda_2 of the pressure by alpha*");
  table.key("lambda_3", &Section::lambda_3)
      .range(from_to(0., 2.))
      .fallback("as lambda_1 without a value of its own")
      .doc("factor lambda_3 of the uplift");
}

TableSchema<Section> section_schema() {
  TableSchema<Section> table;
  declare_depths(table);
  declare_weights(table);
  declare_blocks(table);
  return table;
}

TableSchema<DurationFactor> duration_schema() {
  TableSchema<DurationFactor> table;
  table.key("a", &DurationFactor::a).range(from_to(0.001, 10.)).doc("exponent a of k = 1 / (alpha*^a + 1)^b, eq. (9)");
  table.key("b", &DurationFactor::b).range(from_to(0., 100.)).doc("exponent b of k = 1 / (alpha*^a + 1)^b, eq. (9)");
  return table;
}

TableSchema<CombinedModel> combined_schema() {
  TableSchema<CombinedModel> table;
  table.key("added_mass_factor", &CombinedModel::added_mass_factor)
      .range(from_to(0., 10.))
      .doc("added mass M_a over rho h'^2; the default is that of rigid walls in incompressible water on both sides");
  const std::vector<std::pair<std::string, UpliftShape>> shapes{{"in_phase", UpliftShape::in_phase},
                                                                {"sinusoidal", UpliftShape::sinusoidal}};
  table.choice("uplift", &CombinedModel::uplift, shapes)
      .doc("course of U; in_phase: proportional to P; sinusoidal: uplift_gain U sin(2 pi t / T)");
  table.key("uplift_gain", &CombinedModel::uplift_gain)
      .range(from_to(0., 100.))
      .doc("factor gamma_U of a sinusoidal uplift; unsettled in the sources at hand")
      .when(
          "uplift", [](const CombinedModel& model) { return model.uplift == UpliftShape::sinusoidal; },
          "where the uplift is sinusoidal");
  return table;
}

TableSchema<ElasticBase> ground_schema() {
  TableSchema<ElasticBase> table;
  table.key("stiffness", &ElasticBase::stiffness)
      .unit("N/m2")
      .range(from_to(1., 1e15))
      .required()
      .doc("horizontal stiffness of the ground under the caisson");
  table.key("mass", &ElasticBase::mass)
      .unit("kg/m")
      .range(from_to(0., 1e12))
      .doc("mass of the ground that sways with the bottom");
  table.key("damping", &ElasticBase::damping)
      .unit("N s/m2")
      .range(from_to(0., 1e15))
      .doc("damping of the ground; needs a mass");
  return table;
}

void declare_measured(TableSchema<WaveTable>& table) {
  table.key("force", &WaveTable::force)
      .unit("N/m")
      .range(from_to(1., 1e12))
      .fallback("by Goda's formula with alpha_I, an effective sliding force")
      .doc("peak of the wave force P; measured or computed, for sliding");
  table.key("shear_to_force_ratio", &WaveTable::shear_to_force_ratio)
      .range(from_to(0.001, 10.))
      .fallback("1 with force")
      .doc("peak of F_T over the peak of P; only with force, as alpha_I already holds it");
  table.key("uplift", &WaveTable::uplift)
      .unit("N/m")
      .range(from_to(0., 1e12))
      .fallback("by Goda's formula")
      .doc("uplift U when F_T is largest; only with force");
  table.key("pulse_duration", &WaveTable::pulse_duration)
      .unit("s")
      .range(from_to(1e-4, 1e3))
      .doc("duration of that P as a symmetric triangle, to which [ground] answers; only with force and [ground]");
}

TableSchema<WaveTable> wave_schema() {
  TableSchema<WaveTable> table;
  table.key("height", &WaveTable::height)
      .unit("m")
      .range(length)
      .doc("height H of the wave; the highest one, H_D, for a design; or deep_water_height");
  table.key("significant_height", &WaveTable::significant_height)
      .unit("m")
      .range(length)
      .fallback("height / 1.8, or by random breaking")
      .doc("significant height H_1/3; tells where h_b is taken");
  table.key("deep_water_height", &WaveTable::deep_water_height)
      .unit("m")
      .range(length)
      .doc("equivalent deep-water height H_0'; H_1/3 and H are then those of random breaking");
  table.key("period", &WaveTable::period)
      .unit("s")
      .range(from_to(0.01, 1e4))
      .required()
      .doc("significant wave period T");
  table.key("angle", &WaveTable::angle)
      .unit("deg")
      .range(from_to_below(0., 90.))
      .doc("angle beta between the wave's direction and the wall's normal; already turned by 15 deg towards it");
  declare_measured(table);
  return table;
}

}  // namespace

TableSchema<DesignTables> design_schema() {
  TableSchema<DesignTables> table;
  table.key("title", &DesignTables::title).doc("title of the design");
  table.key("gravity", &DesignTables::gravity).unit("m/s2").range(from_to(0.1, 100.)).doc("acceleration of gravity");
  table.table("fluid", &DesignTables::water, fluid_schema()).doc("Sea water.");
  table.table("section", &DesignTables::section, section_schema())
      .required()
      .doc("The breakwater's cross-section, per metre of its length.");
  table.table("duration", &DesignTables::duration, duration_schema())
      .doc("How long the shear force lasts: tau_0 = k(alpha*) tau_0F, eqs. (8)-(11).");
  table.table("combined", &DesignTables::combined, combined_schema())
      .doc("What the sources at hand do not settle of the model of Shimosako and Takahashi (1998).");
  table.table("ground", &DesignTables::ground, ground_schema())
      .doc("The ground's sway, lumped, for waves with a pulse_duration: F_T and S of a caisson that swings and slips.");
  table.tables("waves", &DesignTables::waves, wave_schema())
      .doc("Any number of waves by name, each with exactly one of height and deep_water_height.");
  add_expected_tables(table);
  table.table("calibration", &DesignTables::calibration, calibration_schema())
      .doc("For `calibrate`: waves and mounds, every value with every other, and reduced models.");
  return table;
}

}  // namespace upbead
