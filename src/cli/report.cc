#include "cli/report.h"

#include <algorithm>
#include <cmath>

#include "base/format.h"
#include "base/text.h"
#include "case/case_findings.h"
#include "case/case_run.h"
#include "case/cfd/flow_scene.h"
#include "case/time_end.h"
#include "case/wave_load.h"
#include "fem/compile.h"
#include "model/words.h"
#include "output/checks.h"
#include "response/time_choice.h"
#include "run/yielding_extent.h"

namespace upbead {

namespace {

std::string describe_regions(const Case& input, const Simulation& simulation) {
  std::string text;
  for (const Decision& decision : simulation.decisions) {
    const std::string& name = decision.region;
    if (name.empty()) continue;
    const std::string kind = word_of(input.scene.regions.at(name).kind, region_kind_words);
    std::string line = kind + (decision.value == kind ? "" : ", " + decision.value) +
                       (decision.key == "flow" ? " flow: " : ": ") + decision.why;
    for (const Body& body : simulation.compiled->bodies)
      if (body.region == name)
        line += format(", %.5g kg/m, centre of gravity (%.4g, %.4g) m, inertia %.4g kg m2/m", body.mass, body.centre[0],
                       body.centre[1], body.moment_of_inertia);
    text += format("  %-12s ", name.c_str()) + line + "\n";
  }
  return text;
}

/// Largest velocity of a motion, and whether the boundary itself moves so or waves arrive from below through it.
std::string describe_motion(const Load& load, const Scene& scene) {
  const bool arrives = scene.boundaries.at(load.boundary).displacement == DisplacementCondition::absorbing;
  const double up = extremum(load.history, 0., scene.time.end, 1).value;
  const double down = extremum(load.history, 0., scene.time.end, -1).value;
  const std::string what = arrives ? "waves from below '" + load.boundary + "', by the motion of its outcrop"
                                   : "moves '" + load.boundary + "'";
  return format("%s: at most %.4g m/s", what.c_str(),
                std::max(up, -down) * std::hypot(load.direction[0], load.direction[1]));
}

std::string describe_loads(const Simulation& simulation) {
  std::string text;
  for (const LoadOnCaisson& load : simulation.compiled->loads_on_caisson) {
    std::string line = format("  %-12s ", load.name.c_str());
    const auto written = simulation.given.loads.find(load.name);
    if (written != simulation.given.loads.end() && is_motion(written->second.kind)) {
      text += line + describe_motion(written->second, simulation.given) + "\n";
      continue;
    }
    const double largest = std::max(std::abs(load.force_x), std::abs(load.force_y));
    if (const auto arm = load.arm())
      line += format("arm %.4g m above the caisson's bottom, F_x = %.4g per unit, F_y = %.4g", *arm,
                     without_round_off(load.force_x, largest), without_round_off(load.force_y, largest));
    else
      line += simulation.compiled->caisson ? "no horizontal force on the caisson" : "no caisson to act on";
    text += line + "\n";
  }
  return text;
}

/// What may yield, and why all else is linear.
std::string describe(const YieldingExtent& extent) {
  if (extent.cells == 0) return "yielding    none: no region has law = \"hysteretic\" or \"mohr_coulomb\"\n";
  std::string text = format("yielding    %d of %d cells that deform may yield\n", extent.cells, extent.of);
  for (const Skipped& part : extent.linear) text += "  linear      " + part.what + ": " + part.why + "\n";
  return text;
}

std::string describe(const MeshAccuracy& accuracy) {
  std::string text = "adapted     unknowns (error of the history of F_T, of its peak):";
  for (const auto& [unknowns, error] : accuracy.levels)
    text += format(" %d (%.2g, %.2g)", unknowns, error.history, error.peak);
  return text + "\n";
}

}  // namespace

std::string describe(const Case& input, const Simulation& simulation, const std::vector<MeasuredRecord>& measured) {
  std::string text = input.scene.title + "\n";
  text += format("mesh        %d cells of degree %d, %d unknowns (%d of them relative fluid displacements)\n",
                 static_cast<int>(simulation.mesh->triangulation.n_active_cells()), simulation.space->degree(),
                 simulation.unknowns->n_free(), [&] {
                   int n = 0;
                   for (const IndexRange& block : simulation.unknowns->blocks()) n += block.size();
                   return n;
                 }());
  if (const int n = simulation.mesh->n_high_order; n > 0)
    text += format("            %d cells of second or higher order, read by their corners\n", n);
  if (simulation.processes) text += format("            divided among %d processes\n", simulation.processes->count());
  if (simulation.accuracy) text += describe(*simulation.accuracy);
  text += "regions\n" + describe_regions(input, simulation);
  text += "loads\n" + describe_loads(simulation) + describe(record_summaries(input, measured));
  text +=
      describe(flow_summaries(input)) + describe(gauge_summaries(input, simulation)) + describe(wave_summaries(input));
  const SchemeChoice choice = choose_scheme(simulation.scene, *simulation.compiled);
  text += "in time     " + word_of(choice.scheme, time_scheme_words) + ": " + choice.reason +
          (choice.solves.empty() ? "" : "; " + choice.solves) + "\n";
  if (end_is_open(input))
    text += "            until " + significant(simulation.given.time.end) + " s, " +
            settled_end(input, *simulation.mesh).why + "\n";
  text += describe(yielding_extent(simulation));
  if (simulation.compiled->system.interface)
    text += "contact     friction " + significant(contact_friction(simulation.scene)) + " at " +
            std::to_string(simulation.compiled->system.interface->n_nodes()) +
            " nodes; followed where the bonded caisson would slip or lift at one of them\n";
  text += "skipped\n";
  for (const Skipped& item : skipped(input, simulation, choice.scheme == TimeScheme::reduced))
    text += "  " + item.what + ": " + item.why + "\n";
  return text;
}

std::string describe(const Run& run) {
  const Summary& s = run.summary;
  const Timing& t = s.timing;
  return details_of(s) + (s.verdict ? describe(*s.verdict, s.checks) : "") +
         format(
             "time        mesh %.2f s, compile %.2f s, factorise %.2f s, march %.2f s, output %.2f s, total %.2f s\n",
             t.mesh, t.compile, t.factorise, t.march, t.output, t.total);
}

}  // namespace upbead
