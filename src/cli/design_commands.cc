// The commands waves and calibrate, and what they share with expected and reliability, which evaluate formulas for a
// section.
#include <iostream>

#include "base/files.h"
#include "base/interrupt.h"
#include "cli/design_command.h"
#include "design/calibrate/calibration_report.h"
#include "design/waves_report.h"
#include "output/output_text.h"

namespace upbead {

namespace {

/// Where a file is a case, too, the folder of its name is that of its run.
std::string default_folder(const Design& design, const DesignWork& work) {
  const bool is_case = design.document.find("loads") && design.document.find("mesh");
  return "results/" + design.stem + (work.suffix.empty() && is_case ? "-waves" : work.suffix);
}

int work_on(DesignOptions options, const DesignWork& work, const Stopwatch& since_start) {
  const Design design = read_design(options.file, options.overrides, work.checks);
  note_interrupts();
  if (options.out.empty()) options.out = default_folder(design, work);
  require_inputs_kept(options.out, work.files, input_files(design));
  if (!options.part.empty()) return work.part(design, options);
  OutputFolder folder(options.out);
  const DesignOutput answer = work.answer(design, options, since_start);
  for (const auto& [name, bytes] : answer.files) folder.write(name, bytes);
  folder.write("case.toml", effective_design(design, folder.name()));
  const std::string json = json_text(answer.summary);
  folder.write("summary.json", json);
  check_interrupt();
  folder.commit({"results.h5", "sheet.md"});  // of another command, whose summary is replaced
  std::cerr << answer.warnings;
  std::cout << (options.json ? json
                             : (options.details
                                    ? text_of(answer.summary, work.rows())
                                    : answer.brief + "            --details prints all else, summary.json has it\n") +
                                   "written     " + folder.name() + "/{" + join(work.files) + "}\n");
  return 0;
}

void require_waves(const DesignTables& tables, const Document& document, Diagnostics& report) {
  if (tables.waves.empty() && report.sound("waves"))
    report.add(document.place("waves"), "the design has no wave",
               "add a table [waves.NAME] with height (m) and period (s)");
}

DesignOutput waves(const Design& design, const DesignOptions&, const Stopwatch&) {
  const std::vector<WaveAnswer> answers = answer_waves(design.tables);
  Json summary = to_json(design, answers);
  std::string text = brief(design, answers, summary);
  return {{}, std::move(summary), std::move(text), describe(warnings_of(design, answers))};
}

DesignOutput calibrated(const Design& design, const DesignOptions&, const Stopwatch&) {
  const Calibration found = calibrate(design);
  Json summary = to_json(design, found);
  std::string text = brief(summary);
  return {{{"calibration.csv", calibration_csv(found)}, {"results.h5", calibration_file(design, found)}},
          std::move(summary),
          std::move(text),
          describe(warnings_of(design, found))};
}

}  // namespace

Command design_command(Command command, const DesignWork& work) {
  const auto options = std::make_shared<DesignOptions>();
  command.options = common_options(*options, "design",
                                   "the results (default: results/NAME" + work.suffix + ", NAME as the " +
                                       (work.suffix.empty() ? "design's)" : "file's)")) +
                    std::vector<Option>{{"--details", &options->details, "print every number of the summary"}};
  if (work.part)
    command.options =
        command.options +
        std::vector<Option>{
            {"--part", &options->part,
             "compute part K of N of the lives alone; auto: as mpirun, srun or a Slurm array tells", "K/N"},
            {"--merge", &options->merge, "take the lives that the parts have computed"}};
  command.texts = {
      {"--keys", "print every key of a design file with unit, range, default and meaning", design_reference},
      {"--schema", "print them as JSON Schema, by which an editor completes and checks a design file",
       design_json_schema}};
  command.work = [options, work, since_start = Stopwatch()] { return work_on(*options, work, since_start); };
  return command;
}

namespace {

const char* const waves_footer =
    R"(For each wave of the design: Goda's pressure with the impulsive pressure coefficient alpha_I of Takahashi,
Tanimoto and Shimosako, safety factors, how long the shear force lasts (tau_0) and how far the caisson slides.
A design needs a section and at least one wave:
  [section]
  water_depth = 15.0         # h, at the wall (m)
  foundation_depth = 10.5    # h', still water to the caisson's bottom (m)
  berm_depth = 8.5           # d, still water to the armour of the mound (m)
  crest = 6.0                # h_c, above still water (m)
  width = 12.0               # B (m)
  berm_width = 8.0           # B_M (m)
  bed_slope = 0.01           # tan(theta)
  weight = 4.27e6            # W, in air with fill (N/m)
  submerged_weight = 3.0e6     # W', in still water (N/m)
  [waves.design]
  height = 12.0              # H, the highest wave (m); or deep_water_height
  period = 12.0              # T (s)

Writes into results/NAME, of a file that is a case, too, results/NAME-waves (or --out DIR), all or nothing:
  summary.json   all numbers, SI units, one object a wave
  case.toml      the design with all defaults spelled out; runs again as it is
Warnings about waves and sections that the formulas were not made for go to stderr and into summary.json.

Examples:
  upbead waves cases/fig10/impulsive.toml
  upbead waves cases/fig10/impulsive.toml --set section.friction=0.5 --json | jq '.waves[].safety_sliding'
  upbead waves --keys)";

const char* const calibrate_footer =
    R"(Sends the impulsive forces of a family of waves and mounds through reduced models, finds tau_0 of each history by
equal sliding at given r = F_Smax/(mu W'), and fits k = tau_0/tau_0F = 1/(alpha*^a + 1)^b to it, with the region
of confidence of a and b (docs/calibration.md). Every number of the force histories is an assumption.
A design needs a section (see 'upbead waves --help') and:
  [calibration]
  period = [8.0, 10.0, 12.0]            # T (s); relative_height, relative_berm_depth, ... have defaults
  [calibration.models.prototype]
  model = "results/prototype/reduced.h5"  # made by 'upbead reduce'
  [calibration.models.model]
  model = "results/model/reduced.h5"
  scale = 0.05                          # its size over that of [section]

Writes into results/NAME-calibration (or --out DIR), all or nothing:
  summary.json     the fits by model, r and formula, and those of the given [duration] a, b
  calibration.csv  a row per model, wave and r; results.h5 the same
  case.toml        the design with all defaults; runs again

Examples:
  upbead calibrate cases/calibration/fig2b.toml
  upbead calibrate cases/calibration/fig2b.toml --set impact.peak_gain=2 --set 'calibration.ratios=[1.2]'
  upbead calibrate cases/calibration/fig2b.toml --json | jq '.models[].fits[] | select(.measure == "exact")'
  upbead calibrate --keys)";

}  // namespace

std::vector<Command> design_commands() {
  const auto command = [](const std::string& name, const std::string& what, const std::string& footer) {
    return Command{name, what, {}, {}, footer};
  };
  return {design_command(command("waves", "pressure, safety factors and sliding distance of given waves, by formulas",
                                 waves_footer),
                         {"", {require_waves}, {"summary.json", "case.toml"}, rows_of_waves, waves}),
          expected_command(),
          design_command(
              command("calibrate", "k(alpha*) of tau_0 = k tau_0F from the caisson's own dynamics", calibrate_footer),
              {"-calibration",
               {check_calibration},
               {"summary.json", "calibration.csv", "results.h5", "case.toml"},
               rows_of_calibration,
               calibrated})};
}

}  // namespace upbead
