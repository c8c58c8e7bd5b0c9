#include "cli/command.h"

#include <poll.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <iostream>
#include <map>
#include <new>
#include <utility>

#include "base/interrupt.h"
#include "base/text.h"
#include "cli/respond_cases.h"
#include "output/versions.h"
#include "upbead/base/error.h"
#include "upbead/case/case.h"

namespace upbead {

namespace {

/// CLI::PositiveNumber takes what is no number, and tells a limit of 309 digits.
std::string positive_number(std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  const bool whole = end != text.c_str() && *end == '\0';
  return whole && value > 0. && std::isfinite(value) ? "" : text + " is no positive number; give one such as 20";
}

constexpr int exit_input = 1, exit_numerics = 2, exit_bug = 3;

/// Suggests a command for a misspelt one; CLI11 would say of `upbead rum` only that a command is missing.
void check_command(const std::vector<Command>& commands, const std::string& word) {
  if (word.empty() || word[0] == '-') return;
  std::vector<std::string> names;
  for (const Command& command : commands) names.push_back(command.name);
  if (std::find(names.begin(), names.end(), word) == names.end())
    throw InputError(Place(), "there is no command '" + word + "'", suggestion(word, names, "commands"));
}

/// Adds an option; `may_lack`: a required one may be missing.
void add(CLI::App& app, const Option& option, bool may_lack) {
  CLI::Option* added = std::visit(
      [&](auto* value) {
        if constexpr (std::is_same_v<decltype(value), bool*>)
          return app.add_flag(option.name, *value, option.help);
        else
          return app.add_option(option.name, *value, option.help);
      },
      option.value);
  if (!option.type.empty()) added->type_name(option.type);
  if (option.required && !may_lack) added->required();
  if (option.positive) added->check(CLI::Validator(positive_number, "POSITIVE"));
  if (option.range) added->check(CLI::Range(option.range->first, option.range->second));
  if (!option.words.empty())
    added->check(CLI::IsMember(option.words))->option_text(CLI::detail::join(option.words, "|"));
  if (std::holds_alternative<std::vector<std::string>*>(option.value) && option.name[0] == '-')
    added->take_all()->allow_extra_args(false);
}

void require_all(const Command& command) {
  for (const Option& option : command.options)
    if (option.required && std::get<std::string*>(option.value)->empty()) throw CLI::RequiredError(option.name);
}

void add(CLI::App& program, const Command& command) {
  CLI::App& app = *program.add_subcommand(command.name, command.what);
  app.footer(command.footer);
  for (const Option& option : command.options) add(app, option, !command.texts.empty());
  std::vector<CLI::Option*> flags;
  for (const PrintedText& text : command.texts) flags.push_back(app.add_flag(text.name, text.help));
  app.callback([command, flags] {
    for (std::size_t i = 0; i < flags.size(); ++i)
      if (flags[i]->count() > 0) {
        std::cout << command.texts[i].text();
        return;
      }
    if (!flags.empty()) require_all(command);
    if (const int code = command.work(); code != 0) throw CLI::RuntimeError(code);
  });
}

int run(int argc, char** argv, const std::vector<Command>& commands) {
  CLI::App program("upbead: how much of a wave's impulsive force on a caisson reaches its bottom, and does it slide?");
  program.require_subcommand(1);
  program.set_version_flag("--version", versions_text);
  program.footer(
      "Start with the example, or with your own section (upbead new mine.toml):\n"
      "  upbead explain cases/fig2b-model.toml     what will be solved, and what is skipped\n"
      "  upbead run cases/fig2b-model.toml         F_T(t) and its peak, into results/fig2b-model\n"
      "  postprocess/response.py results/fig2b-model\n\n"
      "Exit codes: 0 done, 1 the input is wrong, 2 the numerics failed, 3 a bug,\n130 and 143 interrupted.");
  for (const Command& command : commands) add(program, command);
  if (argc > 1) check_command(commands, argv[1]);
  try {
    program.parse(argc, argv);
  } catch (const CLI::RuntimeError& error) {  // thrown by a command to end with its own exit code
    return error.get_exit_code();
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? 0 : exit_input;
  }
  return 0;
}

}  // namespace

std::vector<Option> common_options(CommonOptions& options, const std::string& file, const std::string& out) {
  return {{"FILE", &options.file, "the " + file + " (TOML)", "", true},
          {"--json", &options.json, "print the summary as JSON on stdout and nothing else"},
          {"--out", &options.out, "folder for " + out, "DIR"},
          {"--set", &options.overrides,
           "use another value of one key" + std::string(file == "study" ? " of the study" : "") +
               "; may be given many times",
           "KEY=VALUE"}};
}

std::string command_line(const std::string& name, const CommonOptions& options, const std::string& more) {
  std::string text = "upbead " + name + " " + options.file;
  for (const std::string& setting : options.overrides) text += " --set '" + setting + "'";
  return text + " --out " + options.out + more;
}

Option trust_option(bool& trusted) {
  return {"--trust", &trusted,
          "mesh the case's own .geo even where nothing can keep it from starting programs and writing files"};
}

std::vector<Command> solver_commands() {
  return {{"explain", "check a case and print what would be solved, without solving"},
          {"run", "solve a case and write F_T(t), its peak and all histories"},
          {"sheet", "all checks that a file allows in one table: formulas, the run, the life"},
          {"reduce", "solve a scene once for all waves: write its reduced model"},
          {"study", "vary keys of cases, and run them side by side"}};
}

std::vector<Command> sampling_commands() {
  return {{"reliability", "probability of failure of a section in one wave whose numbers are random"},
          {"indices", "Sobol indices of a study: which key makes which share of the variance"}};
}

Command solver_command(const std::string& name) {
  const std::vector<Command> commands = solver_commands();
  return *std::find_if(commands.begin(), commands.end(), [&name](const Command& one) { return one.name == name; });
}

void check_case_of(int argc, char** argv) {
  CaseOptions options;
  Command command = case_command(argv[1], options);
  command.work = [&options] {
    check_case(options.file, options.overrides);
    return 0;
  };
  CLI::App program;
  add(program, command);
  try {
    program.parse(argc, argv);
  } catch (const CLI::Error&) {  // help, or words that are not understood: the command itself tells
  }
}

// A command has a file of its own, and a row here.
/// waves, expected and calibrate.
std::vector<Command> design_commands();
Command scale_command();
/// Reads the output of a CFD program: as it lies on disk, and as a load.
Command read_command();
/// Writes a commented case to begin with.
Command new_command();

std::vector<Command> light_commands(std::optional<Command> respond) {
  return std::vector{respond ? *respond : respond_command({})} + design_commands() +
         std::vector{scale_command(), read_command(), new_command()};
}

int printed(int code) {
  const bool sound = std::cout.good();
  errno = 0;
  std::cout.flush();
  const int reason = sound ? errno : 0;
  if (std::cout || code != 0) return code;
  pollfd output{STDOUT_FILENO, 0, 0};
  if (poll(&output, 1, 0) > 0 && (output.revents & POLLERR) != 0) return exit_signal + SIGPIPE;  // as in `| head`
  throw InputError({},
                   "not all that was printed could be written to stdout" +
                       (reason == 0 ? std::string() : std::string(": ") + std::strerror(reason)),
                   "make room there, or send it elsewhere; files that were written are whole");
}

int run_program(int argc, char** argv, const std::vector<Command>& commands) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file beyond the size limit gives an error message and does not kill the program
  try {
    return printed(run(argc, argv, commands));
  } catch (...) {
    return tell_failure();
  }
}

