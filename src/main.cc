// upbead: shear force and sliding of caisson breakwaters under impulsive waves.

#include <csignal>
#include <exception>
#include <iostream>

#include "upbead/algebra/petsc_session.h"
#include "upbead/app/commands.h"
#include "upbead/base/error.h"
#include "upbead/base/version.h"

namespace {

constexpr int exit_input = 1, exit_numerics = 2, exit_bug = 3;

int run(int argc, char** argv) {
  CLI::App program("upbead: how much of a wave's impulsive force on a caisson reaches its bottom, and does it slide?");
  program.require_subcommand(1);
  program.set_version_flag("--version", upbead::program_version());
  program.footer(
      "Start with the example:\n"
      "  upbead explain cases/fig2b-model.toml     what will be solved, and what is skipped\n"
      "  upbead run cases/fig2b-model.toml         F_T(t) and its peak, into results/fig2b-model\n"
      "  postprocess/response.py results/fig2b-model\n\n"
      "Exit codes: 0 done, 1 the input is wrong, 2 the numerics failed, 3 a bug.");
  upbead::add_explain(program);
  upbead::add_run(program);
  try {
    program.parse(argc, argv);
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
  } catch (const upbead::InputError& error) {
    std::cerr << error.what() << "\n";
    return exit_input;
  } catch (const upbead::NumericsError& error) {
    std::cerr << "upbead: the numerics failed: " << error.what() << "\n";
    return exit_numerics;
  } catch (const std::exception& error) {
    std::cerr << "upbead: this is a bug, please report it: " << error.what() << "\n";
    return exit_bug;
  }
}
