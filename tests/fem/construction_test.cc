// Claims: ground that is built in stages settles as the incremental closed form says, its stresses are in equilibrium
// with the weights of every stage and within the strength; one stage with everything is the state at rest without
// stages; the stages of columns that do not touch may change places; settlement goes as 1/G.
// Sources: a layered fill of height H on a rigid base, built layer by layer, has settled at height z by gamma z (H -
// z)/M since it was there, as what was placed above z compresses what is below; put on at once by gamma (H z -
// z^2/2)/M.

#include "fem/construction.h"

#include <gtest/gtest.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/hp/fe_values.h>
#include <cmath>

#include "fem/rest_state.h"
#include "scenes.h"
#include "tensor_mesh.h"

namespace upbead::test {
namespace construction_test {

constexpr double H = 12., gravity = 9.81;
constexpr double unit_weight_of_soil = 0.6 * (2650. - 1030.) * gravity;

std::string layer(int k) {
  return "layer" + std::to_string(k);
}

void set_order(Scene& scene, const std::vector<std::vector<std::string>>& stages) {
  scene.construction.clear();
  for (std::size_t k = 0; k < stages.size(); ++k) {
    ConstructionStage& stage = scene.construction["stage" + std::to_string(k)];
    stage.order = static_cast<int>(k);
    stage.regions = stages[k];
  }
}

/// A column in n layers of two cells each, in water.
struct Fill {
  explicit Fill(int n) : n_layers(n) {
    mesh = tensor_mesh(
        {0., 1.}, even_lines(0., H, 2 * n),
        [n](const dealii::Point<dim>& p) { return layer(static_cast<int>(p[1] / H * n)); },
        [](const dealii::Point<dim>& p) {
          return std::string(p[1] < 1e-9        ? "base"
                             : p[1] > H - 1e-9  ? "top"
                             : p[0] < 1e-9      ? "left"
                             : p[0] > 1. - 1e-9 ? "right"
                                                : "");
        });
    scene = column(sand(), TimeFunction());
    scene.regions.clear();
    for (int k = 0; k < n; ++k) scene.regions[layer(k)] = sand();
    scene.initial = InitialState{2. * H, {}};
  }
  /// One layer a stage; the first stage is a layer, too.
  void in_layers() {
    std::vector<std::vector<std::string>> stages;
    for (int k = 0; k < n_layers; ++k) stages.push_back({layer(k)});
    set_order(scene, stages);
  }
  void at_once() {
    std::vector<std::string> all;
    for (int k = 0; k < n_layers; ++k) all.push_back(layer(k));
    set_order(scene, {all});
  }
  double modulus() const {
    const Region soil = sand();
    const double nu = *soil.poissons_ratio;
    return *soil.shear_modulus * 2. * (1. - nu) / (1. - 2. * nu);
  }
  /// Settlement at height z in the stages from `first` on.
  double settlement(const RestState& rest, double z, std::size_t first) const {
    double sum = 0.;
    for (std::size_t v = 0; v < mesh->triangulation.n_vertices(); ++v) {
      if (std::abs(mesh->triangulation.get_vertices()[v][1] - z) > 1e-9) continue;
      for (std::size_t k = first; k < rest.built.size(); ++k) sum -= rest.built[k].moved[v][1];
      return sum;
    }
    ADD_FAILURE() << "no vertex at height " << z;
    return 0.;
  }

