// Random scenes whose mesh is made for a tolerance, and whether the error estimates bound the true errors.

#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "accuracy_scene.h"
#include "accuracy_truth.h"
#include "upbead/algebra/petsc_session.h"

namespace upbead::test {
namespace {

struct Options {
  int count = 20, first = 0;
  unsigned longest = 600;  // s
  std::uint64_t seed = 1;
  double part = 1.;
  int print = -1;
  std::string out = "accuracy.csv", section = UPBEAD_SECTION_GEO;
};

void write_head(std::ostream& table, const RandomCase& drawn) {
  table << "seed,scene";
  for (const auto& fact : drawn.facts)
    if (fact.first != "contrast") table << ',' << fact.first;
  table << ",refused,scheme,unknowns,truth_unknowns,truth_peak,truth_history,peak_told_with_sides";
  for (const char* name : {"peak", "history", "slip", "coupled", "contact_slip"})
    table << ',' << name << ',' << name << "_told," << name << "_error";
  table << ",seconds,truth_seconds\n";
}

void write_number(std::ostream& table, const JudgedNumber& n) {
  table << ',' << n.value << ',';
  if (n.is_told) table << n.told;
  table << ',' << n.error;
}

void write_row(std::ostream& table, const Options& options, int scene, const RandomCase& drawn,
               const AccuracyVerdict& v) {
  table << options.seed << ',' << scene;
  for (const auto& fact : drawn.facts)
    if (fact.first != "contrast") table << ',' << fact.second;
  table << ",\"" << v.refused << "\"," << v.scheme << ',' << v.unknowns << ',' << v.truth_unknowns << ','
        << v.truth_peak << ',' << v.truth_history << ',' << v.peak_with_sides;
  for (const JudgedNumber* n : {&v.peak, &v.history, &v.slip, &v.coupled, &v.contact}) write_number(table, *n);
  table << ',' << v.seconds << ',' << v.truth_seconds << std::endl;  // flushed: a crash must leave the rows before it
}

/// Judges a scene in a separate process, which is ended after the longest time; false in that case.
bool judge_in_time(std::ostream& table, const Options& options, int scene, const RandomCase& drawn,
                   const std::string& path) {
  table.flush();
  const pid_t child = fork();
  if (child == 0) {
    alarm(options.longest);
    const upbead::PetscSession petsc;
    write_row(table, options, scene, drawn, judge_accuracy(path));
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

void run(const Options& options) {
  const std::string path =
      (std::filesystem::temp_directory_path() / ("accuracy-" + std::to_string(getpid()) + ".toml")).string();
  std::ofstream table(options.out);
  table.precision(4);
  AccuracyVerdict unfinished;
  unfinished.refused = "not done after " + std::to_string(options.longest) + " s";
  for (int scene = options.first; scene < options.first + options.count; ++scene) {
    const RandomCase drawn =
        accuracy_scene(options.seed, static_cast<std::uint64_t>(scene), options.section, options.part);
    std::ofstream(path) << drawn.toml;
    if (scene == options.first) write_head(table, drawn);
    if (!judge_in_time(table, options, scene, drawn, path)) write_row(table, options, scene, drawn, unfinished);
  }
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace upbead::test

int main(int argc, char** argv) {
  upbead::test::Options options;
  CLI::App program("Random scenes with mesh.refine = \"auto\", held against far finer meshes: a row of a table each.");
  program.add_option("--count", options.count, "how many scenes")->capture_default_str();
  program.add_option("--first", options.first, "number of the first one")->capture_default_str();
  program.add_option("--seed", options.seed, "stream of numbers; 1 to 9 are for calibration")->capture_default_str();
  program.add_option("--part", options.part, "factor of all tolerances")->capture_default_str();
  program.add_option("--longest", options.longest, "seconds after which a scene is given up")->capture_default_str();
  program.add_option("--out", options.out, "the table")->capture_default_str();
  program.add_option("--print", options.print, "print the case file of the scene with that number, and do no more");
  program.add_option("--section", options.section, "section.geo as the cases name it")->capture_default_str();
  program.footer(
      "Example:\n  accuracy_map --count 200 --seed 20 --out accuracy.csv\n"
      "  /usr/bin/python3 postprocess/accuracy.py accuracy.csv docs");
  CLI11_PARSE(program, argc, argv);
  if (options.print >= 0) {
    const auto number = static_cast<std::uint64_t>(options.print);
    std::cout << upbead::test::accuracy_scene(options.seed, number, options.section, options.part).toml;
    return 0;
  }
  upbead::test::run(options);
  return 0;
}
