#include "design/expected_report.h"

#include <cmath>

#include "base/format.h"
#include "base/text.h"
#include "output/result_file.h"

namespace upbead {

namespace {

constexpr int few_lives = 50;  // that slide: a normal distribution of their mean is then doubtful

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

std::string describe(const MonteCarlo& found, const LifeTable& life) {
  const LifeStatistics& s = found.statistics;
  std::string text = format("life        %d lives of %.4g years, law %s, seed %d; %s waves, S computed for %s\n",
                            life.lives, life.years, word(found.law), life.seed, significant(found.waves).c_str(),
                            significant(found.answered).c_str());
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
  return text;
}

std::string describe_record(const SeaTable& sea, const ExpectedAnswer& answer) {
  std::string text =
      format("sea         %d sea states, %s waves in %.4g years, the highest %.2f m (one wave is higher)\n",
             static_cast<int>(answer.states.size()), significant(answer.waves, 4).c_str(), sea.years, answer.highest);
  for (const Exceedance& e : answer.exceedance)
    text += format("  H > %.4g m  %.4g waves (%s)\n", e.height, e.waves, e.name.c_str());
  text += format("expected    sum of S in %.4g years   waves that slide   from H\n", sea.years);
  for (const auto& [law, found] : answer.total)
    text += format("  %-9s %-14s %-12s %-18.4g ", word(law), meaning(law), with_unit(found.distance, "m").c_str(),
                   found.sliding_waves) +
            (std::isfinite(found.threshold) ? format("%.2f m\n", found.threshold) : "none slides\n");
  return text;
}

void add_curves(const HeightCurves& curves, std::vector<Dataset>& datasets) {
  datasets.push_back({"heights/height", "m", "height of waves", curves.height});
  datasets.push_back({"heights/waves", "1/m", "number of waves of all sea states per metre of height", curves.waves});
  for (const auto& [law, values] : curves.distance)
    datasets.push_back({std::string("heights/distance/") + word(law), "m",
                        "S of a wave of the sea state that brings most, by its height", values});
  for (const auto& [law, values] : curves.contribution)
    datasets.push_back({std::string("heights/contribution/") + word(law), "1",
                        "part of the expected distance of that sea state per metre of height", values});
  if (curves.peak_force.empty()) return;
  datasets.push_back({"heights/peak_force", "N/m", "largest P of the law dynamic", curves.peak_force});
  datasets.push_back({"heights/peak_shear", "N/m", "largest F_T of the law dynamic", curves.peak_shear});
}

}  // namespace

std::string expected_file(const Design& design, const ExpectedAnswer& answer) {
  std::vector<Dataset> datasets;
  if (!answer.states.empty()) add_curves(answer.curves, datasets);
  if (answer.monte_carlo)
    datasets.push_back({"lives/sliding", "m", "S of each life, sum of all its waves", answer.monte_carlo->sliding});
  return dataset_file(design.tables.title, datasets);
}

std::string describe(const Design& design, const ExpectedAnswer& answer) {
  std::string text = design.tables.title + "\n";
  if (answer.model)
    text += format("model       %s, load %s, steps of %.3g ms\n", answer.model->title.c_str(),
                   answer.model->load.c_str(), 1e3 * answer.model->step);
  if (design.tables.sea) text += describe_record(*design.tables.sea, answer);
  if (answer.monte_carlo) text += describe(*answer.monte_carlo, *design.tables.life);
  return text;
}

std::string notes_and_warnings(const ExpectedAnswer& answer) {
  std::string text;
  for (const LeftOut& part : answer.notes.left_out) text += "note: " + part.what + ": " + part.why + "\n";
  if (!answer.monte_carlo) return text;
  const LifeStatistics& s = answer.monte_carlo->statistics;
  if (s.sliding_lives >= few_lives) return text;
  return text + "warning: only " + std::to_string(s.sliding_lives) + " of " +
         std::to_string(answer.monte_carlo->sliding.size()) +
         " lives slide: mean and interval rest on few of them; simulate more with --set life.simulated_lives=NUMBER\n";
}

}  // namespace upbead
