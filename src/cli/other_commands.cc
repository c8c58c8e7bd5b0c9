#include "cli/commands.h"
#include "cli/program.h"

namespace upbead {

void add_other_commands(CLI::App& program) {
  add_respond(program);
  add_waves(program);
  add_expected(program);
  add_calibrate(program);
  add_scale(program);
}

}  // namespace upbead
