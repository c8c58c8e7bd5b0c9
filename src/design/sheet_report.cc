// The sheet as text, as Markdown and as JSON.
#include <algorithm>
#include <numeric>
#include <tuple>

#include "base/text.h"
#include "design/sheet.h"
#include "output/output_schema.h"

namespace upbead {

namespace {

using Cells = std::vector<std::string>;

/// Two numbers as they are compared; one that is missing in words.
std::pair<std::string, std::string> both(const std::optional<double>& demand, const std::optional<double>& capacity,
                                         const std::string& unit, int digits, const char* no_demand) {
  if (demand && capacity) digits = digits_apart(*demand, *capacity, digits);
  return {demand ? with_unit(*demand, unit, 0., digits) : no_demand,
          capacity ? with_unit(*capacity, unit, 0., digits) : "no limit"};
}

/// Demand and capacity of a check as they are compared, with the factor and that which is required.
struct Compared {
  std::string demand, capacity, factor, required, outcome;
};

Compared compared(const Check& check) {
  Compared c;
  const bool factor = check.at_least && check.unit.empty();
  if (check.balance) {
    std::tie(c.demand, c.capacity) = both(check.balance->acting, check.balance->resisting, check.balance->unit, 4, "");
  } else if (check.probability) {
    c.demand = "P " + significant(*check.probability, 3);
  } else if (!factor) {
    std::tie(c.demand, c.capacity) = both(check.demand, check.capacity, check.unit, 4, "without bound");
  }
  if (factor) {
    std::tie(c.factor, c.required) = both(check.demand, check.capacity, "", 3, "not found");
  } else if (check.capacity) {
    c.factor = check.margin ? margin_text(*check.margin) : "";
    c.required = "1";
  }
  c.outcome = !check.holds ? "-" : *check.holds ? "holds" : "FAILS";
  return c;
}

/// demand, capacity, factor, required, outcome, measure
Cells cells_of(const SheetRow& row) {
  const Compared c = compared(row.check);
  return {c.demand, c.capacity, c.factor, c.required, c.outcome, row.part + ", " + row.check.by};
}

const Cells head{"demand", "capacity", "factor", "required", "result", "by"};

std::vector<std::size_t> widths(const Sheet& sheet) {
  std::vector<std::size_t> width;
  for (const std::string& cell : head) width.push_back(cell.size());
  for (const SheetRow& row : sheet.rows) {
    if (!row.check.why_not.empty()) continue;
    const Cells cells = cells_of(row);
    for (std::size_t i = 0; i < cells.size(); ++i) width[i] = std::max(width[i], cells[i].size());
  }
  return width;
}

/// All but the last column aligned to the right.
std::string line_of(const Cells& cells, const std::vector<std::size_t>& width) {
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i)
    line += "  " + (i + 1 < cells.size() ? std::string(width[i] - cells[i].size(), ' ') : "") + cells[i];
  return line;
}

/// The name, then its cells from the column `begin` on; below it where it is longer.
std::string entry_of(const std::string& name, const std::string& cells, std::size_t begin) {
  return name + (name.size() <= begin ? std::string(begin - name.size(), ' ') : "\n" + std::string(begin, ' ')) +
         cells + "\n";
}

/// Where the cells begin, so that lines have at most 100 columns.
std::size_t begin_of(const std::vector<std::size_t>& width) {
  const std::size_t cells = std::accumulate(width.begin(), width.end(), 2 * width.size());
  constexpr std::size_t widest = 100;
  return cells < widest ? widest - cells : 0;
}

std::string table_of(const Sheet& sheet) {
  const std::vector<std::size_t> width = widths(sheet);
  const std::size_t begin = begin_of(width);
  std::string text = entry_of("way to fail, * governs", line_of(head, width), begin), mode;
  for (const SheetRow& row : sheet.rows) {
    if (row.mode != mode) text += (mode = row.mode) + "\n";
    const std::string name = std::string(row.governs ? "* " : "  ") + name_of(row.check);
    text += row.check.why_not.empty() ? entry_of(name, line_of(cells_of(row), width), begin)
                                      : name + ": not checked: " + row.check.why_not + "\n";
  }
  return text;
}

/// What the file does not ask for, what the program does not look at.
std::vector<std::string> missing(const Sheet& sheet) {
  std::vector<std::string> list;
  for (const SheetPart& part : sheet.parts)
    if (!part.why_not.empty()) list.push_back(part.name + ": " + part.why_not);
  return list;
}

std::string list_of(const std::string& title, const std::vector<std::string>& lines, const std::string& mark) {
  std::string text = lines.empty() ? "" : title + "\n";
  for (const std::string& line : lines) text += mark + line + "\n";
  return text;
}

std::vector<std::string> differences(const Sheet& sheet) {
  std::vector<std::string> list;
  for (const Disagreement& d : sheet.disagreements)
    list.push_back(d.mode + ": " + d.fails + "; but it holds by " + join(d.holds, "; "));
  return list;
}

OutputSchema<SheetRow> row_outputs() {
  using R = SheetRow;
  return OutputSchema<R>()
      .key("part", &R::part, "",
           "the command that made the check: waves, run, expected or reliability; limits: none judges that limit")
      .key("governs", &R::governs, "", "whether it is the worst of its way to fail")
      .keys_of(&R::check, check_outputs());
}

OutputSchema<Sheet> sheet_outputs() {
  const auto part = OutputSchema<SheetPart>()
                        .key("name", &SheetPart::name, "", "the command")
                        .reason("why_not", &SheetPart::why_not, "why it was not done; null where it was");
  const auto difference = OutputSchema<Disagreement>()
                              .key("mode", &Disagreement::mode, "", "the way to fail")
                              .key("fails", &Disagreement::fails, "", "the check that governs")
                              .key("holds", &Disagreement::holds, "", "names of those that hold");
  return OutputSchema<Sheet>()
      .key("title", &Sheet::title, "", "that of the file")
      .program()
      .object("verdict", &Sheet::verdict, verdict_outputs(), "what all checks say together")
      .list("parts[]", &Sheet::parts, part, "what the file asks for")
      .list("checks[]", &Sheet::rows, row_outputs(), "each check, by way to fail, the governing one first")
      .list("warnings[]", &Sheet::warnings, warning_outputs(), "[what may be wrong](warnings.md), of all parts")
      .list("disagreements[]", &Sheet::disagreements, difference,
            "measures of one way to fail that differ in whether it holds; the worse governs")
      .key("not_covered", &Sheet::not_covered, "", "ways to fail that the program does not look at")
      .versions();
}

}  // namespace

