#include "rupture/section.h"

#include <algorithm>
#include <limits>

namespace upbead {

namespace {

constexpr double n_strips = 256.;

double height_at(const GroundLine& line, double x) {
  return line.y[0] + (line.y[1] - line.y[0]) * (x - line.x[0]) / (line.x[1] - line.x[0]);
}

}  // namespace

GroundSection::GroundSection(std::vector<GroundSoil> soils, std::vector<GroundLine> lines,
                             std::optional<double> water_level)
    : soils_(std::move(soils)),
      lines_(std::move(lines)),
      strips_(static_cast<std::size_t>(n_strips)),
      water_level_(water_level) {
  left_ = std::numeric_limits<double>::infinity();
  right_ = -left_;
  for (const GroundLine& line : lines_) {
    left_ = std::min(left_, line.x[0]);
    right_ = std::max(right_, line.x[1]);
  }
  const auto strip = [&](double x) {
    return static_cast<int>(std::clamp((x - left_) / (right_ - left_) * n_strips, 0., n_strips - 1.));
  };
  for (std::size_t i = 0; i < lines_.size(); ++i)
    for (int s = strip(lines_[i].x[0]); s <= strip(lines_[i].x[1]); ++s)
      strips_[static_cast<std::size_t>(s)].push_back(static_cast<int>(i));
}

std::optional<GroundColumn> GroundSection::column(double x) const {
  if (!(x >= left_ && x <= right_)) return std::nullopt;
  const auto strip = static_cast<std::size_t>(std::min((x - left_) / (right_ - left_) * n_strips, n_strips - 1.));
  GroundColumn column;
  for (const int i : strips_[strip]) {
    const GroundLine& line = lines_[static_cast<std::size_t>(i)];
    // a vertical that meets the end of a line belongs to the line to its right, at the right end to that to its left
    if (x < line.x[0] || (x >= line.x[1] && !(x == right_ && line.x[1] == right_))) continue;
    const GroundColumn::Layer layer{height_at(line, x), line.below};
    auto at = column.layers.end();
    while (at != column.layers.begin() && std::prev(at)->top < layer.top) --at;
    column.layers.insert(at, layer);
  }
  const auto is_soil = [](const GroundColumn::Layer& layer) { return layer.soil != no_soil; };
  column.layers.erase(column.layers.begin(), std::find_if(column.layers.begin(), column.layers.end(), is_soil));
  if (column.layers.empty()) return std::nullopt;
  const auto bottom = std::find_if_not(column.layers.begin(), column.layers.end(), is_soil);
  column.is_whole = std::none_of(bottom, column.layers.end(), is_soil);
  return column;
}

std::optional<double> GroundSection::surface(double x) const {
  const std::optional<GroundColumn> found = column(x);
  return found ? std::optional(found->surface()) : std::nullopt;
}

GroundSection::Weight GroundSection::weight_above(const GroundColumn& column, double y) const {
  Weight sum;
  const auto add = [&sum](double top, double bottom, double weight) {
    if (!(top > bottom)) return;
    sum.force += weight * (top - bottom);
    sum.moment += 0.5 * weight * (top - bottom) * (top + bottom);
  };
  const double level = water_level_.value_or(-std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < column.layers.size() && column.layers[i].soil != no_soil; ++i) {
    const double top = column.layers[i].top;
    const double bottom = i + 1 < column.layers.size() ? std::max(y, column.layers[i + 1].top) : y;
    const GroundSoil& soil = soils_[static_cast<std::size_t>(column.layers[i].soil)];
    add(top, std::max(bottom, level), soil.weight);
    add(std::min(top, level), bottom, soil.submerged);
  }
  return sum;
}

const GroundSoil* GroundSection::soil_at(const GroundColumn& column, double y) const {
  int found = no_soil;
  for (const GroundColumn::Layer& layer : column.layers) {
    if (layer.top < y) break;
    found = layer.soil;
    if (found == no_soil) break;
  }
  return found == no_soil ? nullptr : &soils_[static_cast<std::size_t>(found)];
}

}  // namespace upbead
