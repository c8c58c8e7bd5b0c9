#include <algorithm>

#include "base/text.h"
#include "design/reliability_table.h"

namespace upbead {

namespace {

const std::vector<std::pair<std::string, RandomKind>> random_words{
    {"normal", RandomKind::normal},   {"lognormal", RandomKind::lognormal}, {"gumbel", RandomKind::gumbel},
    {"weibull", RandomKind::weibull}, {"uniform", RandomKind::uniform},     {"triangular", RandomKind::triangular}};

bool with_moments(const RandomVariable& v) {
  return v.kind != RandomKind::uniform && v.kind != RandomKind::triangular;
}

TableSchema<RandomVariable> variable_schema() {
  using V = RandomVariable;
  TableSchema<V> table;
  table
      .key("acts_on", &V::acts_on, "",
           "key of the design that is random (section.friction, waves.design.height), or a factor: force (of P), "
           "uplift (of U), friction, weight, wave (of H), significant_height (of all heights), period, sliding (of S), "
           "or water_level, a rise (m); or a key of the model of soils of [dynamics], such as "
           "regions.seabed.shear_modulus")
      .required();
  table.choice("distribution", &V::kind, random_words, "distribution, for one occasion");
  const char* const moments = "in normal, lognormal, gumbel and weibull";
  table.key("mean", &V::mean, "", "mean before the ends are cut")
      .fallback("the number of the design; of a factor 1, of water_level 0")
      .when("distribution", with_moments, moments);
  table.key("cov", &V::cov, "", "standard deviation over mean; or deviation", above(0.))
      .when("distribution", with_moments, moments);
  table.key("deviation", &V::deviation, "", "standard deviation; or cov", above(0.))
      .when("distribution", with_moments, moments);
  table.key("location", &V::location, "", "least value of the distribution")
      .fallback("0")
      .when(
          "distribution", [](const V& v) { return v.kind == RandomKind::lognormal || v.kind == RandomKind::weibull; },
          "in lognormal and weibull");
  table.key("mode", &V::mode, "", "most likely value")
      .required()
      .when(
          "distribution", [](const V& v) { return v.kind == RandomKind::triangular; }, "in triangular");
  table.key("low", &V::low, "", "least value; all but uniform and triangular are cut there").fallback("not cut");
  table.key("high", &V::high, "", "largest value; all but uniform and triangular are cut there").fallback("not cut");
  return table;
}

TableSchema<RandomCorrelation> correlation_schema() {
  using C = RandomCorrelation;
  TableSchema<C> table;
  table.key("first", &C::first, "", "name of a variable").required();
  table.key("second", &C::second, "", "name of another variable").required();
  table
      .key("coefficient", &C::coefficient, "",
           "correlation of the standard normal variables behind the two (normal copula)", between(-1., 1.))
      .required();
  return table;
}

TableSchema<SystemNode> system_schema() {
  TableSchema<SystemNode> table;
  table.key("any", &SystemNode::any, "", "names of limit states and systems; it fails where any of them fails; or all");
  table.key("all", &SystemNode::all, "", "names of limit states and systems; it fails where all of them fail; or any");
  return table;
}

TableSchema<ReliabilityTargets> targets_schema() {
  using T = ReliabilityTargets;
  const Range share = between(0., 1.), index = from_to(-5., 10.);
  const std::string recalled = "; assumed: Japanese standard of 2007, importance normal, from memory";
  const std::string annex = "; assumed: EN 1990 Annex B, class RC2, from memory";
  const std::string pianc = "; assumed: PIANC WG 28, ultimate limit state, safety class normal, from memory";
  TableSchema<T> table;
  const auto declare = [&table](const char* name, std::optional<double> T::*member, const char* unit,
                                const Range& range, const std::string& meaning) {
    table.key(name, member, unit, meaning, range)
        .fallback(significant(*(assumed_targets.*member), 3) + ", told and not judged");
  };
  const std::string exceed = "most probability that S of a life exceeds ";
  declare("exceed_0_1", &T::exceed_0_1, "", share, exceed + "0.1 m" + recalled);
  declare("exceed_0_3", &T::exceed_0_3, "", share, exceed + "0.3 m" + recalled);
  declare("exceed_1_0", &T::exceed_1_0, "", share, exceed + "1.0 m" + recalled);
  declare("expected_sliding", &T::expected_sliding, "m", above(0.),
          "most expected sliding distance of a life; Shimosako and Takahashi (1998)");
  declare("pianc_life", &T::pianc_life, "", share, "most probability of failure in a life" + pianc);
  declare("eurocode_year", &T::eurocode_year, "", index, "least beta of a year" + annex);
  declare("eurocode_life", &T::eurocode_life, "", index, "least beta of a life of 50 years" + annex);
  return table;
}

void declare_work(TableSchema<ReliabilityTable>& table) {
  using R = ReliabilityTable;
  table.key("methods", &R::methods, "",
            "list of form, sorm, importance, subset, plain; plain sampling is the judge, and takes longest");
  table.key("seed", &R::seed, "", "seed of all samples; the same one gives the same numbers", from_to(0., 2147483647.));
  table.key("samples", &R::samples, "",
            "most samples of importance sampling, and samples of each level of subset sampling", from_to(1000., 1e7));
  table.key("plain_samples", &R::plain_samples, "", "samples of plain sampling", from_to(1000., 1e8));
}

}  // namespace

std::string word_of(RandomKind kind) {
  return std::find_if(random_words.begin(), random_words.end(), [kind](const auto& row) { return row.second == kind; })
      ->first;
}

const ReliabilityTargets assumed_targets{0.30, 0.10, 0.05, 0.30, 0.05, 4.7, 3.8};

const std::vector<std::string> reliability_methods{"form", "sorm", "importance", "subset", "plain"};

TableSchema<ReliabilityTable> reliability_schema() {
  using R = ReliabilityTable;
  TableSchema<R> table;
  table.key("wave", &R::wave, "", "name of [waves.NAME]: the wave of an occasion").fallback("the only one");
  table.key("years", &R::years, "years", "life of the structure", from_to(1e-3, 1e5));
  table.key("occasions_per_year", &R::occasions_per_year, "",
            "occasions in a year for which the variables are given; 1 where the wave is the highest of a year",
            from_to(1e-6, 1e6));
  table.key("target", &R::target, "", "least index beta of the system over the life", from_to(-5., 10.));
  table.key("dynamics", &R::dynamics, "",
            "limit states by F_T of the reduced model of [dynamics], too; always where a variable acts on its soil");
  declare_work(table);
  table.tables("variables", &R::variables, variable_schema()).doc("What is random, by name.");
  table.tables("correlations", &R::correlations, correlation_schema())
      .doc("Dependence of two variables, by any name; variables without one are independent.");
  table.tables("system", &R::system, system_schema())
      .doc("A fault tree, each of its gates by its name; without one the system fails where any limit state fails.");
  table.table("targets", &R::targets, targets_schema())
      .doc("What codes ask for: those that the file gives are judged; most defaults are assumed.");
  return table;
}

Diagnostics read_value(const Node& node, const KeyInfo& key, NameList& value) {
  if (node.array() && node.array()->empty())
    return {
        {node.place, key.name + ": expected " + type_text(key, &value) + ", found none", "give the " + key.meaning()}};
  return read_value(node, key, static_cast<std::vector<std::string>&>(value));
}

}  // namespace upbead
