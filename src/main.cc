// upbead: shear force and sliding of caisson breakwaters under impulsive waves. What meshes or solves is left to
// upbead-solver, which lies beside this program.

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>

#include "cli/failure.h"
#include "cli/program.h"
#include "model/exclusions.h"
#include "upbead/base/error.h"
#include "upbead/case/case.h"

namespace {

const std::map<std::string, std::string (*)()> tables{{"--keys", upbead::case_reference},
                                                      {"--exclusions", upbead::exclusion_table}};

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

/// `explain` prints its two tables itself; other words with it, and the other commands of the solver, start that.
void add_all(CLI::App& program) {
  for (const auto& [name, what] : upbead::solver_commands) program.add_subcommand(name, what);
  CLI::App& explain = *program.get_subcommand("explain");
  for (const auto& [option, text] : tables) explain.add_flag_callback(option, [print = text] { std::cout << print(); });
  upbead::add_other_commands(program);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const bool prints_table = argc == 3 && argv[1] == std::string("explain") && tables.count(argv[2]) > 0;
    if (argc > 1 && is_solvers(argv[1]) && !prints_table) become_solver(argv);
  } catch (...) {
    return upbead::tell_failure();
  }
  return upbead::run_program(argc, argv, add_all);
}
