#include <chrono>
#include <functional>
#include <iostream>
#include <optional>
#include <thread>

#include "algebra/petsc_options.h"
#include "base/files.h"
#include "base/interrupt.h"
#include "base/launch.h"
#include "base/progress.h"
#include "base/stopwatch.h"
#include "case/case_findings.h"
#include "case/case_run.h"
#include "case/input_files.h"
#include "case/script_trust.h"
#include "cli/command.h"
#include "cli/march_output.h"
#include "cli/report.h"
#include "findings/histories.h"
#include "model/exclusions.h"
#include "output/cell_fields.h"
#include "output/fields.h"
#include "upbead/algebra/processes.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

/// Solves the case; `visible`: whether to show the progress.
Run solve(const Case& input, const Simulation& simulation, const std::vector<MeasuredRecord>& records,
          FieldOutput& fields, Checkpoints& checkpoints, const PetscOptionsGiven& petsc, bool visible) {
  std::optional<Progress> line;
  if (visible) line.emplace("solving");
  RunOptions options;
  options.progress = [&line, &petsc](double done) {
    check_interrupt();
    if (done > 0.) petsc.require_used();  // a step is solved, so PETSc has asked for what it knows
    if (line) line->update(done);
  };
  options.observer = [&fields](const Simulation& marched) { return fields.begin(marched); };
  options.soil = [&fields](YieldingSoil& soil) { fields.follow(soil); };
  options.checkpoints = checkpoints.begin(fields, visible);
  return solve(input, simulation, records, options);
}

const char* const cycles_file = "cycles.vtu";

/// What a storm left in the ground, by cell; "" where no fields are asked for or there was no storm.
std::string cycle_fields(const Run& run) {
  const auto& cycles = run.summary.cycles;
  if (!run.simulation->scene().fields_every || !cycles) return "";
  const CycleFields& f = *cycles->fields;
  return cell_fields_vtu(*run.simulation->mesh(), {{"effective_stress_at_rest_(Pa)", f.effective_stress},
                                                   {"cyclic_shear_(Pa)", f.shear},
                                                   {"residual_pressure_(Pa)", f.pressure},
                                                   {"largest_pressure_ratio_(1)", f.largest_ratio},
                                                   {"compaction_(1)", f.compaction},
                                                   {"drained_strain_(1)", f.drained}});
}

/// Writes all files but the fields themselves; returns the summary as JSON.
std::string write(const Case& input, const std::vector<MeasuredRecord>& records, Run& run, const FieldOutput& fields,
                  const Stopwatch& since_start, OutputFolder& folder) {
  const Stopwatch watch;
  fields.finish();
  std::vector<Dataset> all = tables(run);
  for (Dataset& table : measured_tables(records)) all.push_back(std::move(table));
  folder.write("results.h5", dataset_file(input.scene.title, all));
  if (!input.scene.output_times.empty()) folder.write("times.csv", times_csv(run));
  if (const std::string fields_of_storm = cycle_fields(run); !fields_of_storm.empty())
    folder.write(cycles_file, fields_of_storm);
  folder.write("case.toml", effective_case(input, folder.name()));
  run.summary.timing.march -= fields.seconds();
  run.summary.timing.output = watch.seconds() + fields.seconds();
  run.summary.timing.total = since_start.seconds();
  std::string json = to_json(run.summary);
  folder.write("summary.json", json);
  check_interrupt();
  std::vector<std::string> replaced{"times.csv", "sheet.md", cycles_file};  // older ones would belong to another run
  replaced.insert(replaced.end(), field_files.begin(), field_files.end());
  folder.commit(replaced);
  return json;
}

/// Patterns of the files that a run may write.
std::vector<std::string> run_files() {
  std::vector<std::string> files{"results.h5", "times.csv", cycles_file, "summary.json", "case.toml"};
  files.insert(files.end(), field_files.begin(), field_files.end());
  return files;
}

/// Throws InputError at the keys of a case that cannot be solved on several processes.
void check_processes(const Case& input, const CaseOptions& options) {
  if ((options.checkpoint_every > 0. || options.resume) && yields(input.scene))
    throw InputError({}, "soil that yields keeps no checkpoints on several processes",
                     "leave out --checkpoint and --resume, or run upbead alone, without mpirun");
  Diagnostics mistakes;
  for (const Exclusion& reason : excluded(input.scene, Treatment::several_processes))
    mistakes.add(input.place(reason.key), reason.why + " on several processes",
                 "remove it, or run upbead alone, without mpirun");
  mistakes.throw_if_any();
}

