#include <iostream>
#include <nlohmann/json.hpp>

#include "case/case_run.h"
#include "case/script_trust.h"
#include "cli/command.h"
#include "cli/report.h"
#include "fem/compile.h"
#include "model/exclusions.h"
#include "response/time_choice.h"

namespace upbead {

namespace {

struct ExplainOptions : CommonOptions {
  bool trusted = false;
};

bool will_be_reduced(const Simulation& simulation) {
  return choose_scheme(simulation.scene, *simulation.compiled).scheme == TimeScheme::reduced;
}

std::string explanation_json(const Case& input, const Simulation& simulation, const NumberedWarnings& told) {
  nlohmann::ordered_json json = {{"title", input.scene.title}};
  json["discretisation"] = {{"cells", simulation.mesh->triangulation.n_active_cells()},
                            {"unknowns", simulation.compiled->system.n_free()},
                            {"degree", simulation.space->degree()}};
  json["regions"] = nlohmann::ordered_json::object();
  for (const Decision& decision : simulation.decisions)
    if (!decision.region.empty())
      json["regions"][decision.region] = {{decision.key, decision.value}, {"why", decision.why}};
  json["loads"] = nlohmann::ordered_json::object();
  for (const LoadOnCaisson& load : simulation.compiled->loads_on_caisson) {
    json["loads"][load.name] = {{"force_x", load.force_x}, {"force_y", load.force_y}, {"moment", load.moment}};
    json["loads"][load.name]["arm"] = load.arm() ? nlohmann::ordered_json(*load.arm()) : nullptr;
  }
  json["gauges"] = nlohmann::ordered_json::parse(gauges_json(gauge_summaries(input, simulation)));
  json["skipped"] = nlohmann::ordered_json::array();
  for (const Skipped& item : skipped(input, simulation, will_be_reduced(simulation)))
    json["skipped"].push_back({{"what", item.what}, {"why", item.why}});
  json["warnings"] = nlohmann::ordered_json::array();
  for (const NumberedWarning& w : told)
    json["warnings"].push_back(
        {{"name", w.name}, {"value", w.value}, {"limit", w.limit}, {"unit", w.unit}, {"text", w.text}});
  return json.dump(2) + "\n";
}

int explain(const ExplainOptions& options) {
  const Case input = read_case(options.file, options.overrides);
  require_trust(input, options.trusted);
  const Simulation simulation = simulation_of(input);
  const NumberedWarnings told = warnings(input, simulation);
  std::cerr << describe(told);
  std::cout << (options.json ? explanation_json(input, simulation, told) : describe(input, simulation));
  return 0;
}

const char* const explain_footer =
    R"(Reads, checks and meshes the case, solves nothing and writes nothing. Prints the mesh, how the pore water of each
region is treated and why, each load's arm above the caisson's bottom, and what is skipped.

Examples:
  upbead explain cases/fig2b-model.toml
  upbead explain cases/fig2b-model.toml --set regions.mound.hydraulic_conductivity=1e-3
  upbead explain --keys)";

}  // namespace

Command explain_command() {
  const auto options = std::make_shared<ExplainOptions>();
  Command command = solver_command("explain");
  command.options = common_options(*options) + std::vector{trust_option(options->trusted)};
  command.texts = {{"--keys", "print every key of a case file with unit, range, default and meaning", case_reference},
                   {"--exclusions", "print what cannot go with what", exclusion_table}};
  command.footer = explain_footer;
  command.work = [options] { return explain(*options); };
  return command;
}

}  // namespace upbead
