// The commands that solve a case, as far as both programs know them: upbead, and the solver that does their work.

#include <map>

#include "cli/command.h"

namespace upbead {

namespace {

const char* const explain_footer =
    R"(Reads, checks and meshes the case, solves nothing and writes nothing. Prints the mesh, how the pore water of each
region is treated and why, each load's arm above the caisson's bottom, and what is skipped.

Examples:
  upbead explain cases/fig2b-model.toml
  upbead explain cases/fig2b-model.toml --set regions.mound.hydraulic_conductivity=1e-3
  upbead explain --keys
  upbead explain --outputs)";

const char* const run_footer =
    R"(Writes into results/NAME (or --out DIR), all or nothing:
  results.h5     histories /history/{time, force, shear_force, inertia_force, caisson/..., probes/...}, SI units
  times.csv      all readings at the times of the case's [output] times
  summary.json   peaks, ratio of peak F_T to peak P, checks, what was skipped, times
  case.toml      the case with all defaults spelled out; runs again as it is
  fields.pvd     fields for ParaView, where the case has [output] fields

Prints one screen: verdict, checks, warnings, F_T/P, S and where the files are; --details prints the rest.

A long run can be stopped and resumed, with the same result to the last bit (not with contact, or soil that follows
its strain), and on another number of processes (not with soil that yields):
  upbead run CASE --checkpoint 600      writes a checkpoint every 600 s, and where it is interrupted
  upbead run CASE --checkpoint 600 --resume

On several processes (mpirun -n 2 upbead run CASE, or srun --mpi=pmix) the mesh is divided among them; the answer is
the same up to round-off, with soil that yields up to what its solves leave.

Examples:
  upbead run cases/fig2b-model.toml
  upbead run cases/fig2b-model.toml --set time.scheme=generalised_alpha --out /tmp/ga
  upbead run cases/fig2b-prototype.toml --json | jq .response.shear_to_force_ratio)";

const char* const sheet_footer =
    R"(Does all that a file allows: its waves by formulas at all levels of still water ([section], [waves.NAME],
[levels]), the run ([mesh], [regions], [loads.NAME]), the sliding of a record of seas or of a life ([sea] or
[storms], [life]), probabilities of failure ([reliability], by upbead-reliability). Prints one table: each check
with demand, capacity, factor, the factor required, and the
measure; the worst of each way to fail governs it. What the file does not ask for and what the program does not
look at stands below it. Limits are those of [limits].

Writes into results/NAME-sheet (or --out DIR), all or nothing:
  summary.json   the table, and the summaries of waves, run, expected and reliability in it
  sheet.md       the table as Markdown
  results.h5     the histories of the run; reduced.h5 the model by which the life was answered
  case.toml      the file with all defaults spelled out; gives the same sheet
  reliability/   what 'upbead reliability' writes, where the file has [reliability]

Examples:
  upbead sheet cases/designer/section.toml
  upbead sheet cases/designer/design.toml --json | jq .verdict.text)";

const char* const reduce_footer =
    R"(Writes results/NAME/reduced.h5 (or into --out DIR): the modes of the scene with their error and validity, which
'upbead respond' and postprocess/reduced_model.py apply to any wave. The model is as large as the case's
[accuracy] tolerance asks for, measured on the case's own histories.
With --soils FILE writes soils.h5: one model for all soils of a box and all waves, see docs/soils.md.

Examples:
  upbead reduce cases/fig2b-prototype.toml
  upbead reduce cases/fig2b-prototype.toml --check --set accuracy.tolerance=0.001 --out /tmp/fine
  upbead respond results/fig2b-prototype/reduced.h5 cases/fig2b-prototype-impulse.csv
  upbead reduce cases/fig2b-prototype.toml --soils box.toml   # such as docs/soils.md has
  upbead respond results/fig2b-prototype/soils.h5 cases/fig2b-prototype-impulse.csv \
      --soil regions.seabed.shear_modulus=25e6)";

std::vector<Option> run_options(CaseOptions& options) {
  return {{"--details", &options.details,
           "print all results and how the scene is solved, not the one screen that most people need"},
          {"--checkpoint", &options.checkpoint_every,
           "keep a checkpoint in DIR.checkpoint every so many seconds of wall time; removed in the end", "SECONDS",
           false, true},
          {"--resume", &options.resume, "go on from the checkpoint, where there is one"},
          {"--petsc", &options.petsc,
           "options of PETSc for the solver of what several processes share, such as \"-mat_mumps_icntl_14 400\"",
           "OPTIONS"}};
}

std::vector<Option> reduce_options(CaseOptions& options) {
  return {
      {"--all-readings", &options.all_readings,
       "make the model larger until the error of all readings, not of F_T alone, is below ten times the tolerance"},
      {"--soils", &options.soils,
       "one model for a box of soils: a file with a study's tables [vary.\"KEY\"], whose values are the ends of the "
       "box",
       "FILE"},
      {"--check", &options.check, "march the case as well and print the error against that march; takes longer"}};
}

}  // namespace

Command case_command(const std::string& name, CaseOptions& options) {
  Command command = solver_command(name);
  command.options = common_options(options) + std::vector{trust_option(options.trusted)};
  if (name == "run") command.options = command.options + run_options(options);
  if (name == "reduce") command.options = command.options + reduce_options(options);
  static const std::map<std::string, const char*> footers{
      {"explain", explain_footer}, {"run", run_footer}, {"sheet", sheet_footer}, {"reduce", reduce_footer}};
  command.footer = footers.at(name);
  return command;
}

}  // namespace upbead
