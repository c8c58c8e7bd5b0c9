// upbead: shear force and sliding of caisson breakwaters under impulsive waves.

#include <algorithm>
#include <csignal>

#include "upbead/algebra/petsc_session.h"
#include "upbead/cli/commands.h"
#include "upbead/cli/failure.h"
#include "upbead/base/error.h"
#include "upbead/base/suggest.h"
#include "upbead/output/versions.h"

namespace {

constexpr int exit_input = 1;

/// CLI11 would say of `upbead rum` only that a command is missing.
void check_command(const CLI::App& program, const std::string& word) {
  if (word.empty() || word[0] == '-') return;
  std::vector<std::string> commands;
  for (const CLI::App* command : program.get_subcommands({})) commands.push_back(command->get_name());
  if (std::find(commands.begin(), commands.end(), word) == commands.end())
    throw upbead::InputError(upbead::Place(), "there is no command '" + word + "'",
                             upbead::suggestion(word, commands, "commands"));
}

int run(int argc, char** argv) {
  CLI::App program("upbead: how much of a wave's impulsive force on a caisson reaches its bottom, and does it slide?");
  program.require_subcommand(1);
  program.set_version_flag("--version", upbead::versions_text);
  program.footer(
      "Start with the example:\n"
      "  upbead explain cases/fig2b-model.toml     what will be solved, and what is skipped\n"
      "  upbead run cases/fig2b-model.toml         F_T(t) and its peak, into results/fig2b-model\n"
      "  postprocess/response.py results/fig2b-model\n\n"
      "Exit codes: 0 done, 1 the input is wrong, 2 the numerics failed, 3 a bug,\n130 and 143 interrupted.");
  upbead::add_explain(program);
  upbead::add_run(program);
  upbead::add_reduce(program);
  upbead::add_respond(program);
  upbead::add_waves(program);
  upbead::add_expected(program);
  upbead::add_calibrate(program);
  upbead::add_scale(program);
  upbead::add_study(program);
  if (argc > 1) check_command(program, argv[1]);
  try {
    program.parse(argc, argv);
  } catch (const CLI::RuntimeError& error) {  // a command ends with an exit code of its own
    return error.get_exit_code();
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? 0 : exit_input;
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file that grows too large is an error to tell, not a death
  try {
    const upbead::PetscSession petsc;
    return run(argc, argv);
  } catch (...) {
    return upbead::tell_failure();
  }
}
