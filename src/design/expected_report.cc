#include "design/expected_report.h"

#include <cmath>

#include "base/text.h"
#include "output/limits.h"
#include "output/output_text.h"
#include "output/result_file.h"

namespace upbead {

namespace {

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

std::string brief(const Design& design, const ExpectedAnswer& answer, const Json& summary) {
  std::string text = design.tables.title + "\n";
  for (const RecordSummary& r : answer.notes.read)
    text += "read        " + r.column + " of " + r.file + " in " + r.unit + ", largest " + significant(r.extreme, 4) +
            "; " + r.layout + "\n";
  std::vector<std::string> keys{"model"};
  const auto add = [&keys](const std::string& of, const std::vector<std::string>& inside) {
    for (const std::string& key : inside) keys.push_back(of + "." + key);
  };
  if (design.tables.sea)
    add("expected",
        {"headline", "years", "distance_paper", "distance_exact", "distance_combined", "distance_dynamic",
         "threshold_height", "highest", "limit", "share_limited", "base.goda", "base.dynamic", "base.why_not_dynamic"});
  const std::vector<std::string> by_law{"law", "mean", "confidence_interval", "quantiles"};
  if (answer.monte_carlo) {
    add("monte_carlo", {"headline", "lives", "years", "limit", "share_limited"});
    add("monte_carlo", by_law);
    add("monte_carlo", {"without_scatter", "probability", "base", "why_no_base", "ways"});
  }
  if (answer.formula_lives) add("monte_carlo.by_formulas", by_law);
  if (answer.nodes) add("nodes", {"mean", "confidence_interval", "block", "ratio", "ground_error", "waves"});
  if (!answer.why_no_nodes.empty()) keys.emplace_back("why_no_nodes");
  keys.emplace_back("exceedance");
  Checks checks = checks_of(design, answer);
  append(checks, unjudged_limits(design.tables.limits, checks, false));
  return text + text_of(summary, rows_of_expected(), keys) +
         verdict_text(verdict_of(checks, warnings_of(design, answer)), checks);
}

}  // namespace upbead
