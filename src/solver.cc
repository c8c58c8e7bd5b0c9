// upbead-solver: all commands of upbead, with the libraries that mesh and solve.

#include "cli/command.h"
#include "upbead/algebra/petsc_session.h"

int main(int argc, char** argv) {
  try {
    const upbead::PetscSession petsc;
    const std::vector<upbead::Command> solving{upbead::explain_command(), upbead::run_command(),
                                               upbead::reduce_command(), upbead::study_command()};
    return upbead::run_program(argc, argv, solving + upbead::light_commands());
  } catch (...) {
    return upbead::tell_failure();
  }
}