/// Throws InputError at words that are no options of PETSc, or where there is nothing that they hold for.
PetscOptionsGiven given_to_petsc(const CaseOptions& options, const Processes* processes) {
  if (options.petsc.empty()) return {};
  if (processes == nullptr)
    throw InputError({}, "--petsc is for several processes: one alone solves without PETSc",
                     "leave it out, or start upbead by mpirun");
  return PetscOptionsGiven(options.petsc);
}

/// What is to be said where a launcher has started several processes, but MPI knows this one alone.
std::string note_on_launch(const Processes* processes) {
  const std::optional<Launch> launch = processes == nullptr ? told_launch() : std::nullopt;
  if (!launch || launch->size == 1) return "";
  return "upbead: " + launch->by + " tells that " + std::to_string(launch->size) +
         " processes were started, but MPI connects none of them: each solves the whole case for itself; to divide " +
         "it, start them by mpirun or srun --mpi=pmix\n";
}

/// Calls work(). Where it fails on one process, reports the error once and ends all processes, as the other ones
/// would wait for the failed one for ever. Without several processes (null), exceptions pass.
void run_together(const Processes* processes, const std::function<void()>& work) {
  if (processes == nullptr) return work();
  const auto leave_it_to_the_first = [processes](int seconds) {
    if (processes->rank() > 0) std::this_thread::sleep_for(std::chrono::seconds(seconds));
  };
  try {
    work();
  } catch (const InputError&) {  // all processes read the same input, so all throw the same
    leave_it_to_the_first(60);
    processes->end_all(tell_failure());
  } catch (...) {  // mostly all processes fail in the same way
    leave_it_to_the_first(2);
    processes->end_all(tell_failure());
  }
}

/// All processes do the same, except that they divide the system among them; only the first prints and writes.
void run(const CaseOptions& options, const Stopwatch& since_start, const std::shared_ptr<const Processes>& processes) {
  const bool is_first = !processes || processes->rank() == 0;
  Case input = read_case(options.file, options.overrides);
  require_trust(input, options.trusted);
  require_loads(input);
  if (is_first) std::cerr << notes_on(input) << note_on_launch(processes.get());
  if (processes) check_processes(input, options);
  const PetscOptionsGiven petsc = given_to_petsc(options, processes.get());
  note_interrupts();
  std::optional<OutputFolder> folder;
  const std::string out = options.out.empty() ? "results/" + input.stem : options.out;
  if (is_first) {
    require_inputs_kept(out, run_files(), input_files(input));
    folder.emplace(out);
  }
  std::shared_ptr<const Mesh> mesh = settle_end(input);
  Checkpoints checkpoints(input, out, CheckpointWish{options.checkpoint_every, options.resume});
  const Simulation simulation = simulation_of(input, std::move(mesh), processes);
  checkpoints.require_fit(input, simulation);
  const std::vector<MeasuredRecord> records = read_records(input, simulation);
  if (is_first && !options.json)
    std::cout << (options.details ? details(input, simulation, records) : brief(input, simulation))
              << checkpoints.account() << std::flush;

  FieldOutput fields(input.scene, folder ? &*folder : nullptr);
  Run result = solve(input, simulation, records, fields, checkpoints, petsc, is_first);
  if (!is_first) return;
  const std::string json = write(input, records, result, fields, since_start, *folder);
  checkpoints.remove();
  const std::string written = folder->name() + "/{results.h5, " +
                              (input.scene.output_times.empty() ? "" : "times.csv, ") + "summary.json, case.toml" +
                              (input.scene.fields_every && result.summary.cycles ? ", cycles.vtu" : "") +
                              (input.scene.fields_every ? ", fields.pvd}" : "}");
  std::cerr << describe(result.summary.warnings);
  std::cout << (options.json ? json
                             : (options.details ? details(result.summary) : brief(result.summary)) +
                                   text_of(result.summary.measured) + "written     " + written + "\n");
}

}  // namespace

Command run_command() {
  const auto options = std::make_shared<CaseOptions>();
  Command command = case_command("run", *options);
  command.work = [options, since_start = Stopwatch()] {
    const std::shared_ptr<const Processes> processes = started_processes();
    run_together(processes.get(), [&] { run(*options, since_start, processes); });
    return 0;
  };
  return command;
}

}  // namespace upbead
