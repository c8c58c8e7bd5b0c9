// The sheet of a section: the checks of all its waves by formulas, of its run and of its life, in one table.
#pragma once

#include <string>
#include <vector>

#include "output/checks.h"
#include "upbead/model/scene.h"

namespace upbead {

struct OutputRow;

/// What one command says of the section.
struct SheetPart {
  std::string name;  ///< "waves", "run", "expected", "reliability"
  Checks checks;
  NumberedWarnings warnings;
  std::string why_not;  ///< the file does not ask for it; "" where it was done
};

/// A check in its place on the sheet.
struct SheetRow {
  std::string mode;  ///< the way to fail: "sliding landward", "heel pressure"
  std::string part;  ///< name of the part that made the check
  Check check;
  bool governs = false;  ///< the worst of its mode
};

/// Measures of one way to fail, of which some hold. All stand, and the worst governs.
struct Disagreement {
  std::string mode, fails;         ///< the check that governs, in words
  std::vector<std::string> holds;  ///< names of those that hold
};

struct Sheet {
  std::string title;
  std::vector<SheetPart> parts;
  std::vector<SheetRow> rows;  ///< by mode, the governing one first
  std::vector<Disagreement> disagreements;
  NumberedWarnings warnings;             ///< of all parts
  Verdict verdict;                       ///< of all checks and warnings
  std::vector<std::string> not_covered;  ///< ways to fail that no part looks at
};

/// Adds what was not told before: two parts may have a scene in common, and what is told of one wave is not told of the
/// section again.
void append_new(NumberedWarnings& list, const NumberedWarnings& more);

/// No check is left out, and no limit that none judges: one with a way to fail of its own stands by itself.
Sheet sheet_of(const std::string& title, std::vector<SheetPart> parts, const Limits& limits);

/// The table in at most 100 columns, the disagreements, what is not covered, the verdict.
std::string text_of(const Sheet& sheet);
/// The same as Markdown.
std::string markdown(const Sheet& sheet);
/// summary.json without the summaries of the parts. Throws NumericsError where a number is not finite.
Json to_json(const Sheet& sheet);
/// The keys of that JSON.
std::vector<OutputRow> rows_of_sheet();

}  // namespace upbead
