#include <functional>
#include <iostream>
#include <optional>

#include "checkpoints.h"
#include "input_files.h"
#include "records/measured.h"
#include "result_tables.h"
#include "script_trust.h"
#include "several_processes.h"
#include "upbead/app/commands.h"
#include "upbead/app/report.h"
#include "upbead/base/files.h"
#include "upbead/base/interrupt.h"
#include "upbead/base/progress.h"
#include "upbead/base/stopwatch.h"
#include "upbead/output/fields.h"

namespace upbead {

namespace {

/// Follows the march: a line of progress for people, fields, an end where a person wants one.
MarchOptions options_of(const Scene& scene, const std::function<void(double)>& progress, FieldOutput& fields) {
  MarchOptions options;
  options.stop_at_energy = scene.time.stop_at_energy.value_or(0.);
  options.observer = [&progress, &fields](const State& state, int step, int n) {
    progress(n > 0 ? static_cast<double>(step) / n : 1.);
    fields.write(state);
  };
  return options;
}

/// `visible`: whether people see how far it is.
Run solve(const Case& input, CompiledCase& scene, FieldOutput& fields, Checkpoints* checkpoints, bool visible) {
  std::optional<Progress> line;
  if (visible) line.emplace("solving");
  const std::function<void(double)> progress = [&line](double done) {
    check_interrupt();
    if (line) line->update(done);
  };
  MarchOptions options = options_of(input.scene, progress, fields);
  if (checkpoints) options.checkpoints = checkpoints->begin(fields);
  return run_case(input, scene, options, progress);
}

/// Writes all files but the fields themselves; returns the summary as JSON.
std::string write(const Case& input, const CompiledCase& scene, const std::vector<MeasuredRecord>& measured, Run& run,
                  const FieldOutput& fields, const Stopwatch& since_start, OutputFolder& folder) {
  const Stopwatch watch;
  fields.finish();
  const std::vector<History> computed = histories(scene, run.response.ends);
  run.summary.measured = compare_measured(input, measured, computed);
  for (const MeasuredRecord& record : measured) {
    for (const LeftOut& part : record.notes.left_out) run.summary.skipped.push_back({part.what, part.why});
    for (const NumberedWarning& warning : record.notes.warnings) run.summary.warnings.push_back(warning);
  }
  std::vector<History> others = tables(scene, run);
  for (History& table : measured_tables(measured)) others.push_back(std::move(table));
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
  CompiledCase scene = compile_case(input, nullptr, processes);
  std::vector<MeasuredRecord> measured;
  if (!input.measured.empty()) measured = read_measured(input, names_of_histories(scene));
  if (is_first && !options.json) std::cout << describe(input, scene) << checkpoints->account() << std::flush;

  FieldOutput fields(input.scene, scene, folder ? &*folder : nullptr);
  Run result = solve(input, scene, fields, checkpoints ? &*checkpoints : nullptr, is_first);
  if (!is_first) return;
  const std::string json = write(input, scene, measured, result, fields, since_start, *folder);
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
  CLI::App* command = program.add_subcommand("run", "solve a case and write F_T(t), its peak and all histories");
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