int tell_failure() {
  try {
    throw;
  } catch (const InputError& error) {
    std::cerr << error.what() << "\n";
    return exit_input;
  } catch (const NumericsError& error) {
    std::cerr << "upbead: the numerics failed: " << error.what() << "\n";
    return exit_numerics;
  } catch (const Interrupted& interrupted) {
    std::cerr << "upbead: interrupted, nothing was written\n";
    return exit_signal + interrupted.signal();
  } catch (const std::bad_alloc&) {
    std::cerr << "upbead: the case does not fit in memory; use a coarser mesh, larger steps or fewer fields\n";
    return exit_numerics;
  } catch (const std::exception& error) {
    std::cerr << "upbead: this is a bug, please report it: " << error.what() << "\n";
    return exit_bug;
  }
}

namespace {

/// How many of the same kind are farther from their limit, or as far and earlier.
std::ptrdiff_t worse_ones(const NumberedWarnings& warnings, const NumberedWarning& one) {
  const auto distance = [](const NumberedWarning& w) { return std::abs(w.value - w.limit); };
  return std::count_if(warnings.begin(), warnings.end(), [&](const NumberedWarning& other) {
    return other.name == one.name && other.cure == one.cure &&
           (distance(other) > distance(one) || (!(distance(other) < distance(one)) && &other < &one));
  });
}

}  // namespace

std::string describe(const NumberedWarnings& warnings) {
  constexpr int most = 6;  // of a kind, the worst ones: a design of many waves has the same for each
  const std::string head = "warning: ", indent(head.size(), ' ');
  std::map<std::pair<std::string, std::string>, int> left_out;  // by name and cure
  std::string text;
  for (const NumberedWarning& warning : warnings)
    if (worse_ones(warnings, warning) < most)
      text +=
          head + warning.name + ": " + (warning.cure.empty() ? "" : warning.cure + "\n" + indent) + warning.what + "\n";
    else
      ++left_out[{warning.name, warning.cure}];
  for (const auto& [kind, count] : left_out)
    text += head + kind.first + ": " + std::to_string(count) + " more of this kind, all in --json\n";
  return text;
}

}  // namespace upbead