  int n_layers;
  std::unique_ptr<Mesh> mesh;
  Scene scene;
};

TEST(Construction, ALayerSettlesByWhatIsPlacedAboveIt) {
  constexpr int n = 6;
  const double h = H / n;
  Fill fill(n);
  fill.in_layers();
  const RestState rest = rest_state(fill.scene, *fill.mesh, {});
  ASSERT_EQ(rest.built.size(), static_cast<std::size_t>(n));
  const double scale = unit_weight_of_soil / fill.modulus();
  for (int j = 1; j <= n; ++j) {
    const double z = j * h;
    // placed in stage j - 1: what comes after that, and with what its own layer does as it is placed
    EXPECT_NEAR(fill.settlement(rest, z, static_cast<std::size_t>(j)), scale * z * (H - z), 1e-10 * scale * H * H) << j;
    EXPECT_NEAR(fill.settlement(rest, z, static_cast<std::size_t>(j - 1)),
                scale * (z * (H - z) + h * (z - h) + 0.5 * h * h), 1e-10 * scale * H * H)
        << j;
  }
}

TEST(Construction, ThinLayersTendToTheIncrementalClosedForm) {
  std::vector<double> error;
  for (const int n : {4, 8, 16}) {
    Fill fill(n);
    fill.in_layers();
    const RestState rest = rest_state(fill.scene, *fill.mesh, {});
    double largest = 0.;
    for (int j = 1; j <= n; ++j) {
      const double z = j * H / n, exact = unit_weight_of_soil / fill.modulus() * z * (H - z);
      largest = std::max(largest, std::abs(fill.settlement(rest, z, static_cast<std::size_t>(j - 1)) - exact));
    }
    error.push_back(largest);
  }
  EXPECT_NEAR(std::log2(error[0] / error[1]), 1., 0.15);
  EXPECT_NEAR(std::log2(error[1] / error[2]), 1., 0.08);
}

TEST(Construction, AtOnceItSettlesMostAtItsTop) {
  Fill fill(4);
  fill.at_once();
  const RestState rest = rest_state(fill.scene, *fill.mesh, {});
  for (const double z : {3., 6., 12.}) {
    const double exact = unit_weight_of_soil / fill.modulus() * (H * z - 0.5 * z * z);
    EXPECT_NEAR(fill.settlement(rest, z, 0), exact, 1e-10 * exact);
  }
}

double largest_difference(const PointStresses& a, const PointStresses& b) {
  double largest = 0.;
  EXPECT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].size(), b[i].size());
    for (std::size_t q = 0; q < a[i].size(); ++q)
      for (const double d :
           {a[i][q].xx - b[i][q].xx, a[i][q].yy - b[i][q].yy, a[i][q].xy - b[i][q].xy, a[i][q].zz - b[i][q].zz})
        largest = std::max(largest, std::abs(d));
  }
  return largest;
}

/// Integral of sigma : grad v over what stands, v = 1 upward at the base and 0 at all other nodes, less the work of the
/// weights in it: the force of the base on the ground (N/m).
double reaction_of_base(const Stage& stage, const Mesh& mesh, const PointStresses& stresses) {
  const Ground ground(stage.scene, mesh, {});
  const dealii::hp::QCollection<dim> points{dealii::QGauss<dim>(static_cast<unsigned>(ground.space().degree()) + 1)};
  dealii::hp::FEValues<dim> values(ground.space().dofs().get_fe_collection(), points,
                                   dealii::update_values | dealii::update_gradients | dealii::update_JxW_values);
  double lowest = 1e300, sum = 0.;
  for (const auto& v : mesh.triangulation.get_vertices()) lowest = std::min(lowest, v[1]);
  for (const Cell& cell : ground.space().dofs().active_cell_iterators()) {
    const auto& of_cell = stresses[cell->active_cell_index()];
    if (of_cell.empty()) continue;
    values.reinit(cell);
    const auto& fe = values.get_present_fe_values();
    const Region& region = ground.space().region(cell);
    const double weight = unit_weight(region, stage.scene, region.density.value_or(0.), true);
    for (const unsigned i : fe.dof_indices()) {
      const auto [component, at] = node_of(ground.space(), cell, i);
      if (component != 1 || at[1] > lowest + 1e-9) continue;
      for (const unsigned q : fe.quadrature_point_indices()) {
        const auto grad = fe[u_part].gradient(i, q);
        sum +=
            (of_cell[q].xy * grad[1][0] + of_cell[q].yy * grad[1][1] + weight * fe[u_part].value(i, q)[1]) * fe.JxW(q);
      }
    }
  }
  return sum;
}

