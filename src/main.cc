// upbead: shear force and sliding of caisson breakwaters under impulsive waves. Commands that mesh or solve are
// passed to upbead-solver, those by OpenTURNS to upbead-reliability; both lie beside this program.

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>

#include "base/cores.h"
#include "cli/command.h"
#include "cli/known_warnings.h"
#include "cli/respond_cases.h"
#include "model/exclusions.h"
#include "upbead/base/error.h"
#include "upbead/case/case.h"

namespace {

bool is_among(const std::vector<upbead::Command>& commands, const std::string& word) {
  return std::any_of(commands.begin(), commands.end(), [&word](const auto& command) { return command.name == word; });
}

/// Lets glibc place large arrays in pages of 2 MB and keep freed memory for the next array: page faults took a
/// quarter of a run's time. glibc reads these settings from the environment before a program begins (its manual:
/// Memory Allocation Tunables). Settings of the user are kept; other C libraries ignore them.
void prefer_large_pages() {
  constexpr int keep_the_users = 0;
  setenv("GLIBC_TUNABLES",
         "glibc.malloc.hugetlb=1:glibc.malloc.mmap_threshold=67108864:glibc.malloc.trim_threshold=1073741824:"
         "glibc.malloc.top_pad=16777216",
         keep_the_users);
}

/// Tells mistakes of a case before the solver starts, which takes half a second. Not where several processes read the
/// same case: there the solver tells them once; nor of a sheet, whose file may be a design.
void check_case_first(int argc, char** argv) {
  const std::string command = argv[1];
  if (command == "study" || command == "sheet" || upbead::is_launched()) return;
  upbead::check_case_of(argc, argv);
}

/// Whether `respond` is given a case, which is to be meshed.
bool respond_meshes(const std::vector<std::string>& words) {
  return !words.empty() && words[0] == "respond" && std::any_of(words.begin() + 1, words.end(), upbead::is_case);
}

/// Replaces this process by another program beside it, with the same command line.
[[noreturn]] void become(const std::string& name, const std::string& what_it_does, char** argv) {
  const std::string program = (std::filesystem::read_symlink("/proc/self/exe").parent_path() / name).string();
  execv(program.c_str(), argv);
  throw upbead::InputError({}, "cannot start '" + program + "', which " + what_it_does, "install upbead again, whole");
}

/// The table that `explain` prints without a solver; "" where the command asks for something else.
std::string table(const std::vector<std::string>& words) {
  if (words == std::vector<std::string>{"explain", "--keys"}) return upbead::case_reference();
  if (words == std::vector<std::string>{"explain", "--schema"}) return upbead::case_json_schema();
  if (words == std::vector<std::string>{"explain", "--warnings"}) return upbead::warning_reference();
  if (words == std::vector<std::string>{"explain", "--exclusions"}) return upbead::exclusion_table();
  return "";
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const std::vector<std::string> words(argv + 1, argv + argc);
    if (const std::string text = table(words); !text.empty()) {
      std::cout << text;
      return upbead::printed(0);
    }
    if (argc > 1 && is_among(upbead::sampling_commands(), argv[1]))
      become("upbead-reliability", "samples what is random", argv);
    if (respond_meshes(words)) become("upbead-solver", "meshes and solves", argv);
    if (argc > 1 && is_among(upbead::solver_commands(), argv[1])) {
      check_case_first(argc, argv);
      prefer_large_pages();
      become("upbead-solver", "meshes and solves", argv);
    }
  } catch (...) {
    return upbead::tell_failure();
  }
  return upbead::run_program(argc, argv,
                             upbead::solver_commands() + upbead::sampling_commands() + upbead::light_commands());
}
