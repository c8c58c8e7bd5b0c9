#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "design/design.h"
#include "model/quantities.h"

namespace upbead {

namespace {

/// What two kinds of tables have in common: a random factor, or a random number of the design.
struct Drawn {
  std::string path;                 ///< "scatter.force"
  double middle;                    ///< mean, most likely value or middle of both ends
  bool has_mean;                    ///< or the middle is of its ends
  std::optional<double> variation;  ///< deviation over mean
  std::optional<double> low, high;
};

template <class T>
Drawn drawn(const std::string& path, const T& table, double certain) {
  Drawn d{path, table.mean.value_or(certain), true, table.cov, table.low, table.high};
  const bool by_ends = !table.cov && !table.deviation && table.low && table.high;
  if (by_ends) d.middle = table.mode.value_or(0.5 * (*table.low + *table.high));
  if (by_ends) d.has_mean = false;
  if (table.deviation && d.middle != 0.) d.variation = *table.deviation / std::abs(d.middle);
  return d;
}

std::string words_of_middle(const Drawn& d) {
  return d.has_mean ? d.path + ".mean" : "the middle of " + d.path;
}

/// A range around the number that is sure.
Quantity around(double sure, double low, double high, const char* unit, const char* usual) {
  return {unit, low * sure, high * sure, 0.8 * sure, 1.25 * sure, {{"percent", 1e-2}}, usual};
}

/// Factors: Goda's forces 0.9, friction 1.06 with 0.16 [Takayama and Ikeda 1992], weights 0.98 to 1.02; mu or W in
/// place of its factor is beyond the narrower range.
Quantity of_factor(const std::string& name) {
  const bool narrow = name == "friction" || name == "weight";
  return around(1., narrow ? 0.7 : 0.4, narrow ? 1.4 : 2.5, "1", "it is a factor, and 1 changes nothing");
}

/// A cut that takes away more than half of the distribution was given in another unit, or at the wrong end.
void judge_ends(const Drawn& d, NumberedWarnings& list) {
  if (!d.has_mean) return;
  const auto add = [&](const char* end, double value, const char* side) {
    list.push_back({"implausible", value, d.middle, "1",
                    d.path + "." + end + " = " + significant(value, 4) + " is " + side + " the mean, " +
                        significant(d.middle, 4) + ": more than half of the distribution is cut away",
                    "check " + d.path + "." + end + " and its unit", true});
  };
  if (d.high && *d.high < d.middle) add("high", *d.high, "below");
  if (d.low && *d.low > d.middle) add("low", *d.low, "above");
}

void judge_variation(const Drawn& d, NumberedWarnings& list) {
  judge("the coefficient of variation of " + d.path, d.variation,
        {"1", 0., 1., 0.01, 0.6, {{"percent", 1e-2}}, "of heights, forces and friction 0.05 to 0.3 are usual"}, list);
}

/// A rise beyond the crest, or below the mound, is a depth or was given in another unit.
void judge_rise(const Drawn& d, const Section& section, NumberedWarnings& list) {
  const double lowest = -std::min(section.berm_depth, section.foundation_depth);
  if (d.middle > lowest && d.middle < section.crest) return;
  list.push_back({"implausible", d.middle, d.middle > 0. ? section.crest : lowest, "m",
                  words_of_middle(d) + " = " + significant(d.middle, 4) + " m, a rise of still water, is " +
                      (d.middle > 0. ? "above the crest" : "below the mound"),
                  "check it and its unit", true});
}

/// Numbers that a variable may act on lie near those of the design.
void judge_number(const Drawn& d, const DesignTables& tables, const std::string& acts_on, NumberedWarnings& list) {
  const double own = certain_value(tables, acts_on).value_or(0.);
  const bool of_section = acts_on.rfind("section.", 0) == 0 || acts_on.rfind("fluid.", 0) == 0;
  const double far = of_section ? 2. : acts_on.rfind("waves.", 0) == 0 ? 3. : 30.;
  Quantity q{"1",
             own / far,
             own * far,
             0.7 * own,
             1.4 * own,
             {{"percent", 1e-2}, {"thousands", 1e3}, {"millions", 1e6}},
             "the design has another number"};
  if (own > 0.) judge(words_of_middle(d), d.middle, q, list);
}

void judge_highest(const std::string& path, const HighestWave& highest, NumberedWarnings& list) {
  // of a hundred waves of a Rayleigh distribution
  const Quantity q{"1", 1.5, 10., 1.6, 3., {{"percent", 1e-2}}, "the highest of a hundred waves has 1.5 H_1/3"};
  if (!highest.breaking) judge(path, highest.cut, q, list);
}

}  // namespace

NumberedWarnings implausible_distributions(const DesignTables& tables) {
  NumberedWarnings list;
  const auto factor_or_rise = [&](const std::string& name, const Drawn& d) {
    if (name == "water_level") return judge_rise(d, tables.section, list);
    judge(words_of_middle(d), d.middle, of_factor(name), list);
    judge_variation(d, list);
  };
  for (const NamedScatter& named : named_scatters())
    if (const std::optional<Scatter>& scatter = tables.scatter.*named.table) {
      const Drawn d = drawn(dotted("scatter", named.name), *scatter, named.mean);
      factor_or_rise(named.name, d);
      judge_ends(d, list);
    }
  if (tables.sea) judge_highest("sea.highest", tables.sea->highest, list);
  if (tables.storms) judge_highest("storms.highest", tables.storms->highest, list);
  if (!tables.reliability) return list;
  for (const auto& [name, variable] : tables.reliability->variables) {
    const Drawn d =
        drawn(dotted("reliability.variables", name), variable, certain_value(tables, variable.acts_on).value_or(0.));
    judge_ends(d, list);
    const bool of_soil = variable.acts_on.rfind("regions.", 0) == 0;  // its numbers are those of the model's file
    if (of_soil || variable.acts_on == "sliding") continue;           // and S scatters by a multiple
    if (find_factor(variable.acts_on)) {
      factor_or_rise(variable.acts_on, d);
    } else {
      judge_number(d, tables, variable.acts_on, list);
      judge_variation(d, list);
    }
  }
  return list;
}

}  // namespace upbead
