// upbead-solver: all commands of upbead, with the libraries that mesh and solve.

#include "cli/failure.h"
#include "cli/program.h"
#include "upbead/algebra/petsc_session.h"

namespace {

void add_all(CLI::App& program) {
  upbead::add_solver_commands(program);
  upbead::add_other_commands(program);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const upbead::PetscSession petsc;
    return upbead::run_program(argc, argv, add_all);
  } catch (...) {
    return upbead::tell_failure();
  }
}
