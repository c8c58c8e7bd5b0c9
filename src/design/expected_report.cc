#include "design/expected_report.h"

#include <algorithm>
#include <cmath>

#include "base/format.h"
#include "base/text.h"
#include "output/result_file.h"

namespace upbead {

namespace {

const char* meaning(Law law) {
  switch (law) {
    case Law::paper:
      return "eq. (7)";
    case Law::exact:
      return "eqs. (4), (6)";
    case Law::combined:
      return "combined";
    case Law::dynamic:
      break;
  }
  return "own dynamics";
}

/// "10.86 m", "10.7 to 11.4 m"; "" where no sea state has a limit.
std::string range_of_limits(const std::vector<StateAnswer>& states) {
  double low = HUGE_VAL, high = 0.;
  for (const StateAnswer& s : states) {
    low = std::min(low, s.heights.highest());
    if (std::isfinite(s.heights.highest())) high = std::max(high, s.heights.highest());
  }
  if (low > high) return "";
  return (low < high ? significant(low, 4) + " to " : "") + significant(high, 4) + " m";
}

/// Number of waves at the limit, in the sea state with the highest limit.
double waves_at_limit(const std::vector<StateAnswer>& states) {
  const auto highest = std::max_element(states.begin(), states.end(), [](const StateAnswer& a, const StateAnswer& b) {
    return a.heights.highest() < b.heights.highest();
  });
  return highest->state.waves * highest->heights.at_limit();
}

std::string limit_text(const HighestWave& highest, const ExpectedAnswer& answer) {
  const std::string taken = some_of(answer.taken, answer.all);
  if (!highest.breaking && highest.cut == RayleighHeights::no_cut) return "  limit       none, as asked\n";
  if (!highest.breaking)
    return "  limit       " + significant(highest.cut) + " H_1/3: " + taken + " are higher and set aside\n";
  const std::string range = range_of_limits(answer.states);
  if (range.empty()) return "  limit       none: the water is too deep for breaking (h/L_0 >= 0.2)\n";
  return "  limit       Goda's highest breaker, " + range + ": " + taken + " are higher and break to it\n";
}

std::string kilopascals(double pressure) {
  return std::isfinite(pressure) ? significant(pressure / 1e3, 4) + " kPa" : "none: the resultant leaves the base";
}

std::string margin_text(double margin) {
  return std::isfinite(margin) ? significant(margin, 3) : "none";
}

std::string text_of(const char* how, const WorstBase& base) {
  return "  " + std::string(how) + std::string(12 - std::string(how).size(), ' ') + "heel " +
         kilopascals(base.heel_pressure) + ", toe " + kilopascals(base.toe_pressure) + ", eccentricity " +
         significant(base.eccentricity, 3) + " m, overturning margin " + margin_text(base.overturning_margin) + "\n";
}

/// "600 kPa: 3.2 % of the lives, 95 % between 2.5 and 4.1 %".
std::string text_of(const Exceeded& beyond, const std::string& limit) {
  return limit + format(": %.4g %% of the lives, 95 %% between %.3g and %.3g %%\n", 100. * beyond.probability,
                        100. * beyond.interval[0], 100. * beyond.interval[1]);
}

std::string text_of(const char* what, const WorstOfLives& worst, std::string (*number)(double),
                    const std::string& beyond) {
  std::string text = format("  %-11s mean ", what) + number(worst.statistics.mean);
  for (const Quantile& q : worst.statistics.quantiles)
    text += format("  %g %%: ", 100. * q.probability) + number(q.value);
  text += "\n";
  if (worst.beyond) text += "    " + beyond + " " + text_of(*worst.beyond, number(worst.beyond->limit));
  return text;
}

std::string text_of(const BaseOfLives& base) {
  return text_of("heel", base.heel_pressure, kilopascals, "above") +
         text_of("toe", base.toe_pressure, kilopascals, "above") +
         text_of("margin", base.overturning_margin, margin_text, "below");
}

/// Of those ways that only lives with slip circles know.
std::string text_of(const WaysOfLives& ways) {
  return "  every way to fail, under the worst wave of each storm (" + significant(ways.waves, 6) +
         " waves answered; a lower one is up to " + significant(100. * ways.lower_worse, 2) +
         " % less safe); the least of a life:\n" + text_of("circles", ways.circles, margin_text, "below") +
         text_of("mu N'/F_T", ways.sliding, margin_text, "below") +
         text_of("seaward", ways.sliding_seaward, margin_text, "below") +
         text_of("overturning", ways.overturning, margin_text, "below");
}

std::string text_of(const MonteCarlo& found, const LifeTable& life) {
  const LifeStatistics& s = found.statistics;
  std::string text = format("life        %d lives of %.4g years, law %s, seed %d; %s waves, S computed for %s\n",
                            life.lives, life.years, word(found.law), life.seed, significant(found.waves).c_str(),
                            significant(found.answered).c_str());
  if (found.taken > 0.)
    text +=
        "  limit       " + some_of(found.taken, found.waves) + " were higher" +
        (found.highest > 0. ? "; of those whose S was computed the highest is " + significant(found.highest, 4) + " m\n"
                            : "\n");
  text += "  mean S      " + with_unit(s.mean, "m") + ", 95 % between " + with_unit(s.interval[0], "m") + " and " +
          with_unit(s.interval[1], "m");
  if (found.without_scatter) text += "; without scatter " + with_unit(*found.without_scatter, "m");
  text += "\n  quantiles   ";
  for (const Quantile& q : s.quantiles)
    text += format("%g %%: ", 100. * q.probability) + with_unit(q.value, "m") + "  ";
  text += "\n";
  for (const Exceeded& e : s.exceeded)
    text += format("  S > %-4g m  %.4g %%, 95 %% between %.3g and %.3g %%\n", e.limit, 100. * e.probability,
                   100. * e.interval[0], 100. * e.interval[1]);
  text += found.base ? text_of(*found.base) : "  heel        no value: " + found.why_no_base + "\n";
  return text + (found.ways ? text_of(*found.ways) : "");
}

std::string text_of(const Headline& headline) {
  return "S = " + with_unit(headline.value, "m") + " by the law " + word(headline.law) + ": " + headline.why + "\n";
}

std::string record_text(const SeaTable& sea, const ExpectedAnswer& answer) {
  std::string text = format("sea         %d sea states, %s waves in %.4g years, the highest %.2f m (%s)\n",
                            static_cast<int>(answer.states.size()), significant(answer.waves, 4).c_str(), sea.years,
                            answer.highest, waves_at_limit(answer.states) < 1. ? "one wave is higher" : "the limit");
  text += limit_text(sea.highest, answer);
  for (const Exceedance& e : answer.exceedance)
    text += format("  H > %.4g m  %.4g waves (%s)\n", e.height, e.waves, e.name.c_str());
  text += format("expected    sum of S in %.4g years   waves that slide   from H\n", sea.years);
  for (const auto& [law, found] : answer.total)
    text += format("  %-9s %-14s %-12s %-18.4g ", word(law), meaning(law), with_unit(found.distance, "m").c_str(),
                   found.sliding_waves) +
            (std::isfinite(found.threshold) ? format("%.2f m", found.threshold) : "none slides") +
            (found.broken > 0. ? "; " + with_unit(found.broken, "m") + " by waves at the limit\n" : "\n");
  text += "base        in the highest wave of the worst sea state, " + significant(answer.base.height, 4) + " m\n" +
          text_of("by formulas", answer.base.goda);
  if (answer.base.dynamic) text += text_of("dynamic", *answer.base.dynamic);
  return text;
}

/// A dataset of the base; infinite values, where the base carries nothing, become NaN.
Dataset some_of_base(const std::string& name, const std::string& unit, const std::string& what,
                     std::vector<double> values) {
  for (double& value : values)
    if (std::isinf(value)) value = NAN;
  Dataset data{name, unit, what + "; no number where the resultant leaves the base, or nothing overturns", values};
  data.may_lack = true;
  return data;
}

void add_curves(const HeightCurves& curves, std::vector<Dataset>& datasets) {
  datasets.push_back({"heights/height", "m", "height of waves", curves.height});
  datasets.push_back({"heights/waves", "1/m", "number of waves of all sea states per metre of height", curves.waves});
  for (const auto& [law, values] : curves.distance)
    datasets.push_back({std::string("heights/distance/") + word(law), "m",
                        "S of a wave of the sea state that brings most, by its height", values});
  for (const auto& [law, values] : curves.contribution)
    datasets.push_back(
        {std::string("heights/contribution/") + word(law), "1",
         "part of the expected distance of that sea state per metre of height, without waves at the limit", values});
  datasets.push_back(some_of_base("heights/heel_pressure", "Pa", "heel pressure of such a wave by Goda's formulas",
                                  curves.heel_pressure));
  if (curves.peak_force.empty()) return;
  datasets.push_back({"heights/peak_force", "N/m", "largest P of the law dynamic", curves.peak_force});
  datasets.push_back({"heights/peak_shear", "N/m", "largest F_T of the law dynamic", curves.peak_shear});
}

}  // namespace

std::string some_of(double some, double all) {
  return significant(some, 4) + " of " + significant(all, 4) + " waves (" + significant(100. * share_of(some, all), 2) +
         " %)";
}

const char* word(const HighestWave& highest) {
  if (highest.breaking) return "breaking";
  return highest.cut == RayleighHeights::no_cut ? "none" : "cut";
}

std::string expected_file(const Design& design, const ExpectedAnswer& answer) {
  std::vector<Dataset> datasets;
  if (!answer.states.empty()) add_curves(answer.curves, datasets);
  if (answer.monte_carlo)
    datasets.push_back({"lives/sliding", "m", "S of each life, sum of all its waves", answer.monte_carlo->sliding});
  if (answer.formula_lives)
    datasets.push_back({"lives/sliding_by_formulas", "m", "the same by the law exact, without the ground",
                        answer.formula_lives->sliding});
  if (answer.monte_carlo && answer.monte_carlo->base) {
    const BaseOfLives& base = *answer.monte_carlo->base;
    datasets.push_back(some_of_base("lives/heel_pressure", "Pa", "largest of each life", base.heel_pressure.values));
    datasets.push_back(some_of_base("lives/toe_pressure", "Pa", "largest of each life", base.toe_pressure.values));
    datasets.push_back(some_of_base("lives/eccentricity", "m", "largest of each life", base.eccentricity.values));
    datasets.push_back(
        some_of_base("lives/overturning_margin", "1", "least of each life", base.overturning_margin.values));
  }
  if (answer.monte_carlo && answer.monte_carlo->ways) {
    const WaysOfLives& ways = *answer.monte_carlo->ways;
    const std::string least = "least of each life, by the worst wave of each storm";
    datasets.push_back(some_of_base("lives/ways/circles", "1", "F of slip circles, " + least, ways.circles.values));
    datasets.push_back(some_of_base("lives/ways/sliding_factor", "1", "mu N'/F_T, " + least, ways.sliding.values));
    datasets.push_back(
        some_of_base("lives/ways/sliding_factor_seaward", "1", "the same seaward", ways.sliding_seaward.values));
    datasets.push_back(some_of_base("lives/ways/overturning_margin", "1", "margin, " + least, ways.overturning.values));
  }
  return dataset_file(design.tables.title, datasets);
}

std::string text_of(const Design& design, const ExpectedAnswer& answer) {
  std::string text = design.tables.title + "\n";
  if (answer.model)
    text += format("model       %s, load %s, steps of %.3g ms\n", answer.model->title.c_str(),
                   answer.model->load.c_str(), 1e3 * answer.model->step);
  if (design.tables.sea) text += record_text(*design.tables.sea, answer);
  for (const RecordSummary& r : answer.notes.read)
    text += "  read        " + r.column + " of " + r.file + " in " + r.unit + ", largest " + significant(r.extreme, 4) +
            "; " + r.layout + "\n";
  if (answer.monte_carlo) text += text_of(*answer.monte_carlo, *design.tables.life);
  if (answer.formula_lives) text += text_of(*answer.formula_lives, *design.tables.life);
  if (!answer.total.empty()) text += "headline    expected " + text_of(headline_of(answer.total));
  if (answer.monte_carlo)
    text += "headline    of a life " + text_of(headline_of(*answer.monte_carlo, answer.formula_lives));
  const Checks checks = checks_of(design, answer);
  return text + verdict_text(verdict_of(checks, warnings_of(design, answer)), checks);
}

}  // namespace upbead
