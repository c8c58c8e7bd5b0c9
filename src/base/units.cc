#include "base/units.h"

#include <string_view>
#include <vector>

#include "base/numbers.h"

namespace upbead {

namespace {

constexpr double g = 9.80665;

struct Row {
  std::string_view text;
  double factor;  ///< 1 of this unit in SI units
};

struct Quantity {
  std::string_view si;
  std::vector<Row> units;
};

/// Names are without blanks, ^ and *.
const std::vector<Quantity>& quantities() {
  static const std::vector<Quantity> list{
      {"s",
       {{"s", 1.},
        {"ms", 1e-3},
        {"us", 1e-6},
        {"sec", 1.},
        {"秒", 1.},
        {"msec", 1e-3},
        {"min", 60.},
        {"h", 3600.},
        {"secs", 1.},
        {"second", 1.},
        {"seconds", 1.},
        {"sek", 1.},
        {"sekunden", 1.},
        {"msek", 1e-3},
        {"milliseconds", 1e-3},
        {"millisecond", 1e-3},
        {"millisekunden", 1e-3},
        {"microseconds", 1e-6},
        {"minutes", 60.}}},
      {"m", {{"m", 1.}, {"cm", 1e-2}, {"mm", 1e-3}, {"um", 1e-6}}},
      {"m/s", {{"m/s", 1.}, {"cm/s", 1e-2}, {"mm/s", 1e-3}}},
      {"m/s2", {{"m/s2", 1.}, {"cm/s2", 1e-2}, {"mm/s2", 1e-3}, {"gal", 1e-2}, {"Gal", 1e-2}, {"g", g}, {"G", g}}},
      {"rad", {{"rad", 1.}, {"mrad", 1e-3}, {"deg", pi / 180.}, {"°", pi / 180.}}},
      {"rad/s", {{"rad/s", 1.}, {"deg/s", pi / 180.}}},
      {"Pa", {{"Pa", 1.},           {"hPa", 1e2},       {"kPa", 1e3},       {"MPa", 1e6},
              {"bar", 1e5},         {"mbar", 1e2},      {"N/m2", 1.},       {"kN/m2", 1e3},
              {"MN/m2", 1e6},       {"N/cm2", 1e4},     {"N/mm2", 1e6},     {"gf/cm2", 10. * g},
              {"kgf/cm2", 1e4 * g}, {"kgf/m2", g},      {"tf/m2", 1e3 * g}, {"psi", 6894.757293168},
              {"mH2O", 1e3 * g},    {"cmH2O", 10. * g}, {"mmH2O", g},       {"mAq", 1e3 * g}}},
      {"N/m",
       {{"N/m", 1.},
        {"kN/m", 1e3},
        {"MN/m", 1e6},
        {"N/cm", 1e2},
        {"N/mm", 1e3},
        {"gf/cm", 0.1 * g},
        {"kgf/cm", 1e2 * g},
        {"kgf/m", g},
        {"tf/m", 1e3 * g}}},
      {"Nm/m", {{"Nm/m", 1.}, {"kNm/m", 1e3}, {"MNm/m", 1e6}, {"kgfm/m", g}, {"tfm/m", 1e3 * g}}},
      {"N/m3", {{"N/m3", 1.}, {"kN/m3", 1e3}, {"MN/m3", 1e6}, {"tf/m3", 1e3 * g}}},
      {"1/s", {{"1/s", 1.}, {"s-1", 1.}, {"1/min", 1. / 60.}, {"1/h", 1. / 3600.}}},
      {"Hz", {{"Hz", 1.}, {"kHz", 1e3}}},
      {"1", {{"1", 1.}, {"-", 1.}, {"%", 1e-2}}},
      {"N", {{"N", 1.}, {"kN", 1e3}, {"MN", 1e6}, {"kgf", g}, {"tf", 1e3 * g}}}};
  return list;
}

void replace_all(std::string& text, const std::string& old, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(old, at)) != std::string::npos; at += by.size())
    text.replace(at, old.size(), by);
}

/// Full-width letters of Japanese keyboards, U+FF01 to U+FF5E, as those of ASCII.
std::string narrow(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = [&](std::size_t k) { return i + k < text.size() ? static_cast<unsigned char>(text[i + k]) : 0U; };
    const unsigned code = byte(0) == 0xEFU ? ((byte(1) & 0x3FU) << 6U) + (byte(2) & 0x3FU) : 0U;  // less U+F000
    const bool wide = code >= 0xF01U && code <= 0xF5EU;
    out += wide ? static_cast<char>(code - 0xF01U + 0x21U) : text[i];
    if (wide) i += 2;
  }
  return out;
}

/// "m s-2" as "m/s2", where a unit precedes.
std::string with_slash(std::string text) {
  for (const char* power : {"m-1", "m-2", "m-3", "s-1", "s-2"}) {
    const std::string end(power);
    if (text.size() <= end.size() || text.compare(text.size() - end.size(), end.size(), end) != 0) continue;
    text.replace(text.size() - end.size(), end.size(),
                 "/" + end.substr(0, 1) + (end.back() == '1' ? "" : end.substr(2)));
    break;
  }
  return text;
}

std::string plain(const std::string& given) {
  std::string text = narrow(given);
  replace_all(text, " per ", "/");
  for (const char* ignored : {" ", "^", "*", "·", "."}) replace_all(text, ignored, "");
  replace_all(text, "⁻", "-");
  replace_all(text, "¹", "1");
  text = with_slash(text);
  if (text.compare(0, 2, "KN") == 0 || text.compare(0, 2, "KP") == 0) text.front() = 'k';  // nobody means kelvin
  replace_all(text, "N/M", "N/m");
  replace_all(text, "²", "2");
  replace_all(text, "µ", "u");
  replace_all(text, "μ", "u");
  return text;
}

}  // namespace

std::optional<Unit> unit_of(const std::string& text) {
  const std::string name = plain(text);
  for (const Quantity& quantity : quantities())
    for (const Row& row : quantity.units)
      if (row.text == name) return Unit{quantity.si == "Nm/m" ? "N m/m" : std::string(quantity.si), row.factor};
  return {};
}

std::string units_like(const std::string& si) {
  std::string list;
  for (const Quantity& quantity : quantities())
    if (plain(si) == quantity.si)
      for (const Row& row : quantity.units) list += (list.empty() ? "" : ", ") + std::string(row.text);
  return list;
}

}  // namespace upbead
