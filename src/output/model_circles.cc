// The slip circles of a reduced model in its file.
#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "model_parts.h"

namespace upbead::detail {

namespace {

const std::string circles_group = "/circles";
constexpr std::size_t of_circle = 8, of_slice = 7, of_base = 4;

void write_rows(Hdf5Image& image, const std::string& path, const std::vector<double>& values, std::size_t columns,
                const std::string& meaning) {
  image.numbers(circles_group + path, {values.size() / columns, columns}, values.data(), {"", meaning});
}

using Numbers = std::vector<double>;

Numbers numbers_of(const std::vector<FamilyCircle>& circles) {
  Numbers list;
  for (const FamilyCircle& c : circles)
    for (const double value : {c.x, c.y, c.radius, c.from, c.to, c.landward ? 1. : -1., c.weight_moment,
                               static_cast<double>(c.slices.size())})
      list.push_back(value);
  return list;
}

Numbers numbers_of_slices(const std::vector<FamilyCircle>& circles) {
  Numbers list;
  for (const FamilyCircle& c : circles)
    for (const FamilySlice& s : c.slices)
      for (const double value : {s.x, s.width, s.sine, s.cosine, s.cohesion, s.friction, s.weight})
        list.push_back(value);
  return list;
}

/// What no circle can be; "" where it may be one.
std::string objection_to_circle(const FamilyCircle& c) {
  if (!(c.radius > 0.)) return "a radius that is not above 0";
  if (!(c.from < c.to)) return "ends that are not in their order";
  double at = c.from;
  const double trifle = 1e-6 * (c.to - c.from);
  for (const FamilySlice& s : c.slices) {
    if (!(s.width > 0.) || std::abs(s.x - 0.5 * s.width - at) > trifle) return "slices that do not stand side by side";
    at = s.x + 0.5 * s.width;
    if (!(s.cosine > 0.) || std::abs(std::hypot(s.sine, s.cosine) - 1.) > 1e-9) return "a slope that is no angle";
    if (s.cohesion < 0. || s.friction < 0.) return "a strength below 0";
    if (s.weight < 0.) return "a weight below 0";
  }
  return std::abs(at - c.to) > trifle ? "slices that do not end where it ends" : "";
}

/// The circles of those numbers, each with its part of the slices.
std::vector<FamilyCircle> circles_of(ModelParts& parts, const Numbers& circles, const Numbers& slices) {
  std::vector<FamilyCircle> list;
  std::size_t next = 0;
  for (std::size_t i = 0; i < circles.size(); i += of_circle) {
    const double* v = circles.data() + i;
    FamilyCircle c{v[0], v[1], v[2], v[3], v[4], v[5] > 0., v[6], {}};
    const std::size_t rest = slices.size() / of_slice - next;
    if (!(v[7] >= 1.) || v[7] != std::floor(v[7]) || v[7] > static_cast<double>(rest)) {
      parts.wrong(circles_group + "/circle has " + significant(v[7]) + " slices in a row, where /slice has " +
                  std::to_string(rest) + " left");
      return list;
    }
    for (std::size_t k = 0; k < static_cast<std::size_t>(v[7]); ++k, ++next) {
      const double* s = slices.data() + next * of_slice;
      c.slices.push_back({s[0], s[1], s[2], s[3], s[4], s[5], s[6]});
    }
    const std::string objection = objection_to_circle(c);
    if (std::abs(v[5]) != 1. || !objection.empty())
      parts.wrong(circles_group + ": circle " + std::to_string(list.size()) + " has " +
                  (objection.empty() ? "a direction that is neither 1 nor -1" : objection));
    list.push_back(c);
  }
  if (next * of_slice != slices.size()) parts.wrong(circles_group + "/slice has slices that belong to no circle");
  return list;
}

}  // namespace

void write_circles(Hdf5Image& image, const CircleModel& model) {
  const CircleFamily& family = model.family;
  image.group(circles_group);
  const Numbers base{family.left, family.right, family.level, model.gap};
  image.numbers(circles_group + "/base", {base.size()}, base.data(),
                {"",
                 "x of the ends of the base, y of its level (m), largest share by which the family's least factor "
                 "exceeded that of a full search"});
  write_rows(image, "/circle", numbers_of(family.circles), of_circle,
             "x, y of the centre, radius, x of both ends (m), 1 landward or -1 seaward, moment of the weights "
             "about the centre (N m/m), number of slices");
  write_rows(image, "/slice", numbers_of_slices(family.circles), of_slice,
             "x of the middle, width (m), sin and cos of alpha, c' (Pa), tan phi', weight above (Pa)");
  write_modes(image, circles_group, model.pressures);
}

std::optional<CircleModel> read_circles(ModelParts& parts, const std::vector<std::string>& loads) {
  if (parts.length(circles_group + "/base") == 0) return std::nullopt;
  CircleModel model;
  const Numbers base = parts.numbers(circles_group + "/base", {of_base});
  model.family.left = base[0];
  model.family.right = base[1];
  model.family.level = base[2];
  model.gap = base[3];
  if (!(base[0] < base[1]) || base[3] < 0.)
    parts.wrong(circles_group + "/base holds ends that are not in their order, or a gap below 0");
  const Numbers circles =
      parts.numbers(circles_group + "/circle", {parts.length(circles_group + "/circle"), of_circle});
  const Numbers slices = parts.numbers(circles_group + "/slice", {parts.length(circles_group + "/slice"), of_slice});
  model.family.circles = circles_of(parts, circles, slices);
  if (model.family.circles.empty()) parts.wrong(circles_group + " holds no circle");
  model.pressures.load_name = loads;
  model.pressures.reading_label.assign(model.family.n_readings(), {});
  read_modes(parts, circles_group, model.pressures);
  return model;
}

}  // namespace upbead::detail
