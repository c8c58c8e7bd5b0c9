#include "cli/commands.h"
#include "cli/program.h"

namespace upbead {

void add_solver_commands(CLI::App& program) {
  add_explain(program);
  add_run(program);
  add_reduce(program);
  add_study(program);
}

}  // namespace upbead
