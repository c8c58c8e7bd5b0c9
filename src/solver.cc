// upbead-solver: all commands of upbead, with the libraries that mesh and solve.

#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <string>

#include "base/cores.h"
#include "cli/command.h"
#include "cli/respond_cases.h"
#include "upbead/algebra/petsc_session.h"

namespace {

/// Ends the process at once: all files are whole, and the destructors of 200 libraries, which take 0.12 s, change
/// nothing. Sanitizers look for leaks at an ordinary end.
[[noreturn]] void leave(int code) {
  std::cout.flush();
  std::fflush(nullptr);
#ifdef UPBEAD_SANITIZE
  std::exit(code);
#else
  std::_Exit(code);
#endif
}

}  // namespace

int main(int argc, char** argv) {
  int code = 0;
  try {
    // each part of a study is alone, whoever has started it: it makes one once it has left the launcher
    std::optional<upbead::PetscSession> petsc;
    if (argc < 2 || std::string(argv[1]) != "study") petsc.emplace();
    const std::vector<upbead::Command> solving{upbead::explain_command(), upbead::run_command(),
                                               upbead::sheet_command(), upbead::reduce_command(),
                                               upbead::study_command()};
    code = upbead::run_program(argc, argv, solving + upbead::light_commands(upbead::respond_cases_command()));
    if (!upbead::is_launched()) leave(code);  // else MPI is to be left in order
  } catch (...) {
    code = upbead::tell_failure();
  }
  leave(code);
}