TEST(Construction, LevelGroundBearsTheSameInLayersAndAtOnce) {
  Fill fill(6);
  fill.in_layers();
  const RestState layers = rest_state(fill.scene, *fill.mesh, {});
  const std::vector<Stage> stages = stages_of(fill.scene, *fill.mesh);
  for (std::size_t k = 0; k < stages.size(); ++k) {
    const double weight = unit_weight_of_soil * H * static_cast<double>(k + 1) / 6.;
    EXPECT_NEAR(layers.built[k].weight, weight, 1e-10 * weight);
    EXPECT_NEAR(reaction_of_base(stages[k], *fill.mesh, layers.built[k].stresses), weight, 1e-9 * weight) << k;
  }
  const StaticStage middle = solve_static(fill.scene, *fill.mesh);
  fill.scene.construction.clear();
  const RestState once = rest_state(fill.scene, *fill.mesh, {});
  EXPECT_TRUE(once.built.empty());
  EXPECT_LT(largest_difference(layers.stresses, once.stresses), 1e-10 * unit_weight_of_soil * H);
  const StaticStage middle_once = solve_static(fill.scene, *fill.mesh);
  for (std::size_t i = 0; i < middle.stress.vertical.size(); ++i) {
    EXPECT_NEAR(middle.stress.vertical[i], middle_once.stress.vertical[i], 1e-10 * unit_weight_of_soil * H);
    EXPECT_NEAR(middle.stress.horizontal[i], middle_once.stress.horizontal[i], 1e-10 * unit_weight_of_soil * H);
  }
}

TEST(Construction, StiffnessFollowsTheStressOfEachStage) {
  Fill fill(4);
  for (auto& [name, region] : fill.scene.regions) {
    region.shear_modulus.reset();
    region.stress_law = StressLaw{60e6, 98e3, 0.5, 1.};
  }
  fill.in_layers();
  const StaticStage layers = solve_static(fill.scene, *fill.mesh);
  ASSERT_EQ(layers.in_stages.size(), 4u);
  fill.scene.construction.clear();
  const StaticStage once = solve_static(fill.scene, *fill.mesh);
  EXPECT_TRUE(once.in_stages.empty());
  for (std::size_t i = 0; i < once.shear_modulus.size(); ++i) {
    EXPECT_NEAR(layers.shear_modulus[i], once.shear_modulus[i], 1e-6 * once.shear_modulus[i]);
    for (std::size_t k = 1; k < 4; ++k) EXPECT_GE(layers.in_stages[k][i], layers.in_stages[k - 1][i]);
  }
}

/// Water that falls from above the ground to y = 4: soil above loses its lift, (1 - n) rho_f g more of weight.
TEST(Construction, GroundSettlesAsWaterFalls) {
  Fill fill(6);
  fill.scene.initial->water_level = 4.;
  fill.at_once();
  fill.scene.construction["stage0"].water_level = 2. * H;
  fill.scene.construction["low"].order = 1;
  const RestState rest = rest_state(fill.scene, *fill.mesh, {});
  const double more = 0.6 * 1030. * gravity * (H - 4.);  // Pa below the level; linear above it
  EXPECT_NEAR(fill.settlement(rest, H, 1), more * (4. + 0.5 * (H - 4.)) / fill.modulus(), 1e-10);
  EXPECT_NEAR(fill.settlement(rest, 4., 1), more * 4. / fill.modulus(), 1e-10);
}

