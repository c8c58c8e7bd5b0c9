#include "case/formula_wave.h"

#include <boost/math/constants/constants.hpp>

#include "upbead/waves/wave_heights.h"

namespace upbead {

const std::vector<std::pair<std::string, ImpactForce>> impact_force_words{
    {"impulse", ImpactForce::impulse}, {"goda_with_alpha_I", ImpactForce::goda_with_alpha_I}};

namespace {

void declare_depths(TableSchema<Section>& table) {
  table.key("water_depth", &Section::water_depth, "m", "depth h at the wall").range(formula_length()).required();
  table.key("foundation_depth", &Section::foundation_depth, "m", "depth h' of the caisson's bottom below still water")
      .range(formula_length())
      .required();
  table.key("berm_depth", &Section::berm_depth, "m", "depth d of the top of the mound's armour below still water")
      .range(formula_length())
      .required();
  table.key("crest", &Section::crest, "m", "height h_c of the crest above still water")
      .range(from_to(0., 1e4))
      .required();
  table.key("width", &Section::width, "m", "width B of the caisson").range(formula_length()).required();
  table.key("berm_width", &Section::berm_width, "m", "width B_M of the mound's berm in front of the caisson")
      .range(from_to(0., 1e4))
      .required();
  table.key("bed_slope", &Section::bed_slope, "", "slope tan(theta) of the seabed in front")
      .range(from_to(0., 1.))
      .required();
}

void declare_weights(TableSchema<Section>& table) {
  table.key("weight", &Section::weight, "N/m", "weight W of the caisson with its fill, in air")
      .range(from_to(1., 1e12))
      .required();
  table.key("submerged_weight", &Section::submerged_weight, "N/m", "weight W' of the caisson in still water")
      .formerly("buoyant_weight")
      .range(from_to(1., 1e12))
      .required();
  table.key("centroid", &Section::centroid, "m", "distance t from the landward heel to the line of W'")
      .range(formula_length())
      .fallback("width / 2");
  table.key("friction", &Section::friction, "", "friction coefficient mu between the caisson and the mound")
      .range(from_to(0.01, 10.));
}

void declare_blocks(TableSchema<Section>& table) {
  table.key("blocks", &Section::dissipating_blocks, "",
            "true: wave-dissipating blocks cover the wall; changes the standards of the three factors below, to be "
            "checked in Takahashi, Tanimoto and Shimosako (1990)");
  table.key("lambda_1", &Section::lambda_1, "", "factor lambda_1 of the pressure by alpha_1, and of eta*")
      .range(from_to(0., 2.))
      .fallback("1; with blocks 1 up to H/h = 0.3, 1.2 - (2/3) H/h up to 0.6, 0.8 beyond");
  table.key("lambda_2", &Section::lambda_2, "", "factor lambda_2 of the pressure by alpha*")
      .range(from_to(0., 2.))
      .fallback("1; with blocks 0");
  table.key("lambda_3", &Section::lambda_3, "", "factor lambda_3 of the uplift")
      .range(from_to(0., 2.))
      .fallback("as lambda_1 without a value of its own");
}

Diagnostic no_height() {
  return {at_key("height"), "neither 'height' nor 'deep_water_height' is given",
          "add height, that of the highest wave (m), or deep_water_height"};
}

}  // namespace

TableSchema<Limits> limits_schema() {
  TableSchema<Limits> table;
  table
      .key("sliding", &Limits::sliding, "m",
           "largest sliding distance S that is allowed; where soil yields, of S and what the ground carries together")
      .range(above(0.));
  table
      .key("base_pressure", &Limits::base_pressure, "Pa",
           "largest pressure p_e of heel and toe on the mound, by Goda's formulas, that is allowed; 400e3 to 600e3 in "
           "Japanese practice, which was made for it")
      .range(above(0.));
  table
      .key("dynamic_base_pressure", &Limits::dynamic_base_pressure, "Pa",
           "largest pressure of heel and toe in motion, of a moment and with its impulse, that is allowed; practice "
           "knows no such limit, and that of base_pressure was not made for it")
      .range(above(0.));
  table
      .key("overturning", &Limits::overturning, "",
           "least margin against overturning that is allowed; 1.2 in Japanese practice")
      .range(above(0.));
  table
      .key("safety", &Limits::safety, "",
           "least factor by which the strength may fall at rest that is allowed; 1 where it is not given, as ground "
           "with less does not stand. Has the factor computed, as initial.safety does")
      .range(above(0.));
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
