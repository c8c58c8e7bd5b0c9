// The section of a composite breakwater, against its closed forms.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>

#include "mesh_test_tools.h"

namespace upbead::test {
namespace {

using Parameters = std::map<std::string, double>;

const Parameters prototype = {{"seabed_depth", 15}, {"seabed_front", 120},     {"seabed_back", 120},
                              {"mound_height", 6},  {"mound_crest_front", 16}, {"mound_crest_back", 16},
                              {"mound_slope", 2},   {"caisson_width", 18},     {"caisson_height", 16},
                              {"water_depth", 15},  {"sea_front", 0},          {"sea_back", 0}};

const Parameters both_seas = {{"sea_front", 3}, {"sea_back", 3}};
const Parameters to_the_sides = {{"sea_front", 139.0 / 15}, {"sea_back", 139.0 / 15}};

Parameters with(Parameters changed) {
  changed.insert(prototype.begin(), prototype.end());
  return changed;
}

/// The section at a scale of 1/20.
Parameters model(Parameters changed) {
  Parameters scaled = with(changed);
  for (auto& [name, value] : scaled)
    if (name != "mound_slope" && name != "sea_front" && name != "sea_back") value /= 20;
  return scaled;
}

std::unique_ptr<Mesh> section(const Parameters& parameters) {
  return read_mesh(geometry("composite", parameters));
}

/// By x, then y.
std::vector<dealii::Point<dim>> sorted(std::vector<dealii::Point<dim>> vertices, double scale) {
  for (auto& vertex : vertices) vertex = {scale * vertex[0], std::abs(scale) * vertex[1]};
  std::sort(vertices.begin(), vertices.end(),
            [](const auto& a, const auto& b) { return std::abs(a[0] - b[0]) > 1e-6 ? a[0] < b[0] : a[1] < b[1]; });
  return vertices;
}

std::vector<dealii::Point<dim>> sorted_vertices(const Mesh& mesh, double scale) {
  return sorted(mesh.triangulation.get_vertices(), scale);
}

/// Vertices of every cell of the seabed and the mound.
std::vector<dealii::Point<dim>> soil_vertices(const Mesh& mesh) {
  std::vector<dealii::Point<dim>> vertices;
  for (const auto& cell : mesh.triangulation.active_cell_iterators())
    if (mesh.surface_of(cell) == "seabed" || mesh.surface_of(cell) == "mound")
      for (const unsigned int v : cell->vertex_indices()) vertices.push_back(cell->vertex(v));
  return sorted(vertices, 1.0);
}

void expect_same(const std::vector<dealii::Point<dim>>& a, const std::vector<dealii::Point<dim>>& b, double tolerance) {
  ASSERT_EQ(a.size(), b.size());
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, a[i].distance(b[i]));
  EXPECT_LT(largest, tolerance);
}

class Section : public testing::TestWithParam<Parameters> {};

TEST_P(Section, AreasLengthsAndAngles) {
  const Parameters p = with(GetParam());
  const auto mesh = read_mesh(geometry("composite", GetParam()));
  const double height = p.at("mound_height"), foot = height * p.at("mound_slope"), depth = p.at("seabed_depth");
  const double crest = p.at("mound_crest_front") + p.at("mound_crest_back");
  const double ends = p.at("seabed_front") + p.at("seabed_back");
  const double width = p.at("caisson_width");
  const auto near = [](double value) { return testing::DoubleNear(value, 1e-9 * value); };
  const auto area = areas(*mesh), length = lengths(*mesh);
  EXPECT_THAT(area.at("seabed"), near(depth * (ends + crest + 2 * foot)));
  EXPECT_THAT(area.at("mound"), near(height * (crest + foot)));
  EXPECT_THAT(area.at("caisson"), near(width * p.at("caisson_height")));
  EXPECT_THAT(length.at("base"), near(ends + crest + 2 * foot));
  EXPECT_THAT(length.at("left"), near(depth));
  EXPECT_THAT(length.at("right"), near(depth));
  EXPECT_THAT(length.at("bed"), near(ends));
  EXPECT_THAT(length.at("mound_surface"), near(crest - width + 2 * std::hypot(foot, height)));
  EXPECT_THAT(length.at("front"), near(p.at("caisson_height")));
  EXPECT_THAT(length.at("back"), near(p.at("caisson_height")));
  EXPECT_THAT(length.at("top"), near(width));
  EXPECT_THAT(length.at("bottom"), near(width));
  EXPECT_GT(smallest_sine(*mesh), 0.3);

  const double water = p.at("water_depth");
  double surface = 0;
  for (const auto& [side, end] : {std::pair<std::string, std::string>{"front", "sea_left"}, {"back", "sea_right"}}) {
    const double sea = p.at("sea_" + side) * water;
    ASSERT_EQ(area.count("sea_" + side), sea > 0 ? 1u : 0u);
    ASSERT_EQ(length.count(end), sea > 0 ? 1u : 0u);
    if (sea == 0) continue;
    const double berm = p.at("mound_crest_" + side) - width / 2;
    EXPECT_THAT(area.at("sea_" + side), near(sea * water - height * (berm + foot / 2)));
    EXPECT_THAT(length.at(end), near(water));
    surface += sea;
  }
  ASSERT_EQ(length.count("sea_surface"), surface > 0 ? 1u : 0u);
  if (surface > 0) {
    EXPECT_THAT(length.at("sea_surface"), near(surface));
  }
}

TEST_P(Section, SeaJoinsSoilAndCaisson) {
  const Parameters p = with(GetParam());
  const auto mesh = section(GetParam());
  const auto& cells = mesh->triangulation;
  // One piece without holes or slits (Euler): no vertex is there twice.
  EXPECT_EQ(cells.n_used_vertices() + cells.n_active_cells(), cells.n_active_lines() + 1u);
  const std::map<std::string, std::string> across = {
      {"bed", "seabed"}, {"mound_surface", "mound"}, {"front", "caisson"}, {"back", "caisson"}};
  for (const auto& cell : cells.active_cell_iterators())
    for (const unsigned int f : cell->face_indices()) {
      const std::string curve = mesh->curve_of(cell->face(f)), surface = mesh->surface_of(cell);
      const auto at = cell->face(f)->center();
      const double sea = p.at(at[0] < 0 ? "sea_front" : "sea_back") * p.at("water_depth");
      const bool wet = sea > 0 && at[1] < p.at("water_depth") && std::abs(at[0]) < p.at("caisson_width") / 2 + sea;
      const bool interior = curve.empty() || curve == "bottom" || (across.count(curve) == 1 && wet);
      ASSERT_EQ(cell->at_boundary(f), !interior) << curve << " at " << at;
      if (interior && surface.rfind("sea_", 0) == 0) {
        EXPECT_EQ(mesh->surface_of(cell->neighbor(f)), curve.empty() ? surface : across.at(curve)) << at;
      }
    }
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, Section,
    testing::Values(Parameters{}, Parameters{{"mound_slope", 1.33}}, Parameters{{"mound_slope", 3}},
                    Parameters{{"mound_slope", 0.5}}, Parameters{{"mound_height", 1.5}},
                    Parameters{{"mound_height", 15}, {"mound_slope", 1.5}},
                    Parameters{{"mound_crest_front", 9.2}, {"mound_crest_back", 45}}, Parameters{{"seabed_depth", 1.5}},
                    Parameters{{"seabed_front", 5}, {"seabed_back", 200}}, Parameters{{"caisson_width", 8}},
                    Parameters{{"caisson_width", 30}}, Parameters{{"cells", 0.3}}, Parameters{{"cells", 2.5}},
                    Parameters{{"grading", 1}}, Parameters{{"grading", 30}}, Parameters{{"caisson_height", 4}}));

INSTANTIATE_TEST_SUITE_P(
    Seas, Section,
    testing::Values(both_seas, to_the_sides, Parameters{{"sea_front", 2.5}}, Parameters{{"sea_back", 2.5}},
                    Parameters{{"sea_front", 139.0 / 15}, {"sea_back", 1.3}},
                    Parameters{{"sea_front", 3}, {"sea_back", 4}, {"mound_slope", 1.33}},
                    Parameters{{"sea_front", 3}, {"sea_back", 4}, {"mound_slope", 3}},
                    Parameters{{"sea_front", 3}, {"mound_slope", 0.5}},
                    Parameters{{"sea_front", 3}, {"sea_back", 3}, {"cells", 0.5}},
                    Parameters{{"sea_front", 3}, {"sea_back", 3}, {"cells", 2}, {"sea_cells", 10}},
                    Parameters{{"sea_front", 9}, {"sea_back", 6}, {"water_depth", 7}, {"sea_cells", 1}},
                    Parameters{{"sea_back", 1}, {"water_depth", 21.5}, {"grading", 1}}, model(both_seas),
                    model({{"sea_back", 4}}), model(to_the_sides)));

TEST(Composite, SitsAtTheOrigin) {
  const auto mesh = read_mesh(geometry("composite"));
  const std::map<std::string, std::pair<int, double>> lines = {
      {"base", {1, -15}}, {"bed", {1, 0}},  {"bottom", {1, 6}},  {"top", {1, 22}},
      {"front", {0, -9}}, {"back", {0, 9}}, {"left", {0, -148}}, {"right", {0, 148}}};
  for (const auto& face : mesh->triangulation.active_face_iterators()) {
    const auto line = lines.find(mesh->curve_of(face));
    if (line != lines.end()) {
      EXPECT_NEAR(face->center()[line->second.first], line->second.second, 1e-9) << line->first;
    }
  }
}

TEST(Composite, Counts) {
  const std::map<std::string, unsigned int> dry = {{"seabed", 1136}, {"mound", 570}, {"caisson", 96}};
  const std::map<std::string, unsigned int> wet = {
      {"seabed", 1136}, {"mound", 570}, {"caisson", 240}, {"sea_front", 224}, {"sea_back", 224}};
  EXPECT_EQ(cell_counts(*section({})), dry);
  EXPECT_EQ(cell_counts(*section(both_seas)), wet);
}

TEST(Composite, TwiceTheCellsHalvesThem) {
  for (Parameters p : {Parameters{}, both_seas}) {
    const auto once = cell_counts(*section(p));
    p["cells"] = 2;
    const auto twice = cell_counts(*section(p));
    for (const auto& [name, count] : once) EXPECT_NEAR(twice.at(name) / (4.0 * count), 1.0, 0.1) << name;
  }
}

TEST(Composite, ModelIsThePrototypeScaled) {
  for (const Parameters& p : {Parameters{}, both_seas, to_the_sides})
    expect_same(sorted_vertices(*section(model(p)), 20.0), sorted_vertices(*section(p), 1.0), 1e-6);
}

TEST(Composite, IsSymmetric) {
  for (const Parameters& p : {Parameters{}, both_seas, to_the_sides}) {
    const auto mesh = section(p);
    expect_same(sorted_vertices(*mesh, -1.0), sorted_vertices(*mesh, 1.0), 1e-12);
  }
}

TEST(Composite, SeaToTheSidesLeavesTheSoilAsItIs) {
  expect_same(soil_vertices(*section(to_the_sides)), soil_vertices(*section({})), 1e-12);
}

TEST(Composite, CellsAreSmallestAtTheCaissonsCorners) {
  const auto mesh = read_mesh(geometry("composite"));
  double smallest = 1e300;
  dealii::Point<dim> where;
  for (const auto& cell : mesh->triangulation.active_cell_iterators())
    if (mesh->surface_of(cell) == "mound" && cell->measure() < smallest) {
      smallest = cell->measure();
      where = cell->center();
    }
  EXPECT_LT(std::abs(std::abs(where[0]) - 9.0), 0.5);
  EXPECT_LT(std::abs(where[1] - 6.0), 0.5);
  EXPECT_LT(smallest, 0.25);
}

TEST(Composite, ImpossibleShapesAreAllSaid) {
  const auto said =
      complaints(geometry("composite", {{"caisson_width", 40}, {"seabed_depth", -1}, {"grading", 0.5}, {"cells", 0}}));
  const std::vector<std::string> expected = {
      "seabed_depth is -1; it must be greater than 0", "cells is 0; it must be greater than 0",
      "mound_crest_front is 16; it must be greater than half of caisson_width (20)",
      "mound_crest_back is 16; it must be greater than half of caisson_width (20)",
      "grading is 0.5; it must be 1 (all cells alike) or greater"};
  ASSERT_EQ(said.size(), expected.size());
  for (std::size_t i = 0; i < said.size(); ++i) EXPECT_THAT(said[i], testing::HasSubstr(expected[i]));
}

TEST(Composite, IsReadInNoTime) {
  const auto start = std::chrono::steady_clock::now();
  read_mesh(geometry("composite"));
  EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), 0.2);
}

}  // namespace
}  // namespace upbead::test
