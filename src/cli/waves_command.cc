#include <iostream>

#include "base/files.h"
#include "base/interrupt.h"
#include "cli/commands.h"
#include "design/design.h"
#include "design/design_files.h"
#include "design/waves_report.h"

namespace upbead {

namespace {

void require_waves(const Design& design) {
  if (design.tables.waves.empty())
    throw InputError(design.document.place("waves"), "the design has no wave",
                     "add a table [waves.NAME] with height (m) and period (s)");
}

void waves(const CommonOptions& options) {
  const Design design = read_design(options.file, options.overrides);
  require_waves(design);
  note_interrupts();
  const std::string out = options.out.empty() ? "results/" + design.stem : options.out;
  require_inputs_kept(out, {"summary.json", "case.toml"}, input_files(design));
  OutputFolder folder(out);
  const std::vector<WaveAnswer> answers = answer_waves(design.tables);
  const std::string json = to_json(design.tables, answers);
  folder.write("summary.json", json);
  folder.write("case.toml", effective_design(design, folder.name()));
  check_interrupt();
  folder.commit();
  std::cerr << warning_lines(answers);
  std::cout << (options.json ? json
                             : describe(design.tables, answers) + "\nwritten     " + folder.name() +
                                   "/{summary.json, case.toml}\n");
}

}  // namespace

void add_waves(CLI::App& program) {
  auto options = std::make_shared<CommonOptions>();
  auto keys = std::make_shared<bool>(false);
  CLI::App* command =
      program.add_subcommand("waves", "pressure, safety factors and sliding distance of given waves, by formulas");
  add_common_options(*command, *options);
  command->get_option("FILE")->required(false)->description("the design (TOML)");
  command->get_option("--out")->description("folder for the results (default: results/NAME, NAME as the design's)");
  command->add_flag("--keys", *keys, "print every key of a design file with unit, range, default and meaning");
  command->footer(
      "For each wave of the design: Goda's pressure with the impulsive pressure coefficient alpha_I of Takahashi,\n"
      "Tanimoto and Shimosako, safety factors, how long the shear force lasts (tau_0) and how far the caisson slides.\n"
      "A design needs a section and at least one wave:\n"
      "  [section]\n"
      "  water_depth = 15.0         # h, at the wall (m)\n"
      "  foundation_depth = 10.5    # h', still water to the caisson's bottom (m)\n"
      "  berm_depth = 8.5           # d, still water to the armour of the mound (m)\n"
      "  crest = 6.0                # h_c, above still water (m)\n"
      "  width = 12.0               # B (m)\n"
      "  berm_width = 8.0           # B_M (m)\n"
      "  bed_slope = 0.01           # tan(theta)\n"
      "  weight = 4.27e6            # W, in air with fill (N/m)\n"
      "  buoyant_weight = 3.0e6     # W', in still water (N/m)\n"
      "  [waves.design]\n"
      "  height = 12.0              # H, the highest wave (m); or deep_water_height\n"
      "  period = 12.0              # T (s)\n\n"
      "Writes into results/NAME (or --out DIR), all or nothing:\n"
      "  summary.json   all numbers, SI units, one object a wave\n"
      "  case.toml      the design with all defaults spelled out; runs again as it is\n"
      "Warnings about waves and sections that the formulas were not made for go to stderr and into summary.json.\n\n"
      "Examples:\n"
      "  upbead waves cases/fig10/impulsive.toml\n"
      "  upbead waves cases/fig10/impulsive.toml --set section.friction=0.5 --json | jq '.waves[].safety_sliding'\n"
      "  upbead waves --keys");
  command->callback([options, keys] {
    if (*keys) {
      std::cout << design_reference();
    } else if (options->file.empty()) {
      throw CLI::RequiredError("FILE");
    } else {
      waves(*options);
    }
  });
}

}  // namespace upbead
