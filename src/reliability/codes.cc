#include <algorithm>

#include "base/text.h"
#include "design/expected_report.h"
#include "reliability/answer.h"

namespace upbead {

namespace {

const char* const japanese = "Japan";

/// S of whole lives, where the design asks for them.
std::vector<CodeRow> rows_of_lives(const Design& design) {
  const ReliabilityTargets& targets = design.tables.reliability->targets;
  std::vector<CodeRow> rows;
  const std::string source = "assumed: Japanese standard of 2007, importance normal";
  for (const auto& [limit, target] :
       {std::pair(0.1, targets.exceed_0_1), std::pair(0.3, targets.exceed_0_3), std::pair(1., targets.exceed_1_0)})
    rows.push_back({japanese,
                    "S of all waves of a life above " + significant(limit, 3) + " m",
                    "",
                    {},
                    target,
                    false,
                    source,
                    ""});
  rows.push_back({japanese,
                  "expected sliding distance of a life",
                  "m",
                  {},
                  targets.expected_sliding,
                  false,
                  "Shimosako and Takahashi (1998)",
                  ""});
  if (!design.tables.life) {
    for (CodeRow& row : rows) row.why_not = "no [life]: S of whole lives is that of `upbead expected`";
    return rows;
  }
  const LifeStatistics lives = find_expected(design).monte_carlo->statistics;
  rows.back().value = lives.mean;
  for (std::size_t i = 0; i < 3; ++i) rows[i].value = lives.exceeded[i].probability;
  return rows;
}

/// One wave alone: no more than S of all waves of that life.
CodeRow row_of_wave(const ReliabilityAnswer& answer, const std::string& mode, const std::string& limit) {
  const ModeAnswer& found = mode_of(answer, mode);
  CodeRow row{japanese, "S of one wave of a life above " + limit, "", found.life.probability, {}, false, "", ""};
  row.why_not = row.value ? "" : found.why_not;
  return row;
}

}  // namespace

std::vector<CodeRow> code_rows(const Design& design, const ReliabilityAnswer& answer) {
  const ReliabilityTargets& targets = design.tables.reliability->targets;
  std::vector<CodeRow> rows = rows_of_lives(design);
  rows.push_back(row_of_wave(answer, "sliding_0_1", "0.1 m"));
  rows.push_back(row_of_wave(answer, "sliding_0_3", "0.3 m"));
  rows.push_back(row_of_wave(answer, "sliding_1_0", "1 m"));
  const ModeAnswer& system = mode_of(answer, answer.system);
  const std::string of = "of the system " + system.name + words_of_left_out(answer);
  const std::string annex = "assumed: EN 1990 Annex B, class RC2";
  rows.push_back({"PIANC WG 28", "probability " + of + " in a life", "", system.life.probability, targets.pianc_life,
                  false, "assumed: ultimate limit state, safety class normal", system.why_not});
  rows.push_back({"Eurocode", "beta " + of + " in a year", "", system.year.index, targets.eurocode_year, true, annex,
                  system.why_not});
  rows.push_back({"Eurocode", "beta " + of + " in a life", "", system.life.index, targets.eurocode_life, true, annex,
                  system.why_not});
  return rows;
}

}  // namespace upbead