/// Two columns, a gap apart.
TEST(Construction, ColumnsThatDoNotTouchMayChangePlaces) {
  const auto mesh = tensor_mesh(
      {0., 1., 2., 3.}, even_lines(0., H, 6),
      [](const dealii::Point<dim>& p) -> std::string {
        if (p[0] > 1. && p[0] < 2.) return "";
        return std::string(p[0] < 1. ? "a" : "b") + (p[1] < H / 2. ? "_low" : "_high");
      },
      [](const dealii::Point<dim>& p) {
        const double x = p[0] - std::floor(p[0]);
        return std::string(p[1] < 1e-9 ? "base" : p[1] > H - 1e-9 ? "top" : x < 1e-9 || x > 1. - 1e-9 ? "left" : "");
      });
  Scene scene = column(sand(), TimeFunction());
  scene.regions.clear();
  scene.boundaries.erase("right");
  scene.initial = InitialState{2. * H, {}};
  for (const char* name : {"a_low", "a_high", "b_low", "b_high"}) {
    scene.regions[name] = sand();
    scene.regions[name].law = SoilLaw::mohr_coulomb;
    scene.regions[name].strength = Strength{15., 0., 0., 0.};  // K_0 of nu = 0.33 is less than K_a of 15 degrees
  }
  const auto built = [&](const std::vector<std::vector<std::string>>& order) {
    set_order(scene, order);
    return rest_state(scene, *mesh, {});
  };
  const RestState first = built({{"a_low"}, {"b_low"}, {"b_high"}, {"a_high"}});
  const RestState second = built({{"b_low"}, {"b_high"}, {"a_low"}, {"a_high"}});
  ASSERT_TRUE(first.found && second.found);
  EXPECT_GT(first.share_at_strength, 0.9);
  EXPECT_LT(largest_difference(first.stresses, second.stresses), 1e-6 * unit_weight_of_soil * H);
  for (std::size_t v = 0; v < mesh->triangulation.n_vertices(); ++v) {
    std::vector<double> settled;
    for (const RestState* rest : {&first, &second}) {
      double sum = 0.;
      for (const BuiltStage& stage : rest->built)
        if (const double moved = stage.moved[v][1]; !std::isnan(moved)) sum += moved;
      settled.push_back(sum);
    }
    EXPECT_NEAR(settled[0], settled[1], 1e-5 * unit_weight_of_soil * H * H / 90e6);
  }
}

Scene yielding_section() {
  Scene scene = breakwater(triangle(1., 0.1));
  scene.initial.emplace().water_level = 15.;
  scene.regions["seabed"].law = scene.regions["mound"].law = SoilLaw::mohr_coulomb;
  scene.regions["seabed"].strength = Strength{35., 1e3};
  scene.regions["mound"].strength = Strength{40., 0.};
  return scene;
}

void build_as_usual(Scene& scene) {
  set_order(scene, {{"seabed"}, {"mound"}, {"caisson"}, {}});
  scene.construction["stage2"].caisson_share = 0.6;
  scene.construction["stage3"].caisson_share = 1.;
}

double largest_vertical(const PointStresses& stresses) {
  double largest = 0.;
  for (const auto& cell : stresses)
    for (const PlaneStress& s : cell) largest = std::max(largest, std::abs(s.yy));
  return largest;
}

TEST(Construction, OneStageWithEverythingIsTheStateAtRest) {
  const auto mesh = breakwater_mesh(0.25);
  for (const bool with_k0 : {false, true}) {
    Scene scene = yielding_section();
    if (with_k0) scene.initial->k0 = 0.45;
    const RestState once = rest_state(scene, *mesh, {});
    const StaticStage elastic = solve_static(scene, *mesh);
    set_order(scene, {{"seabed", "mound", "caisson"}});
    const RestState staged = rest_state(scene, *mesh, {});
    ASSERT_TRUE(once.found && staged.found);
    EXPECT_LE(largest_difference(once.stresses, staged.stresses), 1e-10 * largest_vertical(once.stresses));
    const StaticStage staged_elastic = solve_static(scene, *mesh);
    for (std::size_t i = 0; i < elastic.stress.vertical.size(); ++i)
      EXPECT_NEAR(elastic.stress.mean(i, k0_of(scene)), staged_elastic.stress.mean(i, k0_to_apply(scene)),
                  1e-10 * largest_vertical(once.stresses));
  }
}

