// What a storm's waves leave in the ground: residual pore pressure, settlement and tilt of the caisson.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

#include "base/text.h"
#include "fem/compile.h"
#include "fem/pore_diffusion.h"
#include "fem/settling.h"
#include "findings/topics.h"
#include "output/limits.h"
#include "response/cyclic_storm.h"
#include "run/monitors.h"

namespace upbead {

namespace {

/// Share of the region's mean: where the effective stress at rest is smaller, as beside free surfaces, the ratio of
/// pressures says nothing, and cells are left out.
constexpr double least_effective = 0.02;
/// Largest amplitude of shear strain at which densification was measured, with a margin (Martin, Finn and Seed 1975).
constexpr double largest_measured = 1e-2;

struct CyclesFound {
  std::optional<CyclesSummary> summary;
  std::map<std::string, double> largest_strain;  ///< amplitude of gamma in the highest waves, by region
  std::string why_not, cure;
};

/// Why there is nothing to tell of a storm, and what to do; "" where there is.
std::pair<std::string, std::string> why_no_storm(const Evidence& e) {
  const std::string bonded = "run the storm with a bonded caisson, [regions.caisson.interface] kind = \"bonded\"";
  if (!builds_pressure(e.scene))
    return {"no region has a table cyclic",
            "give the sand under the caisson a table cyclic, such as cyclic = { relative_density = 0.6 }"};
  if (yields(e.scene))
    return {"the ground yields, so that its shear is not proportional to the wave", "write law = \"elastic\""};
  const Monitors& monitors = *e.of(monitors_of);
  if (!monitors.cyclic) return {monitors.why_no_cyclic, "look at the reason"};
  if (!monitors.cyclic->has_seen()) return {"the contact was not marched", bonded};
  if (e.solution.contact && e.solution.contact->history && !e.scene.cycles->height.empty())
    return {"the caisson slips on its ground, so that shear is not proportional to the height of the wave", bonded};
  return {};
}

std::vector<double> mean_stress_at_rest(const Evidence& e) {
  std::vector<double> list(e.simulation.mesh()->triangulation.n_active_cells(), 0.);
  const Monitors& monitors = *e.of(monitors_of);
  for (std::size_t i = 0; i < list.size(); ++i) list[i] = monitors.rest->stress.mean(i, k0_to_apply(e.scene));
  return list;
}

/// Whether each cell has an effective stress to speak of.
std::vector<bool> cells_that_count(const Mesh& mesh, const std::vector<double>& stress) {
  std::vector<double> sum(mesh.surfaces.size(), 0.), area(mesh.surfaces.size(), 0.);
  for (const auto& cell : mesh.triangulation.active_cell_iterators()) {
    sum[cell->material_id()] += std::max(stress[cell->active_cell_index()], 0.) * area_of(cell);
    area[cell->material_id()] += area_of(cell);
  }
  std::vector<bool> counts;
  for (const auto& cell : mesh.triangulation.active_cell_iterators()) {
    const double p = stress[cell->active_cell_index()];
    counts.push_back(p > 0. && p >= least_effective * sum[cell->material_id()] / area[cell->material_id()]);
  }
  return counts;
}

std::vector<StormCell> storm_cells(const Evidence& e) {
  const Space& space = *e.simulation.space();
  const std::vector<double> stress = mean_stress_at_rest(e), shear = e.of(monitors_of)->cyclic->amplitude();
  const std::vector<bool> counts = cells_that_count(space.mesh(), stress);
  std::vector<StormCell> cells(stress.size());
  for (const auto& cell : space.dofs().active_cell_iterators()) {
    const std::size_t i = cell->active_cell_index();
    StormCell& to = cells[i];
    to.counts = counts[i];
    to.effective_stress = stress[i];
    const auto& soil = space.region(cell).cyclic;
    if (!soil || std::isnan(shear[i])) continue;
    to.shear = shear[i];
    to.modulus = space.material(cell).G;
    to.strength = CyclicStrength{soil->alpha_r(), soil->beta_r()};
    if (!soil->relative_density) continue;
    Densification law;
    law.relative_density = soil->relative_density;
    to.compaction = ShearCompaction{law.C1(), law.C2(), 0.};
  }
  return cells;
}

double largest_share(const Cycles& cycles) {
  double largest = 0.;
  for (std::size_t part = 0; part < cycles.number.size(); ++part) largest = std::max(largest, cycles.share(part));
  return largest;
}

/// A region as it is gathered from its cells.
struct GatheredRegion {
  CyclicRegion told;
  double area = 0.;
};

void take_cell(const StormCell& cell, const StormFound& found, double share, double area, std::size_t i,
               const dealii::Point<dim>& middle, GatheredRegion& region) {
  CyclicRegion& told = region.told;
  region.area += area;
  told.largest_shear = std::max(told.largest_shear, cell.shear);
  if (!std::isnan(found.compaction[i]))
    told.largest_compaction = std::max(told.largest_compaction.value_or(0.), found.compaction[i]);
  if (!cell.counts) {
    told.left_out += area;
    return;
  }
  told.largest_stress_ratio = std::max(told.largest_stress_ratio, share * cell.shear / cell.effective_stress);
  if (!std::isnan(found.liquefied_at[i])) told.share_liquefied += area;
  if (std::isnan(found.largest_ratio[i])) return;
  told.ratio_at_end = std::max(told.ratio_at_end, std::min(found.pressure[i] / cell.effective_stress, 1.));
  if (found.largest_ratio[i] <= told.largest_ratio) return;
  told.largest_ratio = found.largest_ratio[i];
  told.time = found.ratio_time[i];
  told.at = {middle[0], middle[1]};
}

std::vector<CyclicRegion> cyclic_regions(const Evidence& e, const std::vector<StormCell>& cells,
                                         const StormFound& found) {
  std::map<std::string, GatheredRegion> regions;
  const double share = largest_share(*e.scene.cycles);
  for (const auto& cell : e.simulation.mesh()->triangulation.active_cell_iterators()) {
    const std::size_t i = cell->active_cell_index();
    if (!cells[i].strength) continue;
    const std::string& name = e.simulation.mesh()->surface_of(cell);
    take_cell(cells[i], found, share, area_of(cell), i, cell->center(), regions[name]);
  }
  std::vector<CyclicRegion> list;
  for (auto& [name, region] : regions) {
    CyclicRegion& told = region.told;
    const CyclicSoil& soil = *e.scene.regions.at(name).cyclic;
    told.region = name;
    told.alpha = soil.alpha_r();
    told.beta = soil.beta_r();
    told.least_cycles =
        std::max(CyclicStrength{told.alpha, told.beta}.cycles_to_liquefy(told.largest_stress_ratio), 1.);
    told.left_out /= region.area;
    told.share_liquefied /= region.area;
    list.push_back(told);
  }
  return list;
}

/// Of regions whose densification is computed.
std::map<std::string, double> largest_strains(const Evidence& e, const std::vector<StormCell>& cells) {
  std::map<std::string, double> largest;
  const double share = largest_share(*e.scene.cycles);
  for (const auto& cell : e.simulation.mesh()->triangulation.active_cell_iterators())
    if (const StormCell& of = cells[cell->active_cell_index()]; of.compaction) {
      double& strain = largest[e.simulation.mesh()->surface_of(cell)];
      strain = std::max(strain, share * of.shear / of.modulus);
    }
  return largest;
}

void tell_cells(const Evidence& e, const StormFound& found, CyclesSummary& summary) {
  for (const auto& cell : e.simulation.mesh()->triangulation.active_cell_iterators()) {
    const std::size_t i = cell->active_cell_index();
    if (!std::isnan(found.liquefied_at[i])) {
      ++summary.cells_liquefied;
      summary.area_liquefied += area_of(cell);
      summary.first_liquefied = std::min(summary.first_liquefied.value_or(HUGE_VAL), found.liquefied_at[i]);
    }
    if (!(found.largest_ratio[i] > summary.largest_ratio)) continue;
    summary.largest_ratio = found.largest_ratio[i];
    summary.time = found.ratio_time[i];
    summary.at = {cell->center()[0], cell->center()[1]};
  }
}

/// Of CyclesSummary::why_no_settling.
const char* const no_bound = "ground that bears the caisson liquefies, and how far it sinks then has no bound here";

/// Whether a cell between lines of 45 degrees from the edges of the base has liquefied.
bool bearing_ground_liquefies(const Evidence& e, const StormFound& found) {
  const Caisson& caisson = *e.simulation.compiled()->caisson;
  for (const auto& cell : e.simulation.mesh()->triangulation.active_cell_iterators()) {
    const auto d = cell->center() - caisson.bottom_centre;
    if (!std::isnan(found.liquefied_at[cell->active_cell_index()]) && d[1] < 0. &&
        std::abs(d[0]) < 0.5 * caisson.bottom_width - d[1])
      return true;
  }
  return false;
}

void tell_settling(const Evidence& e, const StormFound& found, CyclesSummary& summary) {
  const auto of = [](const std::optional<SettledBody>& body) {
    return body ? std::optional(CaissonSettling{body->down, body->rotation}) : std::nullopt;
  };
  if (!e.simulation.compiled()->caisson) {
    summary.why_no_settling = "there is no caisson";
    return;
  }
  if (bearing_ground_liquefies(e, found)) {
    summary.why_no_settling = no_bound;
    return;
  }
  const auto settled =
      settled_caisson(e.scene, *e.simulation.mesh(), e.simulation.soil_state(), {found.compaction, found.drained});
  const bool compacts =
      std::any_of(found.compaction.begin(), found.compaction.end(), [](double strain) { return !std::isnan(strain); });
  if (compacts) summary.by_compaction = of(settled[0]);
  summary.by_drainage = of(settled[1]);
  if (!summary.by_drainage) summary.why_no_settling = "the caisson deforms; settlement is told of a rigid one";
}

/// NaN where there is no such cell.
template <class Value>
std::vector<double> field_of(const std::vector<StormCell>& cells, const Value& value) {
  std::vector<double> list;
  for (const StormCell& cell : cells) list.push_back(value(cell));
  return list;
}

CyclesFound find_storm(const Evidence& e) {
  CyclesFound out;
  if (!e.scene.cycles) return out;
  std::tie(out.why_not, out.cure) = why_no_storm(e);
  if (!out.why_not.empty()) return out;
  const Cycles& cycles = *e.scene.cycles;
  const std::vector<StormCell> cells = storm_cells(e);
  const PoreFlow flow = pore_flow(*e.simulation.space(), e.scene);
  const StormFound found = run_storm(flow, cycles, cells);
  CyclesSummary& summary = out.summary.emplace();
  summary.waves = std::accumulate(cycles.number.begin(), cycles.number.end(), 0.);
  summary.duration = found.duration;
  summary.calm = found.calm;
  summary.ratio_left = found.ratio.back();
  summary.history_time = found.time;
  summary.history_ratio = found.ratio;
  summary.water = {found.source, found.stored, found.outflow, found.shed, 0.};
  if (found.source > 0.)
    summary.water.error = (found.source - found.stored - found.outflow - found.shed) / found.source;
  tell_cells(e, found, summary);
  out.largest_strain = largest_strains(e, cells);
  summary.regions = cyclic_regions(e, cells, found);
  tell_settling(e, found, summary);
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  summary.fields = std::make_shared<const CycleFields>(
      CycleFields{field_of(cells, [](const StormCell& c) { return c.counts ? c.effective_stress : none; }),
                  field_of(cells, [](const StormCell& c) { return c.strength ? c.shear : none; }), found.pressure,
                  found.largest_ratio, found.compaction, found.drained});
  return out;
}

std::optional<CyclesSummary> find_cycles(const Evidence& e) {
  return e.of(find_storm).summary;
}

std::string find_why_no_cycles(const Evidence& e) {
  return e.of(find_storm).why_not;
}

/// Whether the loads of the run's wave push one way alone: half of the way of a stress is then no amplitude of waves,
/// which have troughs.
bool is_one_sided(const Scene& scene, const Summary& summary) {
  constexpr double counts = 0.05;  // of the other way
  const auto swings = [](double up, double down) { return std::min(up, down) > counts * std::max(up, down); };
  if (is_shaken(scene)) return false;
  if (summary.response && swings(summary.response->peak_force, -summary.response->peak_force_seaward)) return false;
  return std::none_of(scene.loads.begin(), scene.loads.end(), [&](const auto& load) {
    const TimeFunction& f = load.second.history;
    return swings(extremum(f, 0., scene.time.end, 1).value, -extremum(f, 0., scene.time.end, -1).value);
  });
}

std::string liquefied_text(const CyclesSummary& cycles) {
  return "in " + with_unit(cycles.area_liquefied, "m2") + " of the ground (" + std::to_string(cycles.cells_liquefied) +
         " cells) the residual pore pressure of the storm comes to the effective stress at rest, first after " +
         with_unit(*cycles.first_liquefied, "s");
}

/// Share of the water that may be lost at places without effective stress before it is told.
constexpr double most_shed = 0.02;

/// Warnings cycles_open: a limit cannot be checked; liquefied: soil has liquefied in the storm; cycles_one_sided;
/// water_shed; beyond_compaction.
NumberedWarnings cycles_warnings(const Evidence& e, const Summary& summary) {
  NumberedWarnings list;
  if (!summary.cycles) {
    if (!summary.why_no_cycles.empty())
      list.push_back({"cycles_open", 0., e.scene.limits.pressure_ratio.value_or(1.), "1",
                      "[cycles] is given, but no residual pore pressure was computed: " + summary.why_no_cycles,
                      e.of(find_storm).cure});
    return list;
  }
  const CyclesSummary& cycles = *summary.cycles;
  if (cycles.cells_liquefied > 0)
    list.push_back({"liquefied", cycles.largest_ratio, liquefied_ratio, "1",
                    liquefied_text(cycles) + ", as at " + place_text(cycles.at) +
                        ": it has liquefied, and the stiffness, F_T and S of the run are those of sound ground" +
                        (cycles.why_no_settling == no_bound ? "; " + cycles.why_no_settling : ""),
                    "compact or drain the sand, or replace it, and run again"});
  if (is_one_sided(e.scene, summary))
    list.push_back(
        {"cycles_one_sided", 1., 2., "1",
         "[cycles] takes its shear from loads that push one way alone: without its trough a wave has up to "
         "half of its amplitude, and a storm of such waves leaves several times less pore pressure",
         "give the trough, too: [loads.NAME.wave] course = \"standing\", or a history that swings; till then "
         "what holds by [cycles] is not judged"});
  const double shed = cycles.water.source > 0. ? cycles.water.shed / cycles.water.source : 0.;
  if (cycles.cells_liquefied == 0 && shed > most_shed)
    list.push_back(
        {"water_shed", shed, most_shed, "1",
         percent(shed) +
             " of the water that cycles press out leaves no pressure, at places without effective "
             "stress such as the toe of a mound, though no cell has liquefied: the pressure beside them may be "
             "too low",
         "halve the cells (mesh.refine = 1) and see whether the ratio grows"});
  for (const auto& [region, strain] : e.of(find_storm).largest_strain)
    if (strain > largest_measured)
      list.push_back({"beyond_compaction", strain, largest_measured, "1",
                      "region '" + region + "' is sheared by an amplitude of " + significant(strain, 2) +
                          " in the storm: densification was measured up to 0.003",
                      "trust no settlement of '" + region + "' where it is sheared so much"});
  return list;
}

/// Tilt over settlement (rad/m) of a section that is its own mirror image.
constexpr double tilt_of_round_off = 1e-6;

Check settling_check(const CyclesSummary& cycles, const std::string& name, const std::string& unit,
                     double CaissonSettling::*part, const Limits& limits) {
  const bool tilts = part == &CaissonSettling::tilt;
  const std::string member = tilts ? "tilt" : "settlement";
  const FailureMode mode = tilts ? FailureMode::tilt : FailureMode::settlement;
  const auto limit = tilts ? &Limits::tilt : &Limits::settlement;
  const std::string after = "after all residual pressure has gone, in drained elastic ground; ";
  if (cycles.why_no_settling == no_bound)
    return held_to(check_of(mode, name, unit, {}, "cycles.by_compaction." + member, after + no_bound), limits, limit);
  if (!cycles.why_no_settling.empty())
    return not_checked(held_to(check_of(mode, name, unit, {}, "cycles.by_compaction." + member, ""), limits, limit),
                       cycles.why_no_settling);
  const bool compacts = cycles.by_compaction.has_value();
  const double found = (compacts ? *cycles.by_compaction : *cycles.by_drainage).*part;
  const double demand = tilts ? std::abs(found) : std::max(0., found);
  const std::string way = compacts ? "by_compaction." : "by_drainage.";
  const Check check =
      held_to(check_of(mode, name, unit, demand, "cycles." + way + member,
                       after +
                           (compacts ? "densification by cycles (Byrne 1991)"
                                     : "the water that cycles press out (Seed and Rahman 1978)") +
                           (tilts ? ", which know no direction: not by the lasting push of waves" : "")),
              limits, limit);
  const double down = (compacts ? *cycles.by_compaction : *cycles.by_drainage).settlement;
  if (tilts && demand < tilt_of_round_off * std::abs(down))
    return not_checked(check,
                       "amplitudes of shear know no direction, and so they do not tilt a section that is its own "
                       "mirror image; the lasting push of waves, which does, is not in them");
  return check;
}

Checks cycles_checks(const Scene& scene, const Summary& summary) {
  if (!scene.cycles) return {};
  if (!summary.cycles) {
    Checks list;
    const auto add = [&](FailureMode mode, const char* name, const char* unit, std::optional<double> Limits::*limit,
                         const char* measure) {
      if (scene.limits.*limit)
        list.push_back(not_checked(held_to(check_of(mode, name, unit, {}, measure, ""), scene.limits, limit),
                                   summary.why_no_cycles));
    };
    add(FailureMode::residual_pressure, "residual pore pressure", "", &Limits::pressure_ratio, "cycles.largest_ratio");
    add(FailureMode::settlement, "settlement in the storm", "m", &Limits::settlement,
        "cycles.by_compaction.settlement");
    add(FailureMode::tilt, "tilt in the storm", "rad", &Limits::tilt, "cycles.by_compaction.tilt");
    return list;
  }
  const CyclesSummary& cycles = *summary.cycles;
  std::string how = "over the mean effective stress at rest; shear in proportion to the height, in elastic ground";
  for (const CyclicRegion& region : cycles.regions) {
    const CyclicSoil& soil = *scene.regions.at(region.region).cyclic;
    how += "; " + region.region + ": tau/sigma'_0 = " + significant(region.alpha) + " N^" + significant(region.beta) +
           (soil.alpha && soil.beta ? "" : ", assumed by its relative density");
  }
  Checks list{held_to(check_of(FailureMode::residual_pressure, "residual pore pressure", "", cycles.largest_ratio,
                               "cycles.largest_ratio", how),
                      scene.limits, &Limits::pressure_ratio),
              settling_check(cycles, "settlement in the storm", "m", &CaissonSettling::settlement, scene.limits),
              settling_check(cycles, "tilt in the storm", "rad", &CaissonSettling::tilt, scene.limits)};
  if (!is_one_sided(scene, summary)) return list;
  for (Check& check : list)
    check = in_doubt(check, "it holds with the shear of a crest alone, and the wave of the run has no trough");
  return list;
}

OutputSchema<CyclicRegion> cyclic_region_outputs() {
  using R = CyclicRegion;
  const auto least = [](const R& r) {
    return std::isfinite(r.least_cycles) ? std::optional(r.least_cycles) : std::nullopt;
  };
  return OutputSchema<R>()
      .key("region", &R::region, "", "its name")
      .key("alpha", &R::alpha, "", "of tau/sigma'_0 = alpha N^beta, by which N cycles liquefy it")
      .key("beta", &R::beta, "", "its exponent")
      .key("largest_shear", &R::largest_shear, "Pa", "largest amplitude of shear stress in the run's wave")
      .key("largest_stress_ratio", &R::largest_stress_ratio, "",
           "largest tau/sigma'_0 in the largest waves of the storm")
      .key("least_cycles", least, "", "of these waves that liquefy the soil there; null without shear")
      .key("largest_ratio", &R::largest_ratio, "", "largest residual pressure over sigma'_0 at any time; 1: liquefied")
      .key("at[]", &R::at, "m", "where that is")
      .key("time", &R::time, "s", "and when, from the beginning of the storm")
      .key("ratio_at_end", &R::ratio_at_end, "", "the largest when the storm ends")
      .key("share_liquefied", &R::share_liquefied, "", "share of the area that liquefied")
      .key("left_out", &R::left_out, "", "share of the area that is left out of ratios: free surfaces")
      .key("largest_compaction", &R::largest_compaction, "",
           "largest volumetric strain by cycles of shear; null without a relative density");
}

OutputSchema<CaissonSettling> settling_outputs() {
  using S = CaissonSettling;
  return OutputSchema<S>()
      .key("settlement", &S::settlement, "m", "of the middle of the bottom, downward")
      .key("tilt", &S::tilt, "rad", "landward positive");
}

OutputSchema<ResidualWater> water_outputs() {
  using W = ResidualWater;
  return OutputSchema<W>()
      .key("source", &W::source, "m2", "that cycles press out of the soil")
      .key("stored", &W::stored, "m2", "still under pressure at the end of the calm")
      .key("outflow", &W::outflow, "m2", "that has drained")
      .key("shed", &W::shed, "m2", "that liquefied soil does not press out, as it bears nothing")
      .key("error", &W::error, "", "of the balance, over the source");
}

OutputSchema<CyclesSummary> cycles_outputs() {
  using C = CyclesSummary;
  return OutputSchema<C>()
      .key("waves", &C::waves, "", "waves of the storm")
      .key("duration", &C::duration, "s", "of the storm")
      .key("calm", &C::calm, "s", "time after it that was followed")
      .key("largest_ratio", &C::largest_ratio, "", "largest residual pressure over the mean effective stress at rest")
      .key("at[]", &C::at, "m", "where that is")
      .key("time", &C::time, "s", "and when, from the beginning of the storm")
      .key("cells_liquefied", &C::cells_liquefied, "", "cells in which it came to 1")
      .key("area_liquefied", &C::area_liquefied, "m2", "their area")
      .key("first_liquefied", &C::first_liquefied, "s", "when the first of them did; null where none did")
      .key("ratio_left", &C::ratio_left, "", "the largest ratio at the end of the calm")
      .object("water", &C::water, water_outputs(), "volumes of water per metre, over storm and calm")
      .object("by_compaction", &C::by_compaction, settling_outputs(),
              "how the caisson settles by densification of the sand under cycles of shear; null without a relative "
              "density")
      .object("by_drainage", &C::by_drainage, settling_outputs(),
              "how it settles by the water that the residual pressure presses out")
      .reason("why_no_settling", &C::why_no_settling, "why neither is told; null where one is")
      .list("regions[]", &C::regions, cyclic_region_outputs(), "each region with a table cyclic");
}

}  // namespace

Finding cycles_finding() {
  Finding f;
  f.keys
      .object("cycles", &Summary::cycles, cycles_outputs(),
              "[residual pore pressure, settlement and tilt of a storm](cycles.md); null without [cycles], and where "
              "`why_no_cycles` says so")
      .reason("why_no_cycles", &Summary::why_no_cycles, "why not, where a storm is given; null where they are there");
  f.warnings = cycles_warnings;
  f.checks = cycles_checks;
  return f.part(&Summary::cycles, find_cycles).part(&Summary::why_no_cycles, find_why_no_cycles);
}

}  // namespace upbead
