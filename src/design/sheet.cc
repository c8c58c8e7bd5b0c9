#include "design/sheet.h"

#include <algorithm>

#include "base/text.h"
#include "output/unjudged_limits.h"

namespace upbead {

namespace {

/// How the name of a check begins, and the way to fail that it is about. Of two that fit the longer one counts.
struct ModeOfName {
  const char *begin, *mode;
};

constexpr ModeOfName modes[] = {
    {"strength", "strength of the ground"},
    {"slip circle", "bearing and slip circles"},
    {"slip on a plane", "bearing and slip circles"},
    {"momentary liquefaction", "momentary liquefaction of the ground"},
    {"residual pore pressure", "residual pore pressure of a storm"},
    {"sliding by formulas", "sliding landward"},
    {"force against friction", "sliding landward"},
    {"friction over F_T", "sliding landward"},
    {"sliding seaward", "sliding seaward"},
    {"force against friction, seaward", "sliding seaward"},
    {"friction over F_T seaward", "sliding seaward"},
    {"sliding distance", "sliding distance"},
    {"expected sliding distance", "sliding distance"},
    {"displacement with the ground", "sliding distance"},
    {"share of lives that slide", "sliding distance"},
    {"overturning", "overturning landward"},
    {"margin against overturning", "overturning landward"},
    {"overturning seaward", "overturning seaward"},
    {"heel pressure", "heel pressure"},
    {"toe pressure", "toe pressure"},
    {"settlement", "settlement"},
    {"tilt", "tilt"},
};

constexpr const char* not_covered[] = {
    "scour at the toe and in front of the mound", "stability of the armour and of the foot protection blocks",
    "overtopping, transmission, harbour agitation", "strength of the caisson's walls, slabs and joints",
    "caissons along the wall: oblique waves and roundheads"};

std::string mode_of(const std::string& name) {
  const ModeOfName* best = nullptr;
  for (const ModeOfName& row : modes)
    if (name.rfind(row.begin, 0) == 0 && (!best || std::string(row.begin).size() > std::string(best->begin).size()))
      best = &row;
  return best ? best->mode : name;
}

/// Where a mode stands on the sheet; unknown ones in the end.
std::size_t place_of(const std::string& mode) {
  const auto found =
      std::find_if(std::begin(modes), std::end(modes), [&](const ModeOfName& row) { return mode == row.mode; });
  return static_cast<std::size_t>(found - std::begin(modes));
}

std::vector<SheetRow> rows_of(const std::vector<SheetPart>& parts) {
  std::vector<SheetRow> rows;
  for (const SheetPart& part : parts)
    for (const Check& check : part.checks) rows.push_back({mode_of(check.name), part.name, check});
  std::stable_sort(rows.begin(), rows.end(), [](const SheetRow& a, const SheetRow& b) {
    if (a.mode != b.mode) return std::pair(place_of(a.mode), a.mode) < std::pair(place_of(b.mode), b.mode);
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

Sheet sheet_of(const std::string& title, std::vector<SheetPart> parts, const Limits& limits) {
  Sheet sheet;
  sheet.title = title;
  sheet.parts = std::move(parts);
  Checks checks;
  for (const SheetPart& part : sheet.parts) {
    append(checks, part.checks);
    append(sheet.warnings, part.warnings);
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