TEST(Construction, OfAYieldingMoundIsInEquilibriumAndWithinTheStrengthInEveryStage) {
  const auto mesh = breakwater_mesh(0.25);
  for (const bool with_k0 : {false, true}) {
    Scene scene = yielding_section();
    build_as_usual(scene);
    if (with_k0) scene.initial->k0 = 0.45;
    const RestState rest = rest_state(scene, *mesh, {});
    ASSERT_TRUE(rest.found) << rest.falls_in << " " << rest.gives_way;
    const std::vector<Stage> stages = stages_of(scene, *mesh);
    ASSERT_EQ(rest.built.size(), 4u);
    const double area = 18. * 16., caisson = 2100. * area * gravity, lift = 1030. * 18. * 9. * gravity;
    const double mound = unit_weight_of_soil * 6. * (32. + 12.);
    for (std::size_t k = 0; k < stages.size(); ++k) {
      const BuiltStage& built = rest.built[k];
      const Ground ground(stages[k].scene, *mesh, {});
      const Vector weights = ground.weights(stages[k].level);
      EXPECT_LE(added_weights(stages[k], ground, built.stresses).norm(), 1e-6 * weights.norm()) << k;
      EXPECT_NEAR(reaction_of_base(stages[k], *mesh, built.stresses), built.weight, 1e-6 * built.weight) << k;
      for (const auto& cell : mesh->triangulation.active_cell_iterators()) {
        const Region& region = scene.regions.at(mesh->surface_of(cell));
        if (region.law == SoilLaw::elastic) continue;
        const MohrCoulombLaw law(elastic_law(*region.shear_modulus, *region.poissons_ratio),
                                 {region.strength->friction_angle, region.strength->cohesion, 0., 0.});
        for (const PlaneStress& s : built.stresses[cell->active_cell_index()])
          EXPECT_LE(law.excess(s), 1e-9 * largest_vertical(built.stresses));
      }
    }
    EXPECT_NEAR(rest.built[1].weight - rest.built[0].weight, mound, 1e-9 * mound);
    EXPECT_NEAR(rest.built[2].weight - rest.built[1].weight, 0.6 * caisson - lift, 1e-9 * caisson);
    EXPECT_NEAR(rest.built[3].weight - rest.built[2].weight, 0.4 * caisson, 1e-9 * caisson);
    EXPECT_FALSE(rest.built[1].base.has_value());
    ASSERT_TRUE(rest.built[3].base.has_value());
    EXPECT_NEAR(rest.built[3].base->force, caisson - lift, 1e-9 * caisson);
    EXPECT_NEAR(rest.built[3].base->moment, 0., 1e-9 * caisson);
    EXPECT_NEAR(rest.built[3].base->width, 18., 1e-9);
    EXPECT_LT((*rest.built[2].caisson)[motion_y], 0.);
    EXPECT_LT((*rest.built[3].caisson)[motion_y], (*rest.built[2].caisson)[motion_y] * 0.3) << "soil that yields";
  }
}

/// Elastic ground under a caisson of a part of its weight, then all of it, is that under the whole at once.
TEST(Construction, OfElasticGroundTheCaissonsSharesAddUp) {
  const auto mesh = breakwater_mesh(0.25);
  Scene scene = breakwater(triangle(1., 0.1));
  scene.initial.emplace().water_level = 15.;
  build_as_usual(scene);
  const RestState shares = rest_state(scene, *mesh, {});
  set_order(scene, {{"seabed"}, {"mound"}, {"caisson"}});
  const RestState whole = rest_state(scene, *mesh, {});
  const double size = largest_vertical(whole.stresses);
  EXPECT_LE(largest_difference(shares.stresses, whole.stresses), 1e-9 * size);
  for (int m = 0; m < n_motions; ++m) {
    const auto i = static_cast<std::size_t>(m);
    EXPECT_NEAR((*shares.built[2].caisson)[i] + (*shares.built[3].caisson)[i], (*whole.built[2].caisson)[i],
                1e-9 * std::abs((*whole.built[2].caisson)[motion_y]));
  }
  // by the other assembly: at the middle of a cell, which is a point of quadrature of degree 2
  const StaticStage middle = solve_static(scene, *mesh);
  for (std::size_t i = 0; i < whole.stresses.size(); ++i)
    if (!whole.stresses[i].empty()) {
      EXPECT_NEAR(middle.stress.vertical[i], -whole.stresses[i][4].yy, 1e-8 * size);
      EXPECT_NEAR(middle.stress.shear[i], -whole.stresses[i][4].xy, 1e-8 * size);
    }
  EXPECT_GT(std::abs(solve_static(yielding_section(), *mesh).stress.shear[0] - middle.stress.shear[0]), 0.);
}

