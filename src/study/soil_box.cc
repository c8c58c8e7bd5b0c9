#include "study/soil_box.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "study/soil_families.h"
#include "study_tables.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

constexpr double deviations = 3.;     ///< of a bell's box, to both sides
constexpr double many_times = 3.;     ///< a list of values that spans more is spread over its logarithm
constexpr std::size_t most_keys = 6;  ///< of one region, whose corners are looked at

SoilAxis axis_of_values(const std::string& key, const std::vector<Literal>& values) {
  SoilAxis axis{key, values.front().number, values.front().number, false};
  for (const Literal& value : values) {
    axis.low = std::min(axis.low, value.number);
    axis.high = std::max(axis.high, value.number);
  }
  axis.logarithmic = axis.low > 0. && axis.high > many_times * axis.low;
  return axis;
}

SoilAxis axis_of(const Axis& of) {
  const VaryTable& vary = of.vary;
  if (!vary.distribution) return axis_of_values(of.key, values_of(vary));
  const bool bell = *vary.distribution == DrawnBy::normal || *vary.distribution == DrawnBy::log_normal;
  const bool logarithmic = *vary.distribution == DrawnBy::log_uniform || *vary.distribution == DrawnBy::log_normal;
  if (!bell) return {of.key, *vary.low, *vary.high, logarithmic};
  const double tail = 0.5 * std::erfc(deviations / std::sqrt(2.));
  return {of.key, value_at(of, tail).number, value_at(of, 1. - tail).number, logarithmic};
}

bool has_numbers_alone(const VaryTable& vary) {
  return std::all_of(vary.values.begin(), vary.values.end(), [](const Literal& value) { return value.is_number; });
}

void check_axis(const Axis& axis, const Document& document, Diagnostics& report) {
  const Place place = document.place(dotted("vary", axis.key));
  if (!is_of_region(axis.key))
    report.add(place, "'" + axis.key + "' is no number of a soil", "vary keys of regions alone");
  else if (!has_numbers_alone(axis.vary))
    report.add(place, "'" + axis.key + "' has values that are no numbers", "give its least and its largest number");
  else if (const SoilAxis range = axis_of(axis); !(range.low < range.high))
    report.add(place, "'" + axis.key + "' does not vary", "give its least and its largest value");
}

std::string region_of(const std::string& key) {
  return split_dotted(key).at(1);
}

}  // namespace

std::vector<SoilAxis> read_soil_box(const std::string& path) {
  const Document document(path, {});
  require_quoted_keys(document);
  StudyTables tables;
  Diagnostics report;
  study_schema().read(document.root(), "", tables, report);
  if (tables.one_case.empty() && tables.cases.empty()) tables.one_case = "that of the command";
  const std::vector<Axis> axes = axes_of(tables, document);
  const bool drawn =
      std::any_of(axes.begin(), axes.end(), [](const Axis& axis) { return axis.vary.distribution.has_value(); });
  if (drawn && !document.find("sample")) tables.sample = Sampling::random;  // a file with such tables alone
  if (drawn && !document.find("n")) tables.n = 1;
  check_study(tables, axes, document, report);
  for (const char* table : {"set", "follow"})
    if (document.find(table))
      report.add(document.place(table), std::string("a box of soils has no [") + table + "]",
                 "write it into the case, or leave it out");
  if (report.sound("vary"))
    for (const Axis& axis : axes)
      if (report.sound(dotted("vary", axis.key))) check_axis(axis, document, report);
  report.throw_if_any(path);
  std::vector<SoilAxis> box;
  for (const Axis& axis : axes) box.push_back(axis_of(axis));
  return box;
}

std::vector<Setting> settings_of(const Soil& soil) {
  std::vector<Setting> list;
  for (const auto& [key, value] : soil) list.emplace_back(key, literal(value).toml);
  return list;
}

std::vector<std::vector<Setting>> corners_by_region(const std::vector<SoilAxis>& box) {
  std::map<std::string, std::vector<SoilAxis>> of_region;
  for (const SoilAxis& axis : box) {
    std::vector<SoilAxis>& axes = of_region[region_of(axis.key)];
    if (axes.size() < most_keys) axes.push_back(axis);
  }
  std::vector<std::vector<Setting>> corners;
  for (const auto& entry : of_region) {
    const std::vector<SoilAxis>& axes = entry.second;
    for (std::size_t corner = 0; corner < (std::size_t{1} << axes.size()); ++corner) {
      std::vector<Setting> soil;
      for (std::size_t a = 0; a < axes.size(); ++a)
        soil.emplace_back(axes[a].key, literal((corner >> a) % 2 == 0 ? axes[a].low : axes[a].high).toml);
      corners.push_back(std::move(soil));
    }
  }
  return corners;
}

}  // namespace upbead
