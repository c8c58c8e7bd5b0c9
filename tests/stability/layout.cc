#include "layout.h"

#include <algorithm>
#include <cstdio>

namespace upbead::test {

namespace {

std::string text(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.6g", value);
  return buffer;
}

/// Collects `name = value` of a table of parameters.
class Parameters {
 public:
  void set(const std::string& name, double value) { list_ += (list_.empty() ? "" : ", ") + name + " = " + text(value); }
  std::string line() const { return "parameters = { " + list_ + " }\n"; }

 private:
  std::string list_;
};

/// Sizes and cells of the blocks of section.geo; cells of the thin row are up to 100 times as long as high.
struct Blocks {
  std::array<double, 3> width;
  std::array<double, 4> height;  ///< lower, upper, wet, dry
  std::array<int, 3> columns;
  std::array<int, 4> rows;

  explicit Blocks(Draw& draw) {
    const double depth = draw.ranged(0.1, 50.);
    for (double& w : width) w = depth * draw.log_uniform(0.4, 3.);
    for (int& n : columns) n = draw.whole(1, 2);
    for (int& n : rows) n = draw.whole(1, 2);
    height = {depth * draw.log_uniform(0.3, 2.), depth * draw.log_uniform(0.2, 1.), depth,
              depth * draw.log_uniform(0.1, 1.)};
    if (!draw.chance(0.3)) return;
    const int row = draw.whole(0, 1);
    const double aspect = draw.ranged(5., 100.);
    height[row] = rows[row] * longest() / aspect;
  }
  double longest() const {
    double longest = 0.;
    for (int i = 0; i < 3; ++i) longest = std::max(longest, width[i] / columns[i]);
    return longest;
  }
  double aspect() const {
    double largest = 1.;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 2; ++j) {
        const double ratio = width[i] / columns[i] / (height[j] / rows[j]);
        largest = std::max({largest, ratio, 1. / ratio});
      }
    return largest;
  }
  void write(Parameters& parameters) const {
    const std::array<std::string, 3> column{"left", "middle", "right"};
    const std::array<std::string, 4> row{"lower", "upper", "wet", "dry"};
    for (int i = 0; i < 3; ++i) parameters.set(column[i] + "_width", width[i]);
    for (int i = 0; i < 3; ++i) parameters.set("columns_" + column[i], columns[i]);
    for (int j = 0; j < 4; ++j) parameters.set(row[j] + "_height", height[j]);
    for (int j = 0; j < 4; ++j) parameters.set("rows_" + row[j], rows[j]);
  }
};

void add_caisson(const std::string& ground, Layout& out) {
  out.caisson = true;
  out.under_caisson = ground;
  out.touching.push_back({ground, "caisson"});
  for (const char* name : {"front", "back", "top"}) out.curves.push_back({name, {"caisson"}});
}

void add_seas(bool front, bool back, Layout& out) {
  if (front) out.seas.emplace_back("sea_front");
  if (back) out.seas.emplace_back("sea_back");
  if (out.seas.empty()) return;
  if (front) out.curves.push_back({"sea_left", {"sea_front"}});
  if (back || !out.caisson) out.curves.push_back({"sea_right", {back ? "sea_back" : "sea_front"}});
  out.curves.push_back({"sea_surface", out.seas, true});
}

}  // namespace

