
#include "base/text.h"
#include "design/expected_report.h"
#include "reliability/answer.h"

namespace upbead {

namespace {

const char* const japanese = "Japan";

using Target = std::optional<double> ReliabilityTargets::*;

/// A row with its target: that of the file, or the assumed one, whose source is told.
CodeRow row_with(const Design& design, const std::string& code, const std::string& what, Target target,
                 const std::string& source) {
  CodeRow row;
  row.code = code;
  row.what = what;
  const std::optional<double>& given = design.tables.reliability->targets.*target;
  row.given = given.has_value();
  row.target = row.given ? given : assumed_targets.*target;
  row.source = row.given ? "given by the file" : source;
  return row;
}

/// Warning years_differ: S of whole lives is of other years than all other rows.
NumberedWarnings years_differ(const DesignTables& tables) {
  const double life = tables.life->years, years = tables.reliability->years;
  if (life == years) return {};
  return {{"years_differ", life, years, "years",
           "S of all waves of a life is of [life] years = " + significant(life, 4) +
               ", all other probabilities of a life are of [reliability] years = " + significant(years, 4),
           "give both tables the same years"}};
}

/// S of whole lives, where the design asks for them, and what is doubtful in it.
std::vector<CodeRow> rows_of_lives(const Design& design, NumberedWarnings& doubts) {
  using T = ReliabilityTargets;
  std::vector<CodeRow> rows;
  for (const auto& [limit, target] :
       {std::pair(0.1, &T::exceed_0_1), std::pair(0.3, &T::exceed_0_3), std::pair(1., &T::exceed_1_0)})
    rows.push_back(row_with(design, japanese, "S of all waves of a life above " + significant(limit, 3) + " m", target,
                            "assumed: Japanese standard of 2007, importance normal"));
  rows.push_back(row_with(design, japanese, "expected sliding distance of a life", &T::expected_sliding,
                          "Shimosako and Takahashi (1998)"));
  rows.back().unit = "m";
  if (!design.tables.life) {
    for (CodeRow& row : rows) row.why_not = "no [life]: S of whole lives is that of `upbead expected`";
    return rows;
  }
  const ExpectedAnswer expected = find_expected(design);
  const LifeStatistics& lives = expected.monte_carlo->statistics;
  doubts = years_differ(design.tables);
  append(doubts, warnings_of(design, expected));
  rows.back().value = lives.mean;
  for (std::size_t i = 0; i < 3; ++i) rows[i].value = lives.exceeded[i].probability;
  return rows;
}

/// One wave alone: no more than S of all waves of that life.
CodeRow row_of_wave(const ReliabilityAnswer& answer, const std::string& mode, const std::string& limit) {
  const ModeAnswer& found = mode_of(answer, mode);
  CodeRow row;
  row.code = japanese;
  row.what = "S of one wave of a life above " + limit;
  row.value = found.life.probability;
  row.why_not = row.value ? "" : found.why_not;
  return row;
}

}  // namespace

std::vector<CodeRow> code_rows(const Design& design, ReliabilityAnswer& answer) {
  using T = ReliabilityTargets;
  std::vector<CodeRow> rows = rows_of_lives(design, answer.lives);
  rows.push_back(row_of_wave(answer, "sliding_0_1", "0.1 m"));
  rows.push_back(row_of_wave(answer, "sliding_0_3", "0.3 m"));
  rows.push_back(row_of_wave(answer, "sliding_1_0", "1 m"));
  const ModeAnswer& system = mode_of(answer, answer.system);
  const std::string of = "of the system " + system.name + words_of_left_out(answer);
  const auto add = [&](CodeRow row, const std::optional<double>& value) {
    row.value = value;
    row.why_not = system.why_not;
    rows.push_back(row);
  };
  const std::string annex = "assumed: EN 1990 Annex B, class RC2";
  add(row_with(design, "PIANC WG 28", "probability " + of + " in a life", &T::pianc_life,
               "assumed: ultimate limit state, safety class normal"),
      system.life.probability);
  CodeRow year = row_with(design, "Eurocode", "beta " + of + " in a year", &T::eurocode_year, annex);
  CodeRow life = row_with(design, "Eurocode", "beta " + of + " in a life", &T::eurocode_life, annex);
  year.at_least = life.at_least = true;
  add(year, system.year.index);
  add(life, system.life.index);
  return rows;
}

}  // namespace upbead