TEST(Construction, SettlementGoesAsOneOverG) {
  const auto mesh = breakwater_mesh(0.25);
  Scene scene = yielding_section();
  build_as_usual(scene);
  const RestState stiff = rest_state(scene, *mesh, {});
  for (const char* name : {"seabed", "mound"}) *scene.regions[name].shear_modulus /= 5.;
  const RestState soft = rest_state(scene, *mesh, {});
  ASSERT_TRUE(stiff.found && soft.found);
  EXPECT_LE(largest_difference(stiff.stresses, soft.stresses), 1e-4 * largest_vertical(stiff.stresses));
  const double settled = (*stiff.built[3].caisson)[motion_y];
  EXPECT_NEAR((*soft.built[3].caisson)[motion_y], 5. * settled, 1e-3 * std::abs(settled));
}

/// A caisson that is set down in the last stage: the forces under it are those on ground that has settled.
TEST(Construction, TellsTheForcesUnderTheCaisson) {
  const auto mesh = breakwater_mesh(0.5);
  Scene scene = breakwater(triangle(1., 0.1));
  scene.initial.emplace().water_level = 15.;
  scene.regions["caisson"].interface = ContactLaw{ContactKind::friction, 0.6};
  const Vector settled = static_normal_forces(scene, *mesh, {}, true), once = static_normal_forces(scene, *mesh, {});
  build_as_usual(scene);
  const Vector staged = static_normal_forces(scene, *mesh, {});
  ASSERT_EQ(staged.size(), settled.size());
  EXPECT_LT((staged - settled).norm(), 1e-8 * settled.norm());
  EXPECT_GT((once - settled).norm(), 1e-3 * settled.norm());
}

/// Where still water stands at two levels, it pushes the caisson by its heights above the bottom, with the seas in the
/// mesh as without.
TEST(Construction, StillWaterPushesAlikeWithTheSeasInTheMesh) {
  Scene scene = breakwater(triangle(1., 0.1));
  scene.initial.emplace().water_level = 15.;
  scene.initial->harbour_level = 14.;
  const WeightInWater bare = caisson_in_water(scene, *breakwater_mesh(0.25));
  add_sea(scene);
  auto parameters = with_sea();
  parameters["water_depth_back"] = 14.;
  const WeightInWater wet = caisson_in_water(scene, *breakwater_mesh(0.25, parameters));
  // between both levels cells are cut along a slope: quadrature; with the mean of bottom and walls as foot x is 0.025 m
  EXPECT_NEAR(wet.weight, bare.weight, 1e-4 * bare.weight);
  EXPECT_NEAR(bare.x, -0.011131981, 1e-8);
  EXPECT_NEAR(wet.x, bare.x, 1e-4);
}

TEST(Construction, TellsTheStageThatDoesNotStand) {
  const auto mesh = breakwater_mesh(0.25);
  Scene scene = yielding_section();
  scene.regions["mound"].strength = Strength{20., 0.};  // slopes of 1:2 are steeper
  build_as_usual(scene);
  const RestState rest = rest_state(scene, *mesh, {});
  EXPECT_FALSE(rest.found);
  EXPECT_EQ(rest.falls_in, "stage1");
  EXPECT_EQ(rest.built.size(), 1u);
  EXPECT_EQ(rest.gives_way.rfind("region 'mound' at ", 0), 0u) << rest.gives_way;
}

