#include "case/formula_wave.h"

#include <boost/math/constants/constants.hpp>

#include "base/text.h"
#include "upbead/waves/wave_heights.h"

namespace upbead {

const std::vector<std::pair<std::string, ImpactForce>> impact_force_words{
    {"impulse", ImpactForce::impulse},
    {"goda_with_alpha_I", ImpactForce::goda_with_alpha_I},
    {"proverbs", ImpactForce::proverbs}};

namespace {

void declare_depths(TableSchema<Section>& table) {
  table.key("water_depth", &Section::water_depth, "m", "depth h at the wall", formula_length()).required();
  table
      .key("foundation_depth", &Section::foundation_depth, "m", "depth h' of the caisson's bottom below still water",
           formula_length())
      .required();
  table
      .key("berm_depth", &Section::berm_depth, "m", "depth d of the top of the mound's armour below still water",
           formula_length())
      .required();
  table.key("crest", &Section::crest, "m", "height h_c of the crest above still water", from_to(0., 1e4)).required();
  table.key("width", &Section::width, "m", "width B of the caisson", formula_length()).required();
  table
      .key("berm_width", &Section::berm_width, "m", "width B_M of the mound's berm in front of the caisson",
           from_to(0., 1e4))
      .required();
  table.key("bed_slope", &Section::bed_slope, "", "slope tan(theta) of the seabed in front", from_to(0., 1.))
      .required();
  table.key("harbour_level", &Section::harbour_level, "m",
            "height of still water behind the caisson above that of the sea; negative where it is lower",
            from_to(-1e4, 1e4));
  table
      .key("facing", &Section::facing, "deg",
           "where the wall looks at, seaward: the direction of its normal, clockwise from north", from_to(0., 360.))
      .fallback("none: waves have an angle, and no direction");
}

void declare_weights(TableSchema<Section>& table) {
  table.key("weight", &Section::weight, "N/m", "weight W of the caisson with its fill, in air", from_to(1., 1e12))
      .required();
  table
      .key("submerged_weight", &Section::submerged_weight, "N/m", "weight W' of the caisson in still water",
           from_to(1., 1e12))
      .formerly("buoyant_weight")
      .required();
  table
      .key("centroid", &Section::centroid, "m", "distance t from the landward heel to the line of W'", formula_length())
      .fallback("width / 2");
  table.key("friction", &Section::friction, "", "friction coefficient mu between the caisson and the mound",
            from_to(0.01, 10.));
}

void declare_blocks(TableSchema<Section>& table) {
  table.key("blocks", &Section::dissipating_blocks, "",
            "true: wave-dissipating blocks cover the wall; changes the standards of the three factors below, to be "
            "checked in Takahashi, Tanimoto and Shimosako (1990)");
  table
      .key("lambda_1", &Section::lambda_1, "", "factor lambda_1 of the pressure by alpha_1, and of eta*",
           from_to(0., 2.))
      .fallback("1; with blocks 1 up to H/h = 0.3, 1.2 - (2/3) H/h up to 0.6, 0.8 beyond");
  table.key("lambda_2", &Section::lambda_2, "", "factor lambda_2 of the pressure by alpha*", from_to(0., 2.))
      .fallback("1; with blocks 0");
  table.key("lambda_3", &Section::lambda_3, "", "factor lambda_3 of the uplift", from_to(0., 2.))
      .fallback("as lambda_1 without a value of its own");
}

Diagnostic no_height() {
  return {at_key("height"), "neither 'height' nor 'deep_water_height' is given",
          "add height, that of the highest wave (m), or deep_water_height"};
}

void declare_peaks(TableSchema<ImpactScatter>& table) {
  table.key("quantile", &ImpactScatter::quantile, "",
            "share of the impacts whose peak is lower; 0.5 for the middle one; an assumption", between(0., 1.));
  table.key("location", &ImpactScatter::location, "",
            "of F* = location + scale/shape (1 - (-ln quantile)^shape), F* = P_I/(rho g H_b^2); on a bed of 1:50, an "
            "assumption: steeper beds have more",
            from_to(0., 100.));
  table.key("scale", &ImpactScatter::scale, "", "of F*; an assumption", from_to(0., 100.));
  table.key("shape", &ImpactScatter::shape, "", "of F*; an assumption", from_to(-2., -1e-3));
  table.key("breaker", &ImpactScatter::breaker, "m", "H_b, height from which waves break on the wall", formula_length())
      .fallback("by the mound: (0.1025 + 0.0217 (1 - C_r)/(1 + C_r)) L tanh(2 pi k_b h/L), an assumption");
}

}  // namespace

TableSchema<ImpactScatter> impact_scatter_schema() {
  TableSchema<ImpactScatter> table;
  declare_peaks(table);
  table.key("reflection", &ImpactScatter::reflection, "", "C_r of the wall, for H_b; an assumption", from_to(0., 1.));
  table.key("mound_slope", &ImpactScatter::mound_slope, "",
            "cotangent of the mound's seaward slope, for H_b; an assumption", from_to(0., 100.));
  table
      .key("rise_quantile", &ImpactScatter::rise_quantile, "",
           "share of the impacts that rise faster, at the same peak: a longer one has more impulse", between(0., 1.))
      .fallback("the mean rise, by rise_coefficient");
  table.key("rise_scatter", &ImpactScatter::rise_scatter, "",
            "standard deviation of the rise over its mean, lognormal; an assumption", from_to(0., 10.));
  return table;
}

Diagnostics diagnose(const ImpactAssumptions& impact, ImpactForce force) {
  Diagnostics list;
  if (force != ImpactForce::proverbs && impact.proverbs)
    list.add(at_key("proverbs"), "'proverbs' is given, but the peak is not by it", "write force = \"proverbs\"");
  if (force == ImpactForce::proverbs && impact.peak_gain)
    list.add(at_key("peak_gain"), "'peak_gain' is given, but the peak is by force = \"proverbs\"",
             "remove peak_gain, or write force = \"impulse\"");
  return list;
}

ImpactAssumptions with_force(ImpactAssumptions impact, ImpactForce force) {
  if (force == ImpactForce::goda_with_alpha_I) impact.peak_gain.reset();
  if (force == ImpactForce::proverbs && !impact.proverbs) impact.proverbs.emplace();
  return impact;
}

double turned_angle(const WaveGiven& wave, const Section& section) {
  return wave.direction && section.facing ? turned_angle(*wave.direction, *section.facing).turned : wave.angle;
}

std::string direction_text(const WaveGiven& wave, const Section& section) {
  if (!wave.direction || !section.facing) return "";
  const TurnedAngle angle = turned_angle(*wave.direction, *section.facing);
  return "it comes from " + significant(*wave.direction, 4) + " degrees, the wall looks at " +
         significant(*section.facing, 4) + ": " + significant(angle.to_normal, 4) +
         " degrees to the normal, turned by " + significant(angle.to_normal - angle.turned, 4) +
         " towards it (Goda 2000): beta = " + significant(angle.turned, 4) + " degrees";
}

namespace {

void declare_factors(TableSchema<Limits>& table) {
  table.key("sliding_factor", &Limits::sliding_factor, "",
            "least safety factor against sliding landward, by formulas, that is allowed; 1.2 in Japanese practice, 1 "
            "where it is not given",
            above(0.));
  table.key("seaward_sliding_factor", &Limits::seaward_sliding_factor, "",
            "least safety factor against sliding seaward, in the trough, by formulas, that is allowed; as "
            "sliding_factor where it is not given",
            above(0.));
  table.key("settlement", &Limits::settlement, "m",
            "largest settlement of the caisson, left in the end by soil that yields, that is allowed", above(0.));
  table.key("tilt", &Limits::tilt, "rad",
            "largest tilt of the caisson, left in the end by soil that yields, that is allowed", above(0.));
  table.key("pressure_ratio", &Limits::pressure_ratio, "",
            "largest residual pore pressure of a storm over the mean effective stress at rest that is allowed; 1: the "
            "soil has liquefied",
            above(0.));
  table.key("lives_beyond", &Limits::lives_beyond, "",
            "largest share of the lives that may slide farther than `sliding`", between(0., 1.));
}

}  // namespace

TableSchema<Limits> limits_schema() {
  TableSchema<Limits> table;
  table.key("sliding", &Limits::sliding, "m",
            "largest sliding distance S that is allowed; where soil yields, of S and what the ground carries together",
            above(0.));
  table.key("base_pressure", &Limits::base_pressure, "Pa",
            "largest pressure p_e of heel and toe on the mound, by Goda's formulas, that is allowed; 400e3 to 600e3 in "
            "Japanese practice, which was made for it",
            above(0.));
  table.key("dynamic_base_pressure", &Limits::dynamic_base_pressure, "Pa",
            "largest pressure of heel and toe in motion, of a moment and with its impulse, that is allowed; practice "
            "knows no such limit, and that of base_pressure was not made for it",
            above(0.));
  table.key("overturning", &Limits::overturning, "",
            "least margin against overturning that is allowed; 1.2 in Japanese practice", above(0.));
  table.key("safety", &Limits::safety, "",
            "least factor by which the strength may fall at rest that is allowed; 1 where it is not given, as ground "
            "with less does not stand. Has the factor computed, as initial.safety does",
            above(0.));
  table.key("circles", &Limits::circles, "",
            "least factor of safety of slip circles through mound and ground under the caisson, by Bishop's simplified "
            "method, that is allowed; 1.0 in waves in Japanese practice. Only a run checks it",
            above(0.));
  table.key(
      "peak_safety", &Limits::peak_safety, "",
      "least factor by which the strength may fall at the peak of the wave, under what the base presses then, that "
      "is allowed. Has the factor computed, which takes about as long as the one at rest; only a run does",
      above(0.));
  table.key(
      "liquefaction", &Limits::liquefaction, "",
      "least factor against momentary liquefaction of the ground beside the caisson that is allowed: effective "
      "stress at rest over the excess of the pore pressure over that on the surface above. Has it computed; only a "
      "run does",
      above(0.));
  declare_factors(table);
  return table;
}

TableSchema<CombinedModel> combined_schema() {
  TableSchema<CombinedModel> table;
  table.key("added_mass_factor", &CombinedModel::added_mass_factor, "",
            "added mass M_a over rho h'^2; the default is that of rigid walls in incompressible water on both sides",
            from_to(0., 10.));
  const std::vector<std::pair<std::string, UpliftShape>> shapes{{"in_phase", UpliftShape::in_phase},
                                                                {"sinusoidal", UpliftShape::sinusoidal}};
  table.choice("uplift", &CombinedModel::uplift, shapes,
               "course of U; in_phase: proportional to P; sinusoidal: uplift_gain U sin(2 pi t / T)");
  table
      .key("uplift_gain", &CombinedModel::uplift_gain, "",
           "factor gamma_U of a sinusoidal uplift; unsettled in the sources at hand", from_to(0., 100.))
      .when(
          "uplift", [](const CombinedModel& model) { return model.uplift == UpliftShape::sinusoidal; },
          "where the uplift is sinusoidal");
  return table;
}

TableSchema<DurationFactor> duration_schema() {
  TableSchema<DurationFactor> table;
  table.key("a", &DurationFactor::a, "", "exponent a of k = 1 / (alpha*^a + 1)^b, eq. (9)", from_to(0.001, 10.));
  table.key("b", &DurationFactor::b, "", "exponent b of k = 1 / (alpha*^a + 1)^b, eq. (9)", from_to(0., 100.));
  return table;
}

TableSchema<Section> section_schema() {
  TableSchema<Section> table;
  declare_depths(table);
  declare_weights(table);
  declare_blocks(table);
  return table;
}

namespace {

void diagnose_direction(const WaveGiven& wave, const Section* section, Diagnostics& list) {
  if (!wave.direction) return;
  if (wave.angle != 0.) list.add(at_key("direction"), "both 'angle' and 'direction' are given", "keep one of them");
  if (section == nullptr) return;
  if (!section->facing)
    list.add(at_key("direction"), "'direction' is given, but not where the wall looks at",
             "add facing to [section], the direction of the wall's seaward normal, in degrees from north");
  else if (turned_angle(*wave.direction, *section->facing).to_normal >= 90.)
    list.add(at_key("direction"),
             "the wave comes from " + significant(*wave.direction, 4) + " degrees, " +
                 significant(turned_angle(*wave.direction, *section->facing).to_normal, 4) +
                 " degrees to the wall's normal: it does not meet the wall",
             "give where the wave comes from, and where the wall looks at (degrees from north)");
}

}  // namespace

Diagnostics diagnose(const WaveGiven& wave, const Section* section) {
  Diagnostics list;
  diagnose_direction(wave, section, list);
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
  w.angle = turned_angle(wave, section) * boost::math::constants::degree<double>();
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
