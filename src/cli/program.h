// The command line as a whole, of the program and of its solver.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <utility>
#include <vector>

namespace upbead {

/// Commands that mesh or solve, and what they do: the solver, a program of its own, has them. All others start without
/// its 200 libraries, in a fifth of the time.
inline const std::vector<std::pair<std::string, std::string>> solver_commands{
    {"explain", "check a case and tell what would be solved, without solving"},
    {"run", "solve a case and write F_T(t), its peak and all histories"},
    {"reduce", "solve a scene once for all waves: write its reduced model"},
    {"study", "vary keys of cases, and run them side by side"}};

/// A command that meshes or solves, with its line of solver_commands.
CLI::App& add_solver_command(CLI::App& program, const std::string& name);

/// Adds explain, run, reduce and study.
void add_solver_commands(CLI::App& program);

/// Adds what needs neither mesh nor solver.
void add_other_commands(CLI::App& program);

/// Reads the command line, runs the command that it names, and returns the exit code. `add_commands` adds them all.
int run_program(int argc, char** argv, void (*add_commands)(CLI::App&));

}  // namespace upbead