struct BadStages {
  const char* name;
  std::function<void(Scene&)> edit;
  const char* key;
  const char* what;
};
void PrintTo(const BadStages& bad, std::ostream* out) {
  *out << bad.name;
}
class ConstructionCheck : public ::testing::TestWithParam<BadStages> {};

TEST_P(ConstructionCheck, SaysWhatDoesNotFit) {
  Scene scene = yielding_section();
  build_as_usual(scene);
  GetParam().edit(scene);
  const auto wrong = mistakes(scene, *breakwater_mesh(0.25));
  ASSERT_EQ(wrong.size(), 1u);
  EXPECT_EQ(wrong[0].place.key, GetParam().key);
  EXPECT_NE(wrong[0].what.find(GetParam().what), std::string::npos) << wrong[0].what;
  EXPECT_FALSE(wrong[0].cure.empty());
}

const BadStages bad_stages[] = {
    {"UnknownRegion", [](Scene& s) { s.construction["stage1"].regions.push_back("rock"); },
     "construction.stage1.regions", "no region 'rock'"},
    {"NeverBuilt", [](Scene& s) { s.construction["stage1"].regions.clear(); }, "construction",
     "'mound' is never built"},
    {"BuiltTwice", [](Scene& s) { s.construction["stage3"].regions = {"mound"}; }, "construction.stage3.regions",
     "built twice: in the stages 'stage1' and 'stage3'"},
    {"CaissonInTheAir", [](Scene& s) { std::swap(s.construction["stage1"].regions, s.construction["stage3"].regions); },
     "construction.stage2.regions", "before the region 'mound', on which it lies"},
    {"SameOrder", [](Scene& s) { s.construction["stage3"].order = 2; }, "construction.stage3.order", "same order, 2"},
    {"ShareBeforeTheCaisson", [](Scene& s) { s.construction["stage1"].caisson_share = 0.5; },
     "construction.stage1.caisson_share", "no caisson"},
    // rho_f 9 m over 2100 kg/m3 16 m: 0.27589
    {"Floats", [](Scene& s) { s.construction["stage2"].caisson_share = 0.2758; }, "construction.stage2.caisson_share",
     "floats"},
    {"FloatsAsWaterRises",
     [](Scene& s) {
       s.construction["stage2"].caisson_share = 0.2759;
       s.construction["stage3"] = {3, {}, {}, 15.1};
       s.construction["stage4"] = {4, {}, 1., {}};
     },
     "construction.stage3.water_level", "floats"},
    {"NotFilled", [](Scene& s) { s.construction["stage3"].caisson_share.reset(); }, "construction",
     "60 % of its weight"},
    {"OtherLevelAtTheEnd", [](Scene& s) { s.construction["stage3"].water_level = 14.; },
     "construction.stage3.water_level", "before the waves at 15 m"},
    {"NoLevel",
     [](Scene& s) {
       s.initial.reset();
       for (auto& [name, region] : s.regions) region.law = SoilLaw::elastic;
     },
     "initial", "construction"},
    {"Springs",
     [](Scene& s) {
       s.boundaries["bed"].spring = {1e6, 0.};
     },
     "boundaries.bed.spring", "not followed"},
};

INSTANTIATE_TEST_SUITE_P(All, ConstructionCheck, ::testing::ValuesIn(bad_stages),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST(Construction, TellsAllMistakesAtOnce) {
  Scene scene = yielding_section();
  set_order(scene, {{"seabed", "rock"}, {"caisson", "caisson"}});
  scene.construction["stage1"].caisson_share = 0.9;
  EXPECT_EQ(mistakes(scene, *breakwater_mesh(0.25)).size(), 4u);  // rock, twice, no mound, not full
}

}  // namespace construction_test
}  // namespace upbead::test
