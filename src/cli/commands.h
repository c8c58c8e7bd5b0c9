// The commands of the program. Each adds itself to the command line with its help, and runs.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace upbead {

/// Options that every command has.
struct CommonOptions {
  std::string file;                    ///< the case
  bool json = false;                   ///< --json: the summary on stdout, nothing else
  std::string out;                     ///< --out; empty: results/STEM
  std::vector<std::string> overrides;  ///< --set KEY=VALUE
};

/// Adds FILE, --json, --out and --set to a command.
void add_common_options(CLI::App& command, CommonOptions& options);

/// `upbead explain CASE`: what would be solved, what is skipped and why.
void add_explain(CLI::App& program);
/// `upbead run CASE`: march the scene, write results.
void add_run(CLI::App& program);
/// `upbead respond MODEL FORCES...`: answer waves with a reduced model.
void add_reduce(CLI::App& program);

void add_respond(CLI::App& program);

/// `upbead waves DESIGN`: pressure, safety and sliding of given waves, by formulas.
void add_waves(CLI::App& program);

/// `upbead expected DESIGN`: expected sliding distance of sea states, and of lives.
void add_expected(CLI::App& program);

/// `upbead calibrate DESIGN`: k(alpha*) of tau_0 = k tau_0F from the caisson's own dynamics.
void add_calibrate(CLI::App& program);

/// `upbead scale CASE`: the similar case at another size.
void add_scale(CLI::App& program);

/// `upbead study STUDY`: keys of cases varied, run side by side.
void add_study(CLI::App& program);

}  // namespace upbead
