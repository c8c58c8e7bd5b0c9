#include "design/sheet.h"

#include <algorithm>

#include "output/limits.h"

namespace upbead {

namespace {

constexpr const char* not_covered[] = {
    "scour at the toe and in front of the mound", "stability of the armour and of the foot protection blocks",
    "overtopping, transmission, harbour agitation", "strength of the caisson's walls, slabs and joints",
    "caissons along the wall: oblique waves and roundheads"};

std::vector<SheetRow> rows_of(const std::vector<SheetPart>& parts) {
  std::vector<SheetRow> rows;
  for (const SheetPart& part : parts)
    for (const Check& check : part.checks) rows.push_back({mode_of(check), part.name, check});
  std::stable_sort(rows.begin(), rows.end(), [](const SheetRow& a, const SheetRow& b) {
    if (a.mode != b.mode) return std::pair(a.check.mode, a.mode) < std::pair(b.check.mode, b.mode);
    return is_worse(a.check, b.check);
  });
  for (std::size_t i = 0; i < rows.size(); ++i)
    rows[i].governs = (i == 0 || rows[i].mode != rows[i - 1].mode) && rows[i].check.holds.has_value();
  return rows;
}

std::vector<Disagreement> disagreements_of(const std::vector<SheetRow>& rows) {
  std::vector<Disagreement> list;
  for (const SheetRow& first : rows) {
    if (!first.governs || *first.check.holds) continue;
    Disagreement found{first.mode, text_of(first.check), {}};
    for (const SheetRow& other : rows)
      if (other.mode == first.mode && other.check.holds && *other.check.holds)
        found.holds.push_back(name_of(other.check));
    if (!found.holds.empty()) list.push_back(found);
  }
  return list;
}

}  // namespace

void append_new(NumberedWarnings& list, const NumberedWarnings& more) {
  for (const NumberedWarning& warning : more)
    if (std::none_of(list.begin(), list.end(), [&](const NumberedWarning& told) {
          return told.name == warning.name && told.text().find(warning.what) != std::string::npos;
        }))
      list.push_back(warning);
}

Sheet sheet_of(const std::string& title, std::vector<SheetPart> parts, const Limits& limits) {
  Sheet sheet;
  sheet.title = title;
  sheet.parts = std::move(parts);
  Checks checks;
  for (const SheetPart& part : sheet.parts) {
    append(checks, part.checks);
    append_new(sheet.warnings, part.warnings);
  }
  const Checks unjudged = unjudged_limits(limits, checks, false);
  append(checks, unjudged);
  if (!unjudged.empty()) sheet.parts.push_back({"limits", unjudged, {}, ""});
  sheet.rows = rows_of(sheet.parts);
  sheet.disagreements = disagreements_of(sheet.rows);
  sheet.verdict = verdict_of(checks, sheet.warnings);
  sheet.not_covered.assign(std::begin(not_covered), std::end(not_covered));
  return sheet;
}

}  // namespace upbead
