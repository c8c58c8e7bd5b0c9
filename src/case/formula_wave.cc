#include "case/formula_wave.h"

#include <boost/math/constants/constants.hpp>

#include "upbead/waves/wave_heights.h"

namespace upbead {

const std::vector<std::pair<std::string, ImpactForce>> impact_force_words{
    {"impulse", ImpactForce::impulse}, {"goda_with_alpha_I", ImpactForce::goda_with_alpha_I}};

namespace {

void declare_depths(TableSchema<Section>& table) {
  table.key("water_depth", &Section::water_depth)
      .unit("m")
      .range(formula_length())
      .required()
      .doc("depth h at the wall");
  table.key("foundation_depth", &Section::foundation_depth)
      .unit("m")
      .range(formula_length())
      .required()
      .doc("depth h' of the caisson's bottom below still water");
  table.key("berm_depth", &Section::berm_depth)
      .unit("m")
      .range(formula_length())
      .required()
      .doc("depth d of the top of the mound's armour below still water");
  table.key("crest", &Section::crest)
      .unit("m")
      .range(from_to(0., 1e4))
      .required()
      .doc("height h_c of the crest above still water");
  table.key("width", &Section::width).unit("m").range(formula_length()).required().doc("width B of the caisson");
  table.key("berm_width", &Section::berm_width)
      .unit("m")
      .range(from_to(0., 1e4))
      .required()
      .doc("width B_M of the mound's berm in front of the caisson");
  table.key("bed_slope", &Section::bed_slope)
      .range(from_to(0., 1.))
      .required()
      .doc("slope tan(theta) of the seabed in front");
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
      .range(formula_length())
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

Diagnostic no_height() {
  return {at_key("height"), "neither 'height' nor 'deep_water_height' is given",
          "add height, that of the highest wave (m), or deep_water_height"};
}

}  // namespace

TableSchema<Limits> limits_schema() {
  TableSchema<Limits> table;
  table.key("sliding", &Limits::sliding)
      .unit("m")
      .range(above(0.))
      .doc("largest sliding distance S that is allowed; where soil yields, of S and what the ground carries together");
  table.key("base_pressure", &Limits::base_pressure)
      .unit("Pa")
      .range(above(0.))
      .doc(
          "largest pressure p_e of heel and toe on the mound, by Goda's formulas, that is allowed; 400e3 to 600e3 in "
          "Japanese practice, which was made for it");
  table.key("dynamic_base_pressure", &Limits::dynamic_base_pressure)
      .unit("Pa")
      .range(above(0.))
      .doc(
          "largest pressure of heel and toe in motion, of a moment and with its impulse, that is allowed; practice "
          "knows "
          "no such limit, and that of base_pressure was not made for it");
  table.key("overturning", &Limits::overturning)
      .range(above(0.))
      .doc("least margin against overturning that is allowed; 1.2 in Japanese practice");
  table.key("safety", &Limits::safety)
      .range(above(0.))
      .doc(
          "least factor by which the strength may fall at rest that is allowed; 1 where it is not given, as ground "
          "with "
          "less does not stand. Has the factor computed, as initial.safety does");
  table.key("circles", &Limits::circles)
      .range(above(0.))
      .doc(
          "least factor of safety of slip circles through mound and ground under the caisson, by Bishop's simplified "
          "method, that is allowed; 1.0 in waves in Japanese practice. Only a run checks it");
  return table;
}

TableSchema<Section> section_schema() {
  TableSchema<Section> table;
  declare_depths(table);
  declare_weights(table);
  declare_blocks(table);
  return table;
}

Diagnostics diagnose(const WaveGiven& wave) {
  Diagnostics list;
  if (!wave.height && !wave.deep_water_height) list.add(no_height());
  if (wave.height && wave.deep_water_height)
    list.add(at_key("deep_water_height"), "both 'height' and 'deep_water_height' are given", "keep one of them");
  else if (wave.deep_water_height && wave.significant_height)
    list.add(at_key("significant_height"), "'significant_height' is given, but follows from deep_water_height",
             "remove it, or give height instead of deep_water_height");
  return list;
}

DesignWave design_wave(const WaveGiven& wave, const Section& section, const Water& water) {
  DesignWave w;
  w.period = wave.period;
  w.angle = wave.angle * boost::math::constants::degree<double>();
  if (wave.deep_water_height) {
    const DesignHeights heights =
        design_heights({*wave.deep_water_height, wave.period, section.water_depth, section.bed_slope}, water.gravity);
    w.height = heights.highest;
    w.significant_height = heights.significant;
  } else {
    w.height = *wave.height;
    w.significant_height = wave.significant_height.value_or(w.height / highest_over_significant);
  }
  return w;
}

}  // namespace upbead