Layout draw_section(Draw& draw, const std::string& section_geo) {
  const Blocks blocks(draw);
  Layout out;
  const bool caisson = draw.chance(0.7), pad = draw.chance(0.3), sea_front = draw.chance(0.4),
             sea_back = caisson && draw.chance(0.3);
  Parameters parameters;
  blocks.write(parameters);
  parameters.set("skew", draw.chance(0.4) ? draw.uniform(-0.33, 0.33) : 0.);
  parameters.set("pad", pad);
  parameters.set("caisson", caisson);
  parameters.set("sea_front", sea_front);
  parameters.set("sea_back", sea_back);
  out.mesh = "file = \"" + section_geo + "\"\n" + parameters.line();
  out.ground = {"lower", "upper"};
  out.touching = {{"lower", "upper"}};
  if (pad) {
    out.ground.emplace_back("pad");
    out.touching.push_back({"lower", "pad"});
    out.touching.push_back({"upper", "pad"});
  }
  out.curves = {{"base", {"lower"}, false, false, true}, {"left", {"lower", "upper"}}, {"right", {"lower", "upper"}}};
  const bool dry_bed = caisson ? !(sea_front && sea_back) : !sea_front;
  if (dry_bed) {
    out.curves.push_back({"bed", {"upper"}, false, true, false, sea_front || sea_back});
    if (pad && !caisson) out.curves.back().behind.emplace_back("pad");
  }
  if (caisson) add_caisson(pad ? "pad" : "upper", out);
  add_seas(sea_front, sea_back, out);
  const double x = blocks.width[0] + 0.51 * blocks.width[1];
  out.probes = {{x, -0.2 * blocks.height[1]}, {x, -blocks.height[1] - 0.8 * blocks.height[0]}};
  out.middle = {blocks.width[0] + 0.5 * blocks.width[1], 0.5 * (blocks.height[2] + blocks.height[3])};
  out.caisson_area = blocks.width[1] * (blocks.height[2] + blocks.height[3]);
  out.depth = blocks.height[2];
  out.aspect = blocks.aspect();
  return out;
}

namespace {

Layout draw_column(Draw& draw) {
  Layout out;
  Parameters parameters;
  const double height = draw.ranged(0.1, 50.), width = height * draw.log_uniform(0.01, 2.);
  const int cells = draw.whole(1, 8);
  parameters.set("height", height);
  parameters.set("width", width);
  parameters.set("cells", cells);
  parameters.set("grading", draw.log_uniform(1., 30.));
  out.mesh = "geometry = \"column\"\n" + parameters.line();
  out.ground = {"soil"};
  out.curves = {
      {"base", {"soil"}, false, false, true}, {"left", {"soil"}}, {"right", {"soil"}}, {"top", {"soil"}, false, true}};
  out.probes = {{0.4 * width, 0.9 * height}, {0.4 * width, 0.2 * height}};
  out.depth = height;
  const double ratio = width / (height / cells);
  out.aspect = std::max(ratio, 1. / ratio);
  return out;
}

Layout draw_composite(Draw& draw) {
  Layout out;
  Parameters parameters;
  const double depth = draw.log_uniform(0.5, 30.), mound = 0.4 * depth, half = 0.6 * depth;
  const bool front = draw.chance(0.4), back = draw.chance(0.3);
  parameters.set("seabed_depth", depth * draw.log_uniform(0.3, 2.));
  for (const char* side : {"seabed_front", "seabed_back"}) parameters.set(side, 4. * depth);
  parameters.set("mound_height", mound);
  for (const char* side : {"mound_crest_front", "mound_crest_back"}) parameters.set(side, 1.8 * half);
  parameters.set("mound_slope", draw.uniform(1., 2.));
  parameters.set("caisson_width", 2. * half);
  parameters.set("caisson_height", depth);
  parameters.set("water_depth", depth);
  parameters.set("sea_front", front ? 4. : 0.);
  parameters.set("sea_back", back ? 4. : 0.);
  parameters.set("cells", 0.1);
  parameters.set("sea_cells", 10.);
  parameters.set("grading", draw.one_of({1., 3.}));
  out.mesh = "geometry = \"composite\"\n" + parameters.line();
  out.ground = {"seabed", "mound"};
  out.touching = {{"seabed", "mound"}};
  out.curves = {{"base", {"seabed"}, false, false, true}, {"left", {"seabed"}}, {"right", {"seabed"}}};
  out.curves.push_back({"bed", {"seabed"}, false, true, false, front || back});
  if (!front || !back) out.curves.push_back({"mound_surface", {"mound"}, false, true, false, front || back});
  add_caisson("mound", out);
  add_seas(front, back, out);
  out.probes = {{0., 0.9 * mound}, {0., -0.1 * depth}};
  out.middle = {0., mound + 0.5 * depth};
  out.caisson_area = 2. * half * depth;
  out.depth = depth;
  return out;
}

}  // namespace

Layout draw_shipped(Draw& draw) {
  return draw.chance(0.5) ? draw_column(draw) : draw_composite(draw);
}

}  // namespace upbead::test
