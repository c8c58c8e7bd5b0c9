#include <iostream>
#include <nlohmann/json.hpp>

#include "case/case_run.h"
#include "case/script_trust.h"
#include "cli/commands.h"
#include "cli/program.h"
#include "cli/report.h"
#include "fem/compile.h"
#include "model/exclusions.h"
#include "response/scheme_choice.h"

namespace upbead {

namespace {

bool will_be_reduced(const Simulation& simulation) {
  return choose_scheme(simulation.scene, *simulation.compiled).scheme == TimeScheme::reduced;
}

std::string to_json(const Case& input, const Simulation& simulation, const NumberedWarnings& told) {
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

void explain(const CommonOptions& options, bool trusted) {
  const Case input = read_case(options.file, options.overrides);
  require_trust(input, trusted);
  const Simulation simulation = simulation_of(input);
  const NumberedWarnings told = warnings(input, simulation);
  std::cerr << describe(told);
  std::cout << (options.json ? to_json(input, simulation, told) : describe(input, simulation));
}

}  // namespace

void add_explain(CLI::App& program) {
  auto options = std::make_shared<CommonOptions>();
  auto keys = std::make_shared<bool>(false), trusted = std::make_shared<bool>(false);
  CLI::App* command = &add_solver_command(program, "explain");
  add_common_options(*command, *options);
  add_trust_option(*command, *trusted);
  command->get_option("FILE")->required(false);
  command->add_flag("--keys", *keys, "print every key of a case file with unit, range, default and meaning");
  auto exclusions = std::make_shared<bool>(false);
  command->add_flag("--exclusions", *exclusions, "print what cannot go with what");
  command->footer(
      "Reads, checks and meshes the case, solves nothing and writes nothing. Prints the mesh, how the pore water of "
      "each\n"
      "region is treated and why, each load's arm above the caisson's bottom, and what is skipped.\n\n"
      "Examples:\n"
      "  upbead explain cases/fig2b-model.toml\n"
      "  upbead explain cases/fig2b-model.toml --set regions.mound.hydraulic_conductivity=1e-3\n"
      "  upbead explain --keys");
  command->callback([options, keys, exclusions, trusted] {
    if (*keys || *exclusions) {
      std::cout << (*keys ? case_reference() : exclusion_table());
    } else if (options->file.empty()) {
      throw CLI::RequiredError("FILE");
    } else {
      explain(*options, *trusted);
    }
  });
}

}  // namespace upbead
