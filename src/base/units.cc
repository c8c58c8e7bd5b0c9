#include "base/units.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "base/numbers.h"

namespace upbead {

namespace {

constexpr double g = 9.80665;

struct Row {
  std::string_view text, si;
  double factor;
};

// without blanks, ^ and *; the first of each quantity is the SI unit
constexpr std::array<Row, 82> rows{{
    {"s", "s", 1.},
    {"ms", "s", 1e-3},
    {"us", "s", 1e-6},
    {"sec", "s", 1.},
    {"msec", "s", 1e-3},
    {"min", "s", 60.},
    {"h", "s", 3600.},
    {"secs", "s", 1.},
    {"second", "s", 1.},
    {"seconds", "s", 1.},
    {"sek", "s", 1.},
    {"sekunden", "s", 1.},
    {"msek", "s", 1e-3},
    {"milliseconds", "s", 1e-3},
    {"millisecond", "s", 1e-3},
    {"millisekunden", "s", 1e-3},
    {"microseconds", "s", 1e-6},
    {"minutes", "s", 60.},
    {"m", "m", 1.},
    {"cm", "m", 1e-2},
    {"mm", "m", 1e-3},
    {"um", "m", 1e-6},
    {"m/s", "m/s", 1.},
    {"cm/s", "m/s", 1e-2},
    {"mm/s", "m/s", 1e-3},
    {"m/s2", "m/s2", 1.},
    {"cm/s2", "m/s2", 1e-2},
    {"mm/s2", "m/s2", 1e-3},
    {"gal", "m/s2", 1e-2},
    {"Gal", "m/s2", 1e-2},
    {"g", "m/s2", g},
    {"G", "m/s2", g},
    {"rad", "rad", 1.},
    {"mrad", "rad", 1e-3},
    {"deg", "rad", pi / 180.},
    {"°", "rad", pi / 180.},
    {"rad/s", "rad/s", 1.},
    {"deg/s", "rad/s", pi / 180.},
    {"Pa", "Pa", 1.},
    {"hPa", "Pa", 1e2},
    {"kPa", "Pa", 1e3},
    {"MPa", "Pa", 1e6},
    {"bar", "Pa", 1e5},
    {"mbar", "Pa", 1e2},
    {"N/m2", "Pa", 1.},
    {"kN/m2", "Pa", 1e3},
    {"MN/m2", "Pa", 1e6},
    {"N/cm2", "Pa", 1e4},
    {"N/mm2", "Pa", 1e6},
    {"gf/cm2", "Pa", 10. * g},
    {"kgf/cm2", "Pa", 1e4 * g},
    {"kgf/m2", "Pa", g},
    {"tf/m2", "Pa", 1e3 * g},
    {"psi", "Pa", 6894.757293168},
    {"mH2O", "Pa", 1e3 * g},
    {"cmH2O", "Pa", 10. * g},
    {"mmH2O", "Pa", g},
    {"mAq", "Pa", 1e3 * g},
    {"N/m", "N/m", 1.},
    {"kN/m", "N/m", 1e3},
    {"MN/m", "N/m", 1e6},
    {"N/cm", "N/m", 1e2},
    {"N/mm", "N/m", 1e3},
    {"gf/cm", "N/m", 0.1 * g},
    {"kgf/cm", "N/m", 1e2 * g},
    {"kgf/m", "N/m", g},
    {"tf/m", "N/m", 1e3 * g},
    {"Nm/m", "Nm/m", 1.},
    {"kNm/m", "Nm/m", 1e3},
    {"MNm/m", "Nm/m", 1e6},
    {"kgfm/m", "Nm/m", g},
    {"tfm/m", "Nm/m", 1e3 * g},
    {"Hz", "Hz", 1.},
    {"kHz", "Hz", 1e3},
    {"1", "1", 1.},
    {"-", "1", 1.},
    {"%", "1", 1e-2},
    {"N", "N", 1.},
    {"kN", "N", 1e3},
    {"MN", "N", 1e6},
    {"kgf", "N", g},
    {"tf", "N", 1e3 * g},
}};

void replace_all(std::string& text, const std::string& old, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(old, at)) != std::string::npos; at += by.size())
    text.replace(at, old.size(), by);
}

std::string plain(std::string text) {
  for (const char* ignored : {" ", "^", "*", "·", "."}) replace_all(text, ignored, "");
  replace_all(text, "²", "2");
  replace_all(text, "µ", "u");
  replace_all(text, "μ", "u");
  return text;
}

}  // namespace

std::optional<Unit> unit_of(const std::string& text) {
  const std::string name = plain(text);
  const auto* row = std::find_if(rows.begin(), rows.end(), [&](const Row& r) { return r.text == name; });
  if (row == rows.end()) return {};
  return Unit{row->si == "Nm/m" ? "N m/m" : std::string(row->si), row->factor};
}

std::string units_like(const std::string& si) {
  std::string list;
  for (const Row& row : rows)
    if (plain(si) == row.si) list += (list.empty() ? "" : ", ") + std::string(row.text);
  return list;
}

}  // namespace upbead
