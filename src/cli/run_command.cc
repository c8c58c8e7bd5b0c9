#include <functional>
#include <iostream>
#include <optional>

#include "base/files.h"
#include "base/interrupt.h"
#include "base/progress.h"
#include "base/stopwatch.h"
#include "case/case_run.h"
#include "case/input_files.h"
#include "case/script_trust.h"
#include "checkpoints.h"
#include "cli/commands.h"
#include "cli/program.h"
#include "cli/report.h"
#include "output/fields.h"
#include "run/histories.h"
#include "several_processes.h"

namespace upbead {

namespace {

/// `visible`: whether people see how far it is.
Run solve(const Case& input, const Simulation& simulation, const std::vector<MeasuredRecord>& records,
          FieldOutput& fields, Checkpoints* checkpoints, bool visible) {
  std::optional<Progress> line;
  if (visible) line.emplace("solving");
  RunOptions options;
  options.progress = [&line](double done) {
    check_interrupt();
    if (line) line->update(done);
  };
  options.observer = [&fields](const Simulation& marched) { return fields.begin(marched); };
  if (checkpoints) options.checkpoints = checkpoints->begin(fields);
  return solve(input, simulation, records, options);
}

/// Writes all files but the fields themselves; returns the summary as JSON.
std::string write(const Case& input, const std::vector<MeasuredRecord>& records, Run& run, const FieldOutput& fields,
                  const Stopwatch& since_start, OutputFolder& folder) {
  const Stopwatch watch;
  fields.finish();
  const std::vector<History> computed = histories(*run.simulation, run.response.ends);
  std::vector<History> others = tables(run);
  for (History& table : measured_tables(records)) others.push_back(std::move(table));
  folder.write("results.h5", result_file(input.scene.title, computed, others));
  folder.write("case.toml", effective_case(input, folder.name()));
  run.summary.timing.march -= fields.seconds();
  run.summary.timing.output = watch.seconds() + fields.seconds();
  run.summary.timing.total = since_start.seconds();
  std::string json = to_json(run.summary);
  folder.write("summary.json", json);
  check_interrupt();
  folder.commit(field_files);
  return json;
}

/// What a run writes, as patterns.
std::vector<std::string> run_files() {
  std::vector<std::string> files{"results.h5", "summary.json", "case.toml"};
  files.insert(files.end(), field_files.begin(), field_files.end());
  return files;
}

/// On several processes all do the same but for the system, which they divide; the first speaks and writes.
void run(const CommonOptions& options, const CheckpointWish& wish, bool trusted, const Stopwatch& since_start,
         const std::shared_ptr<const Processes>& processes) {
  const bool is_first = !processes || processes->rank() == 0;
  const Case input = read_case(options.file, options.overrides);
  require_trust(input, trusted);
  require_loads(input);
  if (processes) check_processes(input, wish.every > 0. || wish.resume);
  note_interrupts();
  std::optional<OutputFolder> folder;
  std::optional<Checkpoints> checkpoints;
  if (is_first) {
    const std::string out = options.out.empty() ? "results/" + input.stem : options.out;
    require_inputs_kept(out, run_files(), input_files(input));
    folder.emplace(out);
    checkpoints.emplace(input, folder->name(), wish);
  }
  const Simulation simulation = simulation_of(input, nullptr, processes);
  const std::vector<MeasuredRecord> records = read_records(input, simulation);
  if (is_first && !options.json) std::cout << describe(input, simulation) << checkpoints->account() << std::flush;

  FieldOutput fields(input.scene.fields_every, folder ? &*folder : nullptr);
  Run result = solve(input, simulation, records, fields, checkpoints ? &*checkpoints : nullptr, is_first);
  if (!is_first) return;
  const std::string json = write(input, records, result, fields, since_start, *folder);
  checkpoints->remove();
  const std::string written =
      folder->name() + "/{results.h5, summary.json, case.toml" + (input.scene.fields_every ? ", fields.pvd}" : "}");
  std::cerr << describe(result.summary.warnings);
  std::cout << (options.json ? json
                             : describe(result) + describe(result.summary.measured) + "written     " + written + "\n");
}

}  // namespace

void add_run(CLI::App& program) {
  auto options = std::make_shared<CommonOptions>();
  CLI::App* command = &add_solver_command(program, "run");
  add_common_options(*command, *options);
  auto wish = std::make_shared<CheckpointWish>();
  auto trusted = std::make_shared<bool>(false);
  add_trust_option(*command, *trusted);
  command
      ->add_option("--checkpoint", wish->every,
                   "keep a checkpoint in DIR.checkpoint every so many seconds of wall time; removed in the end")
      ->type_name("SECONDS")
      ->check(CLI::PositiveNumber);
  command->add_flag("--resume", wish->resume, "go on from the checkpoint, where there is one");
  command->footer(
      "Writes into results/NAME (or --out DIR), all or nothing:\n"
      "  results.h5     histories /history/{time, force, shear_force, inertia_force, caisson/..., probes/...}, SI "
      "units\n"
      "  summary.json   peaks, ratio of peak F_T to peak P, checks, what was skipped, times\n"
      "  case.toml      the case with all defaults spelled out; runs again as it is\n"
      "  fields.pvd     fields for ParaView, where the case has [output] fields\n\n"
      "A run that may take long can be killed and go on, to the last bit the same (not with contact, soil that "
      "follows\n"
      "its strain, or several processes):\n"
      "  upbead run CASE --checkpoint 600      keeps where it stands every 600 s, and where it is interrupted\n"
      "  upbead run CASE --checkpoint 600 --resume\n\n"
      "On several processes (mpirun -n 2 upbead run CASE) the mesh is divided among them; the answer is the same up "
      "to\n"
      "round-off. Fields, reduced models and an early stop are for one process alone.\n\n"
      "Examples:\n"
      "  upbead run cases/fig2b-model.toml\n"
      "  upbead run cases/fig2b-model.toml --set time.scheme=generalised_alpha --out /tmp/ga\n"
      "  upbead run cases/fig2b-prototype.toml --json | jq .response.shear_to_force_ratio");
  command->callback([options, wish, trusted, since_start = Stopwatch()] {
    const std::shared_ptr<const Processes> processes = started_processes();
    run_together(processes.get(), [&] { run(*options, *wish, *trusted, since_start, processes); });
  });
}

}  // namespace upbead
