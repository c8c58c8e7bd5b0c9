#include <cmath>

#include "design/design_tables.h"

namespace upbead {

namespace {

const std::vector<std::pair<std::string, Law>> law_words{
    {"paper", Law::paper}, {"exact", Law::exact}, {"combined", Law::combined}, {"dynamic", Law::dynamic}};
const std::vector<std::pair<std::string, ScatterKind>> scatter_words{{"normal", ScatterKind::normal},
                                                                     {"lognormal", ScatterKind::lognormal},
                                                                     {"uniform", ScatterKind::uniform},
                                                                     {"triangular", ScatterKind::triangular}};
const std::vector<std::pair<std::string, Per>> per_words{
    {"life", Per::life}, {"storm", Per::storm}, {"wave", Per::wave}};
const std::vector<std::pair<std::string, ImpactUplift>> uplift_words{
    {"held", ImpactUplift::held}, {"in_phase", ImpactUplift::in_phase}, {"sinusoidal", ImpactUplift::sinusoidal}};

const char* const highest_doc =
    "largest height of a wave over H_1/3; higher ones are set aside; breaking: Goda's highest random breaker at the "
    "wall's depth and the sea state's water level, higher waves break to its height; none: no limit at all";

TableSchema<SeaTable> sea_schema() {
  TableSchema<SeaTable> table;
  table
      .key("states", &SeaTable::states, "",
           "path of a CSV file with the columns significant_height (m), period (s), waves (their number), and, on "
           "demand, water_level (m) and angle (degrees)")
      .required();
  table.key("years", &SeaTable::years, "years", "time that the sea states cover", from_to(1e-3, 1e5));
  table.key("highest", &SeaTable::highest, "", highest_doc, from_to(0.01, 10.));
  table.key("heights", &SeaTable::heights, "m", "heights by name; the waves above each are counted");
  return table;
}

TableSchema<LifeTable> life_schema() {
  TableSchema<LifeTable> table;
  table.key("years", &LifeTable::years, "years", "life of the structure", from_to(1e-3, 1e5));
  table.key("simulated_lives", &LifeTable::lives, "", "number of lives to simulate", from_to(2., 1e7))
      .formerly("lives");
  table.key("seed", &LifeTable::seed, "", "seed; the same one gives the same numbers on any number of threads",
            from_to(0., 2147483647.));
  table.choice("sliding", &LifeTable::sliding, law_words, "how S follows from a wave")
      .fallback("dynamic where [dynamics] gives a model, else exact");
  return table;
}

TableSchema<Scatter> scatter_schema() {
  const auto by_moments = [](const Scatter& s) {
    return s.kind == ScatterKind::normal || s.kind == ScatterKind::lognormal;
  };
  TableSchema<Scatter> table;
  table.choice("kind", &Scatter::kind, scatter_words, "distribution");
  table.key("mean", &Scatter::mean, "", "mean before the ends are cut")
      .fallback("1; of water_level 0")
      .when("kind", by_moments, "in normal and lognormal");
  table.key("cov", &Scatter::cov, "", "standard deviation over mean; or deviation", at_least(0.))
      .when("kind", by_moments, "in normal and lognormal");
  table.key("deviation", &Scatter::deviation, "", "standard deviation; or cov", at_least(0.))
      .when("kind", by_moments, "in normal and lognormal");
  table.key("mode", &Scatter::mode, "", "most likely value")
      .required()
      .when(
          "kind", [](const Scatter& s) { return s.kind == ScatterKind::triangular; }, "in triangular");
  table.key("low", &Scatter::low, "", "least value; normal and lognormal are cut there").fallback("not cut");
  table.key("high", &Scatter::high, "", "largest value; normal and lognormal are cut there").fallback("not cut");
  table.choice("per", &Scatter::per, per_words, "how long one draw holds");
  return table;
}

TableSchema<ScatterTables> scatters_schema() {
  const TableSchema<Scatter> one = scatter_schema();
  TableSchema<ScatterTables> table;
  table.table("significant_height", &ScatterTables::significant_height, one).doc("Factor of H_1/3.");
  table.table("wave", &ScatterTables::wave, one).doc("Factor of the height of single waves.");
  table.table("period", &ScatterTables::period, one).doc("Factor of T.");
  table.table("force", &ScatterTables::force, one).doc("Factor of P.");
  table.table("uplift", &ScatterTables::uplift, one).doc("Factor of U.");
  table.table("friction", &ScatterTables::friction, one).doc("Factor of mu.");
  table.table("weight", &ScatterTables::weight, one).doc("Factor of W; the buoyancy W - W' stays.");
  table.table("water_level", &ScatterTables::water_level, one).doc("Rise of the still water (m).");
  return table;
}

TableSchema<DynamicsTable> dynamics_schema() {
  TableSchema<DynamicsTable> table;
  table.key("model", &DynamicsTable::model, "", "path of a reduced model, made by 'upbead reduce'").required();
  table.key("soil", &DynamicsTable::soil, "",
            "of a model of soils, made by 'upbead reduce --soils': its soil, by keys such as "
            "\"regions.seabed.shear_modulus\"; those left out have the case's value");
  table.key("load", &DynamicsTable::load, "", "name of its load that is the wave")
      .fallback("the only one, or that with the largest peak");
  table
      .key("step", &DynamicsTable::step, "s", "step of the answers; auto: from the rise of the waves and the model",
           from_to(1e-5, 1.))
      .or_word("auto");
  table.key("node_waves", &DynamicsTable::node_waves, "",
            "waves drawn from all, to be answered with slip and lift node by node where the model has contact: their S "
            "gives that of all; 0: none",
            from_to(0., 1e6));
  return table;
}

TableSchema<ImpactTable> impact_schema() {
  TableSchema<ImpactTable> table;
  table.choice(
      "force", &ImpactTable::force, impact_force_words,
      "force that the model answers; goda_with_alpha_I is refused, as it already is an effective sliding force");
  declare_impact(table);
  table.choice("uplift", &ImpactTable::uplift, uplift_words,
               "uplift over time; held: U_max until T/4, then U_max sin(2 pi t/T)");
  return table;
}

const std::vector<std::pair<std::string, ExtremeKind>> extreme_words{{"weibull", ExtremeKind::weibull},
                                                                     {"gumbel", ExtremeKind::gumbel}};
const std::vector<std::pair<std::string, TideKind>> tide_words{{"sinusoidal", TideKind::sinusoidal},
                                                               {"uniform", TideKind::uniform}};

void declare_heights(TableSchema<StormsTable>& table) {
  table.choice("distribution", &StormsTable::kind, extreme_words,
               "distribution of H_0', the equivalent deep-water significant height of a storm");
  table.key("location", &StormsTable::location, "m", "location of H_0'", from_to(0., 100.)).required();
  table.key("scale", &StormsTable::scale, "m", "scale of H_0'", from_to(1e-6, 100.)).required();
  table.key("shape", &StormsTable::shape, "", "shape of H_0'", from_to(0.2, 100.))
      .when(
          "distribution", [](const StormsTable& s) { return s.kind == ExtremeKind::weibull; }, "in weibull");
}

void declare_storms(TableSchema<StormsTable>& table) {
  table.key("per_year", &StormsTable::per_year, "", "mean number of storms in a year", from_to(1e-6, 1e4));
  table.key("poisson", &StormsTable::poisson, "", "true: their number is random, after Poisson");
  table.key("duration", &StormsTable::duration, "s", "duration of a storm", from_to(1., 1e7));
  table.key("period", &StormsTable::period, "s", "significant wave period T of all storms; or steepness",
            from_to(0.01, 1e4));
  table.key("steepness", &StormsTable::steepness, "", "steepness H_0'/L_0, from which T follows; or period",
            from_to(1e-4, 0.2));
  table.key("angle", &StormsTable::angle, "deg",
            "angle beta between the waves and the wall's normal; already turned by 15 deg towards it",
            from_to_below(0., 90.));
}

TableSchema<StormsTable> storms_schema() {
  TableSchema<StormsTable> table;
  declare_heights(table);
  declare_storms(table);
  table.key("tide_low", &StormsTable::tide_low, "m", "low water above still water", from_to(-100., 100.));
  table.key("tide_high", &StormsTable::tide_high, "m", "high water above still water", from_to(-100., 100.));
  table.choice("tide", &StormsTable::tide, tide_words,
               "level that a storm meets; sinusoidal: any phase of a sine between the two; uniform: any level");
  table.key("highest", &StormsTable::highest, "", highest_doc, from_to(0.01, 10.));
  return table;
}

}  // namespace

Diagnostics read_value(const Node& node, const KeyInfo& key, HighestWave& value) {
  const std::string word = node.text() ? *node.text() : "";
  value = {word == "breaking"};
  if (value.breaking || word == "none") return {};
  const Diagnostics wrong = read_value(node, key, value.cut);
  if (wrong.empty() || std::isfinite(value.cut)) return wrong;
  return {{node.place, key.name + ": expected " + type_text(key, &value) + ", found " + found(node),
           "give the " + key.meaning()}};
}

std::string type_text(const KeyInfo&, const HighestWave*) {
  return "a number, \"breaking\" or \"none\"";
}

std::string print_value(const KeyInfo& key, const HighestWave& value) {
  if (value.breaking) return to_toml(std::string("breaking"));
  return value.cut == RayleighHeights::no_cut ? to_toml(std::string("none")) : print_value(key, value.cut);
}

void add_expected_tables(TableSchema<DesignTables>& table) {
  table.table("sea", &DesignTables::sea, sea_schema()).doc("Sea states, for `expected`; or [storms].");
  table.table("storms", &DesignTables::storms, storms_schema())
      .doc("Storms of a life from the statistics of extreme waves in deep water, in place of [sea]; needs [life].");
  table.table("life", &DesignTables::life, life_schema()).doc("Monte Carlo over lives; not done without this table.");
  table.table("limits", &DesignTables::limits, limits_schema())
      .doc(
          "What lives are checked against, for `expected`: how many of them exceed it. `waves` holds each wave against "
          "base_pressure and overturning.");
  table.table("scatter", &DesignTables::scatter, scatters_schema())
      .doc("What is uncertain in Monte Carlo, each with a table [scatter.NAME]; nothing is without one.");
  table.table("dynamics", &DesignTables::dynamics, dynamics_schema())
      .doc("The caisson's own dynamics: S from F_T(t) of a reduced model.");
  table.table("impact", &DesignTables::impact, impact_schema())
      .doc("The force history of a wave that the reduced model answers: assumptions of ours.");
}

}  // namespace upbead
