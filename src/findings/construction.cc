// How the section was built: settlement, tilt, strength and pressure on the base in every stage.
#include "run/construction.h"
#include "base/text.h"
#include "fem/outline.h"
#include "findings/topics.h"

namespace upbead {

namespace {

constexpr double day = 86400.;
/// Each stage is taken as drained; a stage lasts some weeks at least: a choice.
constexpr double shortest_stage = 30. * day;
/// T_v at which nine tenths of the settlement are over, drained at one side (Terzaghi 1943).
constexpr double most_of_it = 0.848;

/// t_90 = T_v H^2/c_v, c_v = k M/(rho_f g), of a layer H that drains at its top alone (s); none where it has no k.
std::optional<double> time_to_drain(const Region& region, const Scene& scene, double height) {
  const std::optional<double> k = conductivity(region, scene.fluid, scene.gravity);
  if (region.kind != RegionKind::porous || !k) return std::nullopt;
  const double confined = material(region, scene.fluid, scene.gravity).constrained_modulus();
  return most_of_it * height * height * scene.fluid.density * scene.gravity /
         (region.conductivity_ratio * *k * confined);
}

/// Warning drained_stages: of the region that drains last.
NumberedWarnings drained_warnings(const Simulation& simulation, const std::optional<double>&) {
  const Scene& scene = simulation.scene();
  if (scene.construction.size() < 2) return {};
  double longest = 0.;
  std::string slowest;
  for (const auto& [name, bounds] : outline_of(*simulation.mesh()).surfaces) {
    const std::optional<double> time = time_to_drain(scene.regions.at(name), scene, bounds.highest - bounds.lowest);
    if (!time || *time <= longest) continue;
    longest = *time;
    slowest = name;
  }
  if (longest <= shortest_stage) return {};
  return {{"drained_stages", longest, shortest_stage, "s",
           "every stage of construction is taken as drained, and the region '" + slowest + "' needs about " +
               significant(longest / day, 2) +
               " days to give off nine tenths of a stage's pore pressure (Terzaghi, drained at its top): until then "
               "it bears less than is computed, and has settled less",
           "judge the stages with its undrained strength, too: strength = { friction_angle = 0, cohesion = c_u }"}};
}

OutputSchema<CaissonMotion> caisson_motion_outputs() {
  using C = CaissonMotion;
  return OutputSchema<C>()
      .key("settlement", &C::settlement, "m", "of the centre of gravity, downward")
      .key("displacement_x", &C::displacement_x, "m", "likewise, landward")
      .key("rotation", &C::rotation, "rad", "positive where the top moved landward");
}

OutputSchema<StageSummary> stage_outputs() {
  using S = StageSummary;
  return OutputSchema<S>()
      .key("name", &S::name, "", "of the stage")
      .key("regions", &S::regions, "", "that appear in it; empty where none do")
      .key("weight", &S::weight, "N/m", "of all that stands, in water")
      .key("settlement", &S::settlement, "m",
           "largest of the ground in this stage, downward; null in the first stage, which is the ground as it is found")
      .key(
          "settlement_at[]", [](const S& s) { return s.settlement ? std::optional(s.settlement_at) : std::nullopt; },
          "m", "where that is; null with it")
      .object("caisson", &S::caisson, caisson_motion_outputs(),
              "motion of a rigid caisson in this stage; null where it does not stand, and in the first stage")
      .key(
          "heel_pressure", &S::heel_pressure, "Pa",
          "under the caisson's landward edge, stress varying linearly over the base; null where it does not stand, and "
          "where the resultant leaves the base there")
      .key("toe_pressure", &S::toe_pressure, "Pa", "likewise under the seaward edge")
      .key("mobilised", &S::mobilised, "",
           "largest share of its strength that the mean stress of a cell mobilises, 1 at the strength, 10: more; free "
           "surfaces are left out; null where no region that stands has a strength")
      .key(
          "mobilised_at[]", [](const S& s) { return s.mobilised ? std::optional(s.mobilised_at) : std::nullopt; }, "m",
          "where that is; null with it")
      .reason("mobilised_in", &S::mobilised_in, "its region; null with it")
      .key("share_at_strength", &S::share_at_strength, "",
           "of the area of Mohr-Coulomb soil that stands: where its strength is reached; null where none stands");
}

OutputSchema<ConstructionSummary> construction_outputs() {
  using C = ConstructionSummary;
  return OutputSchema<C>()
      .list("stages[]", &C::stages, stage_outputs(), "the stages that have a rest, in their order")
      .object("caisson", &C::caisson, caisson_motion_outputs(),
              "motion of a rigid caisson since it was set down: before the waves, and in no other number; null without "
              "one, and where a stage has no rest, or one that its motion did not lead to")
      .reason("falls_in", &C::falls_in, "the stage that has no rest; null where all have");
}

std::optional<ConstructionSummary> find_construction(const Solution& solution) {
  return solution.construction ? solution.construction : build(*solution.simulation);
}

}  // namespace

Finding construction_finding() {
  Finding f;
  f.keys.object("construction", &Summary::construction, construction_outputs(),
                "how the section was [built in stages](construction.md); else null");
  f.of_scene = drained_warnings;
  return f.part(&Summary::construction, find_construction);
}

}  // namespace upbead
