// upbead: shear force and sliding of caisson breakwaters under impulsive waves. What meshes or solves is left to
// upbead-solver, which lies beside this program.

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <iostream>

#include "upbead/base/error.h"
#include "upbead/case/case.h"
#include "upbead/cli/failure.h"
#include "upbead/cli/program.h"

namespace {

bool is_solvers(const std::string& word) {
  return std::any_of(upbead::solver_commands.begin(), upbead::solver_commands.end(),
                     [&word](const auto& command) { return command.first == word; });
}

/// Becomes the solver, with the same words.
[[noreturn]] void become_solver(char** argv) {
  const std::string solver = (std::filesystem::read_symlink("/proc/self/exe").parent_path() / "upbead-solver").string();
  execv(solver.c_str(), argv);
  throw upbead::InputError({}, "cannot start '" + solver + "', which meshes and solves", "install upbead again, whole");
}

/// Commands that other words than `explain --keys` make start the solver.
void add_all(CLI::App& program) {
  for (const auto& [name, what] : upbead::solver_commands) program.add_subcommand(name, what);
  CLI::App& explain = *program.get_subcommand("explain");
  explain.add_flag("--keys");
  explain.callback([] { std::cout << upbead::case_reference(); });
  upbead::add_other_commands(program);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const bool prints_keys = argc == 3 && argv[1] == std::string("explain") && argv[2] == std::string("--keys");
    if (argc > 1 && is_solvers(argv[1]) && !prints_keys) become_solver(argv);
  } catch (...) {
    return upbead::tell_failure();
  }
  return upbead::run_program(argc, argv, add_all);
}
