#include <iostream>

#include "base/files.h"
#include "base/interrupt.h"
#include "cli/commands.h"
#include "design/calibrate/calibration.h"
#include "design/calibrate/calibration_checks.h"
#include "design/calibrate/calibration_report.h"
#include "design/design.h"
#include "design/design_files.h"

namespace upbead {

namespace {

void run_calibration(const CommonOptions& options) {
  const Design design = read_design(options.file, options.overrides, {check_calibration});
  note_interrupts();
  const std::string out = options.out.empty() ? "results/" + design.stem + "-calibration" : options.out;
  require_inputs_kept(out, {"summary.json", "calibration.csv", "results.h5", "case.toml"}, input_files(design));
  OutputFolder folder(out);
  const Calibration found = calibrate(design);
  const std::string json = to_json(design, found);
  folder.write("summary.json", json);
  folder.write("calibration.csv", calibration_csv(found));
  folder.write("results.h5", calibration_file(design, found));
  folder.write("case.toml", effective_design(design, folder.name()));
  check_interrupt();
  folder.commit();
  std::cerr << notes_and_warnings(found);
  std::cout << (options.json ? json
                             : describe(design, found) + "written     " + folder.name() +
                                   "/{summary.json, calibration.csv, results.h5, case.toml}\n");
}

const char* const calibrate_footer =
    "Sends the impulsive forces of a family of waves and mounds through reduced models, finds tau_0 of each history "
    "by\n"
    "equal sliding at given r = F_Smax/(mu W'), and fits k = tau_0/tau_0F = 1/(alpha*^a + 1)^b to it, with the region\n"
    "of confidence of a and b (docs/calibration.md). Every number of the force histories is an assumption.\n"
    "A design needs a section (see 'upbead waves --help') and:\n"
    "  [calibration]\n"
    "  period = [8.0, 10.0, 12.0]            # T (s); relative_height, relative_berm_depth, ... have defaults\n"
    "  [calibration.models.prototype]\n"
    "  model = \"results/prototype/reduced.h5\"  # made by 'upbead reduce'\n"
    "  [calibration.models.model]\n"
    "  model = \"results/model/reduced.h5\"\n"
    "  scale = 0.05                          # its size over that of [section]\n\n"
    "Writes into results/NAME-calibration (or --out DIR), all or nothing:\n"
    "  summary.json     the fits by model, r and formula, and those of the given [duration] a, b\n"
    "  calibration.csv  a row per model, wave and r; results.h5 the same\n"
    "  case.toml        the design with all defaults; runs again\n\n"
    "Examples:\n"
    "  upbead calibrate cases/calibration/fig2b.toml\n"
    "  upbead calibrate cases/calibration/fig2b.toml --set impact.peak_gain=2 --set 'calibration.ratios=[1.2]'\n"
    "  upbead calibrate cases/calibration/fig2b.toml --json | jq '.models[].fits[] | select(.measure == \"exact\")'\n"
    "  upbead calibrate --keys";

}  // namespace

void add_calibrate(CLI::App& program) {
  auto options = std::make_shared<CommonOptions>();
  auto keys = std::make_shared<bool>(false);
  CLI::App* command =
      program.add_subcommand("calibrate", "k(alpha*) of tau_0 = k tau_0F from the caisson's own dynamics");
  add_common_options(*command, *options);
  command->get_option("FILE")->required(false)->description("the design (TOML)");
  command->get_option("--out")->description(
      "folder for the results (default: results/NAME-calibration, NAME as the file's)");
  command->add_flag("--keys", *keys, "print every key of a design file with unit, range, default and meaning");
  command->footer(calibrate_footer);
  command->callback([options, keys] {
    if (*keys)
      std::cout << design_reference();
    else if (options->file.empty())
      throw CLI::RequiredError("FILE");
    else
      run_calibration(*options);
  });
}

}  // namespace upbead