std::string text_of(const Sheet& sheet) {
  return (sheet.title.empty() ? "" : sheet.title + "\n") + table_of(sheet) +
         list_of("measures that disagree; both stand, the worse governs", differences(sheet), "  ") +
         list_of("not asked by this file", missing(sheet), "  ") +
         list_of("not covered by this program", sheet.not_covered, "  ") + "verdict     " + sheet.verdict.text + "\n";
}

std::string markdown(const Sheet& sheet) {
  std::string text = "# " + (sheet.title.empty() ? "Sheet" : sheet.title) + "\n\n**Verdict:** " + sheet.verdict.text +
                     "\n\n| way to fail | check | demand | capacity | factor | required | | by |\n"
                     "|---|---|---:|---:|---:|---:|---|---|\n";
  for (const SheetRow& row : sheet.rows) {
    Cells cells = cells_of(row);
    if (!row.check.why_not.empty()) cells = {"", "", "", "", "not checked: " + row.check.why_not, cells.back()};
    const std::string bold = row.governs ? "**" : "";
    text += "| " + row.mode + " | " + bold + name_of(row.check) + bold + " |";
    for (const std::string& cell : cells) text += " " + cell + " |";  // empty ones, too
    text += "\n";
  }
  Cells warnings;
  for (const NumberedWarning& warning : sheet.warnings)
    warnings.push_back((warning.voids ? "**" + warning.name + ", void:** " : warning.name + ": ") + warning.text());
  return text + list_of("\n## What may be wrong\n", warnings, "- ") +
         list_of("\n## Measures that disagree\n\nBoth stand, and the worse governs.\n", differences(sheet), "- ") +
         list_of("\n## Not asked by this file\n", missing(sheet), "- ") +
         list_of("\n## Not covered by this program\n", sheet.not_covered, "- ");
}

Json to_json(const Sheet& sheet) {
  return sheet_outputs().to_json(sheet);
}

std::vector<OutputRow> rows_of_sheet() {
  return sheet_outputs().rows();
}

}  // namespace upbead
