// The section of a composite breakwater, against its closed forms.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh_test_tools.h"

namespace upbead::test {
namespace composite_test {

using Parameters = std::map<std::string, double>;

const Parameters prototype = {
    {"seabed_depth", 15}, {"seabed_front", 120},     {"seabed_back", 120},     {"mound_height", 6},
    {"mound_slope", 2},   {"mound_crest_front", 16}, {"mound_crest_back", 16}, {"caisson_width", 18},
    {"water_depth", 15},  {"caisson_height", 16},    {"subsoil_depth", 0},     {"sea_front", 0},
    {"sea_back", 0},      {"mound_slope_front", 0},  {"mound_slope_back", 0},  {"water_depth_back", 0}};

const Parameters both_seas = {{"sea_front", 3}, {"sea_back", 3}};
const Parameters two_of_all = {{"subsoil_depth", 12},      {"mound_slope_front", 3}, {"mound_slope_back", 1.5},
                               {"water_depth_back", 11.5}, {"sea_front", 3},         {"sea_back", 4}};
const Parameters to_the_sides = {{"sea_front", 139.0 / 15}, {"sea_back", 139.0 / 15}};

Parameters with(Parameters changed) {
  changed.insert(prototype.begin(), prototype.end());
  return changed;
}

/// The parameter given for `side` alone, or else the one for both sides.
double of_side(const Parameters& p, const std::string& name, const std::string& side) {
  const auto alone = p.find(name + "_" + side);
  return alone != p.end() && alone->second > 0 ? alone->second : p.at(name);
}

double foot_of(const Parameters& p, const std::string& side) {
  return p.at("mound_height") * of_side(p, "mound_slope", side);
}

/// The section at a scale of 1/20.
Parameters model(Parameters changed) {
  Parameters scaled = with(changed);
  for (auto& [name, value] : scaled)
    if (name.rfind("mound_slope", 0) != 0 && name.rfind("sea_", 0) != 0) value /= 20;
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

/// Vertices of every cell of the ground and the mound.
std::vector<dealii::Point<dim>> soil_vertices(const Mesh& mesh) {
  std::vector<dealii::Point<dim>> vertices;
  for (const auto& cell : mesh.triangulation.active_cell_iterators())
    if (mesh.surface_of(cell).rfind("sea_", 0) != 0 && mesh.surface_of(cell) != "caisson")
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
  const double height = p.at("mound_height"), seaward = foot_of(p, "front"), landward = foot_of(p, "back");
  const double depth = p.at("seabed_depth"), below = p.at("subsoil_depth");
  const double crest = p.at("mound_crest_front") + p.at("mound_crest_back");
  const double ends = p.at("seabed_front") + p.at("seabed_back");
  const double width = p.at("caisson_width"), base = ends + crest + seaward + landward;
  const auto near = [](double value) { return testing::DoubleNear(value, 1e-9 * value); };
  const auto area = areas(*mesh), length = lengths(*mesh);
  EXPECT_THAT(area.at("seabed"), near(depth * base));
  ASSERT_EQ(area.count("subsoil"), below > 0 ? 1u : 0u);
  if (below > 0) {
    EXPECT_THAT(area.at("subsoil"), near(below * base));
  }
  EXPECT_THAT(area.at("mound"), near(height * (crest + (seaward + landward) / 2)));
  EXPECT_THAT(area.at("caisson"), near(width * p.at("caisson_height")));
  EXPECT_THAT(length.at("base"), near(base));
  EXPECT_THAT(length.at("left"), near(depth + below));
  EXPECT_THAT(length.at("right"), near(depth + below));
  EXPECT_THAT(length.at("bed"), near(ends));
  EXPECT_THAT(length.at("mound_surface"),
              near(crest - width + std::hypot(seaward, height) + std::hypot(landward, height)));
  EXPECT_THAT(length.at("front"), near(p.at("caisson_height")));
  EXPECT_THAT(length.at("back"), near(p.at("caisson_height")));
  EXPECT_THAT(length.at("top"), near(width));
  EXPECT_THAT(length.at("bottom"), near(width));
  EXPECT_GT(smallest_sine(*mesh), 0.3);

  double surface = 0;
  for (const auto& [side, end] : {std::pair<std::string, std::string>{"front", "sea_left"}, {"back", "sea_right"}}) {
    const double water = of_side(p, "water_depth", side), sea = p.at("sea_" + side) * water;
    ASSERT_EQ(area.count("sea_" + side), sea > 0 ? 1u : 0u);
    ASSERT_EQ(length.count(end), sea > 0 ? 1u : 0u);
    if (sea == 0) continue;
    const double berm = p.at("mound_crest_" + side) - width / 2;
    EXPECT_THAT(area.at("sea_" + side), near(sea * water - height * (berm + foot_of(p, side) / 2)));
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
  // One piece without holes or slits (Euler): no vertex is doubled.
  EXPECT_EQ(cells.n_used_vertices() + cells.n_active_cells(), cells.n_active_lines() + 1u);
  const std::map<std::string, std::string> across = {
      {"bed", "seabed"}, {"mound_surface", "mound"}, {"front", "caisson"}, {"back", "caisson"}};
  for (const auto& cell : cells.active_cell_iterators())
    for (const unsigned int f : cell->face_indices()) {
      const std::string curve = mesh->curve_of(cell->face(f)), surface = mesh->surface_of(cell);
      const auto at = cell->face(f)->center();
      const std::string side = at[0] < 0 ? "front" : "back";
      const double water = of_side(p, "water_depth", side), sea = p.at("sea_" + side) * water;
      const bool wet = sea > 0 && at[1] < water && std::abs(at[0]) < p.at("caisson_width") / 2 + sea;
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

INSTANTIATE_TEST_SUITE_P(
    TwoOfAll, Section,
    testing::Values(two_of_all, model(two_of_all), Parameters{{"subsoil_depth", 12}},
                    Parameters{{"subsoil_depth", 0.5}},
                    Parameters{{"subsoil_depth", 60}, {"seabed_depth", 2}, {"sea_front", 139.0 / 15}},
                    Parameters{{"mound_slope_back", 1.33}, {"mound_crest_back", 30}},
                    Parameters{{"mound_slope_front", 1.5}, {"sea_front", 4}, {"water_depth_back", 11.5}},
                    Parameters{{"mound_slope_back", 3}, {"sea_back", 4}, {"water_depth_back", 11.5}},
                    Parameters{{"sea_front", 3}, {"sea_back", 6}, {"water_depth", 21}, {"water_depth_back", 7}},
                    Parameters{{"sea_front", 5}, {"sea_back", 3}, {"water_depth", 8}, {"water_depth_back", 21}}));

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

TEST(Composite, LevelsAndLayersLieWhereTheyAreGiven) {
  const auto mesh = section(two_of_all);
  std::map<std::string, std::pair<double, double>> reach;
  const auto see = [&](const std::string& name, double y) {
    const auto [entry, is_new] = reach.try_emplace(name, y, y);
    entry->second = {std::min(entry->second.first, y), std::max(entry->second.second, y)};
  };
  for (const auto& cell : mesh->triangulation.active_cell_iterators())
    for (const unsigned int v : cell->vertex_indices()) see(mesh->surface_of(cell), cell->vertex(v)[1]);
  for (const auto& face : mesh->triangulation.active_face_iterators()) see(mesh->curve_of(face), face->center()[1]);
  EXPECT_EQ(reach.at("seabed"), std::make_pair(-15.0, 0.0));
  EXPECT_EQ(reach.at("subsoil"), std::make_pair(-27.0, -15.0));
  EXPECT_EQ(reach.at("sea_front"), std::make_pair(0.0, 15.0));
  EXPECT_EQ(reach.at("sea_back"), std::make_pair(0.0, 11.5));
  EXPECT_EQ(reach.at("base"), std::make_pair(-27.0, -27.0));
  EXPECT_EQ(reach.at("sea_surface"), std::make_pair(11.5, 15.0));
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
  for (const Parameters& p : {Parameters{}, both_seas, to_the_sides, two_of_all})
    expect_same(sorted_vertices(*section(model(p)), 20.0), sorted_vertices(*section(p), 1.0), 1e-6);
}

TEST(Composite, IsSymmetric) {
  for (Parameters p : {Parameters{}, both_seas, to_the_sides}) {
    for (const double subsoil : {0.0, 12.0}) {
      p["subsoil_depth"] = subsoil;
      const auto mesh = section(p);
      expect_same(sorted_vertices(*mesh, -1.0), sorted_vertices(*mesh, 1.0), 1e-12);
    }
  }
}

TEST(Composite, SidesExchangedMirrorIt) {
  const Parameters mirrored = {{"subsoil_depth", 12}, {"mound_slope_front", 1.5}, {"mound_slope_back", 3},
                               {"water_depth", 11.5}, {"water_depth_back", 15},   {"sea_front", 4},
                               {"sea_back", 3}};
  expect_same(sorted_vertices(*section(two_of_all), -1.0), sorted_vertices(*section(mirrored), 1.0), 1e-12);
}

TEST(Composite, WhatIsAlikeOnBothSidesMayBeGivenEitherWay) {
  Parameters apart = both_seas;
  apart.insert({{"mound_slope", 7}, {"mound_slope_front", 2}, {"mound_slope_back", 2}, {"water_depth_back", 15}});
  expect_same(sorted_vertices(*section(apart), 1.0), sorted_vertices(*section(both_seas), 1.0), 1e-15);
}

TEST(Composite, SubsoilLeavesAllAboveAsItIs) {
  const auto soil = soil_vertices(*section({})), both = soil_vertices(*section({{"subsoil_depth", 12}}));
  std::vector<dealii::Point<dim>> above;
  for (const auto& vertex : both)
    if (vertex[1] > -15 - 1e-9) above.push_back(vertex);
  EXPECT_GT(above.size(), soil.size());  // the subsoil's own upper edge
  above.erase(std::unique(above.begin(), above.end()), above.end());
  auto once = soil;
  once.erase(std::unique(once.begin(), once.end()), once.end());
  expect_same(above, once, 1e-12);
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
      "seabed_depth is -1; it must be 0 (the mound stands on a rigid floor) or greater",
      "cells is 0; it must be greater than 0",
      "mound_crest_front is 16; it must be greater than half of caisson_width (20)",
      "mound_crest_back is 16; it must be greater than half of caisson_width (20)",
      "grading is 0.5; it must be 1 (all cells alike) or greater"};
  ASSERT_EQ(said.size(), expected.size());
  for (std::size_t i = 0; i < said.size(); ++i) EXPECT_THAT(said[i], testing::HasSubstr(expected[i]));
}

void expect_near(const std::map<std::string, double>& one, const std::map<std::string, double>& other) {
  ASSERT_EQ(one.size(), other.size());
  for (const auto& [name, value] : one) EXPECT_NEAR(value, other.at(name), 1e-9 * value) << name;
}

/// The mound and what stands on it and beside it are those of a section with a seabed.
void expect_floor(Parameters parameters) {
  const auto on_seabed = section(parameters);
  parameters["seabed_depth"] = 0.;
  const auto on_floor = section(parameters);
  const Parameters p = with(parameters);
  auto area = areas(*on_seabed), length = lengths(*on_seabed);
  area.erase("seabed");
  expect_near(areas(*on_floor), area);
  length.erase("left");
  length.erase("right");
  const double mound = p.at("mound_crest_front") + p.at("mound_crest_back") + foot_of(p, "front") + foot_of(p, "back");
  EXPECT_NEAR(lengths(*on_floor).at("base"), mound, 1e-9 * mound);
  double under_sea = 0.;
  for (const std::string side : {"front", "back"})
    if (const double sea = p.at("sea_" + side); sea > 0)
      under_sea += sea * of_side(p, "water_depth", side) - foot_of(p, side) -
                   (p.at("mound_crest_" + side) - p.at("caisson_width") / 2);
  ASSERT_EQ(lengths(*on_floor).count("bed"), under_sea > 0 ? 1U : 0U);
  if (under_sea > 0) {
    EXPECT_NEAR(lengths(*on_floor).at("bed"), under_sea, 1e-9 * under_sea);
  }
  for (const char* other : {"base", "bed"}) length.erase(other);
  auto rest = lengths(*on_floor);
  for (const char* other : {"base", "bed"}) rest.erase(other);
  expect_near(rest, length);
}

TEST(Composite, StandsOnARigidFloorWithoutASeabed) {
  expect_floor({});
  expect_floor({{"sea_front", 3}});
  expect_floor(both_seas);
  expect_floor({{"mound_slope_front", 3},
                {"mound_slope_back", 1.5},
                {"water_depth_back", 11.5},
                {"sea_front", 3},
                {"sea_back", 4}});
  EXPECT_THAT(complaints(geometry("composite", {{"seabed_depth", 0}, {"subsoil_depth", 3}})),
              testing::ElementsAre(testing::HasSubstr("one layer of ground is the seabed")));
}

TEST(Composite, WhatHoldsForOneSideOrLayerIsZeroOrGreater) {
  const auto said = complaints(
      geometry("composite",
               {{"subsoil_depth", -1}, {"mound_slope_front", -2}, {"mound_slope_back", -3}, {"water_depth_back", -4}}));
  const std::vector<std::string> expected = {"subsoil_depth is -1; it must be 0 (none) or greater",
                                             "mound_slope_front is -2; it must be 0 (mound_slope) or greater",
                                             "mound_slope_back is -3; it must be 0 (mound_slope) or greater",
                                             "water_depth_back is -4; it must be 0 (water_depth) or greater"};
  ASSERT_EQ(said.size(), expected.size());
  for (std::size_t i = 0; i < said.size(); ++i) EXPECT_THAT(said[i], testing::HasSubstr(expected[i]));
}

}  // namespace composite_test
}  // namespace upbead::test
