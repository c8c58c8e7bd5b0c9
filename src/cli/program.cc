#include "cli/program.h"

#include <algorithm>
#include <csignal>

#include "base/text.h"
#include "cli/failure.h"
#include "output/versions.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

constexpr int exit_input = 1;

/// CLI11 would say of `upbead rum` only that a command is missing.
void check_command(const CLI::App& program, const std::string& word) {
  if (word.empty() || word[0] == '-') return;
  std::vector<std::string> commands;
  for (const CLI::App* command : program.get_subcommands({})) commands.push_back(command->get_name());
  if (std::find(commands.begin(), commands.end(), word) == commands.end())
    throw InputError(Place(), "there is no command '" + word + "'", suggestion(word, commands, "commands"));
}

int run(int argc, char** argv, void (*add_commands)(CLI::App&)) {
  CLI::App program("upbead: how much of a wave's impulsive force on a caisson reaches its bottom, and does it slide?");
  program.require_subcommand(1);
  program.set_version_flag("--version", versions_text);
  program.footer(
      "Start with the example:\n"
      "  upbead explain cases/fig2b-model.toml     what will be solved, and what is skipped\n"
      "  upbead run cases/fig2b-model.toml         F_T(t) and its peak, into results/fig2b-model\n"
      "  postprocess/response.py results/fig2b-model\n\n"
      "Exit codes: 0 done, 1 the input is wrong, 2 the numerics failed, 3 a bug,\n130 and 143 interrupted.");
  add_commands(program);
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

CLI::App& add_solver_command(CLI::App& program, const std::string& name) {
  const auto found = std::find_if(solver_commands.begin(), solver_commands.end(),
                                  [&name](const auto& command) { return command.first == name; });
  return *program.add_subcommand(name, found->second);
}

int run_program(int argc, char** argv, void (*add_commands)(CLI::App&)) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file that grows too large is an error to tell, not a death
  try {
    return run(argc, argv, add_commands);
  } catch (...) {
    return tell_failure();
  }
}

}  // namespace upbead
