// The commands of the program, declared as data. Only run_program() uses CLI11.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "upbead/base/numbered_warning.h"

namespace upbead {

constexpr int exit_signal = 128;  ///< and the signal, where that ended the program

/// Where the value of an option goes; a bool is a flag.
using OptionValue = std::variant<bool*, int*, double*, std::string*, std::optional<double>*, std::vector<std::string>*>;

/// An argument, or an option where the name begins with dashes; one whose value is a list may be given many times.
struct Option {
  std::string name;
  OptionValue value;
  std::string help;
  std::string type = "";  ///< name of its value in the help; "": by its type in C++
  bool required = false;
  bool positive = false;                          ///< a number above 0
  std::optional<std::pair<int, int>> range = {};  ///< from and to
  std::vector<std::string> words = {};            ///< one of these
};

/// A flag that prints a text instead of doing the command's work.
struct PrintedText {
  std::string name, help;
  std::string (*text)();
};

struct Command {
  std::string name, what;
  std::vector<Option> options = {};  ///< required ones may be missing where a text is printed
  std::vector<PrintedText> texts = {};
  std::string footer = "";
  std::function<int()> work = {};  ///< returns the exit code
};

/// Options that most commands have.
struct CommonOptions {
  std::string file;                    ///< the case
  bool json = false;                   ///< --json: the summary on stdout, nothing else
  std::string out;                     ///< --out; empty: the default
  std::vector<std::string> overrides;  ///< --set KEY=VALUE
};

/// The options FILE, --json, --out and --set. `file`: what FILE is; `out`: what goes into the folder, and its
/// default.
std::vector<Option> common_options(
    CommonOptions& options, const std::string& file = "case",
    const std::string& out = "the results (default: results/NAME, NAME as the case file's)");

/// A command line with those options, and more behind it.
std::string command_line(const std::string& name, const CommonOptions& options, const std::string& more);

/// The option --trust of commands that mesh.
Option trust_option(bool& trusted);

/// A list followed by another one.
template <class T>
std::vector<T> operator+(std::vector<T> list, const std::vector<T>& more) {
  list.insert(list.end(), more.begin(), more.end());
  return list;
}

/// Commands that mesh or solve, with their help texts but without their work, which a program of its own does, the
/// solver. So all other commands start without the solver's 200 libraries, in a fifth of the time.
std::vector<Command> solver_commands();
/// The commands that need OpenTURNS, likewise without their work: a third program has that library.
std::vector<Command> sampling_commands();
/// The one of the solver's commands with that name.
Command solver_command(const std::string& name);

/// Options of the commands that solve a case.
struct CaseOptions : CommonOptions {
  bool trusted = false;          ///< --trust
  double checkpoint_every = 0.;  ///< run: wall time between two checkpoints (s); 0: none are kept
  bool resume = false;           ///< run
  bool details = false;          ///< run: --details
  std::string petsc;             ///< run: --petsc
  bool all_readings = false;     ///< reduce
  bool check = false;            ///< reduce
  std::string soils;             ///< reduce: --soils
};

/// One of explain, run and reduce with its options and its help, but without its work.
Command case_command(const std::string& name, CaseOptions& options);

/// Throws InputError where the case on the command line of explain, run or reduce has mistakes. Words that these
/// commands do not understand pass.
void check_case_of(int argc, char** argv);

/// Says what would be solved, what is skipped and why.
Command explain_command();
Command run_command();
Command sheet_command();
Command reduce_command();
Command study_command();
Command reliability_command();
Command indices_command();

/// All commands that need neither mesh nor solver; with the `respond` of a program that has both, where it is given.
std::vector<Command> light_commands(std::optional<Command> respond = {});

/// The exit code of a program that ends with `code` and has printed all that it had to say. Throws InputError where
/// stdout has not taken all of it, as on a full disk; a reader that went away is no mistake, and is not told.
int printed(int code);

/// Reads the command line, runs the command that it names, and returns the exit code.
int run_program(int argc, char** argv, const std::vector<Command>& commands);

/// Writes the message of the exception that is being handled to stderr, and returns its exit code: 1 the input is
/// wrong, 2 the numerics failed, 3 a bug, 128 + signal interrupted. To be called in a catch block only.
int tell_failure();

/// Warnings, two lines each: "warning: NAME: cure", and what is wrong below it.
std::string describe(const NumberedWarnings& warnings);

}  // namespace upbead
