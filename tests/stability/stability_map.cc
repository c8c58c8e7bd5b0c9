// Random scenes over the whole range of physics, and whether each can be trusted.

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>

#include "judge.h"
#include "random_case.h"
#include "upbead/algebra/petsc_session.h"
#include "upbead/base/stopwatch.h"

namespace upbead::test {
namespace {

constexpr unsigned longest_scene = 120;  ///< s; then it counts as a hang

struct Options {
  int count = 200, first = 0;
  std::uint64_t seed = 1;
  int print = -1;
  std::string out, file, section = UPBEAD_SECTION_GEO;
};

const char* word(Verdict::Kind kind) {
  switch (kind) {
    case Verdict::Kind::passed:
      return "passed";
    case Verdict::Kind::refused:
      return "refused";
    default:
      return "failed";
  }
}

std::string quoted(std::string text) {
  for (std::size_t i = 0; (i = text.find('"', i)) != std::string::npos; i += 2) text.insert(i, 1, '"');
  std::replace(text.begin(), text.end(), '\n', ' ');
  return '"' + text + '"';
}

/// The table: a row for each scene.
class Table {
 public:
  explicit Table(const std::string& path) : file_(path) { file_.precision(4); }

  void add(int scene, const RandomCase& drawn, const Verdict& verdict, double seconds) {
    if (!started_) head(drawn);
    started_ = true;
    const Measures& m = verdict.measures;
    file_ << scene << ',' << word(verdict.kind) << ',' << quoted(verdict.why);
    for (const auto& fact : drawn.facts) file_ << ',' << fact.second;
    file_ << ',' << m.scheme << ',' << m.unknowns << ',' << m.steps << ',' << m.finite << ',' << m.energy << ','
          << m.noise << ',' << m.loads_end << ',' << m.growth << ',' << m.kept << ',' << m.reaction << ','
          << m.negative - m.expected << ',' << m.residual << ',' << m.plain_residual << ',' << m.halving.reading << ','
          << m.halving.difference.size() << ",\"";
    for (const double d : m.halving.difference) file_ << d << ' ';
    file_ << "\",\"";
    for (const double d : m.halving.largest) file_ << d << ' ';
    file_ << "\"," << seconds << std::endl;  // flushed: a crash must leave the rows before it
  }

 private:
  void head(const RandomCase& drawn) {
    file_ << "scene,verdict,why";
    for (const auto& fact : drawn.facts) file_ << ',' << fact.first;
    file_ << ",solved_by,unknowns,steps,finite,energy,noise,loads_end,growth,kept,reaction,inertia,"
             "residual,plain_residual,reading,halvings,differences,largest,seconds\n";
  }

  std::ofstream file_;
  bool started_ = false;
};

void hang(int) {
  constexpr char text[] = "stability_map: a scene hangs; its number is one more than that of the table's last row\n";
  if (write(STDERR_FILENO, text, sizeof text - 1) < 0) _exit(4);
  _exit(3);
}

Verdict judge_drawn(const RandomCase& drawn, const std::string& path) {
  std::ofstream(path) << drawn.toml;
  try {
    alarm(longest_scene);
    Verdict verdict = judge(path);
    alarm(0);
    return verdict;
  } catch (const std::exception& error) {
    return {Verdict::Kind::failed, std::string("exception: ") + error.what(), {}};
  }
}

int judge_file(const std::string& path) {
  const Verdict verdict = judge(path);
  std::cout << word(verdict.kind) << (verdict.why.empty() ? "" : ": ") << verdict.why << "\n";
  return verdict.kind == Verdict::Kind::failed;
}

/// True where no scene failed.
bool run(const Options& options) {
  const std::filesystem::path folder =
      options.out.empty() ? std::filesystem::temp_directory_path() / ("stability-" + std::to_string(getpid()))
                          : std::filesystem::path(options.out);
  std::filesystem::create_directories(folder);
  const std::string path = (folder / "scene.toml").string();
  Table table((folder / "scenes.csv").string());
  std::map<std::string, int> verdicts;
  const Stopwatch all;
  for (int scene = options.first; scene < options.first + options.count; ++scene) {
    const RandomCase drawn = random_case(options.seed, static_cast<std::uint64_t>(scene), options.section);
    const Stopwatch watch;
    const Verdict verdict = judge_drawn(drawn, path);
    table.add(scene, drawn, verdict, watch.seconds());
    ++verdicts[word(verdict.kind)];
    if (verdict.kind == Verdict::Kind::failed) {
      std::cout << "scene " << scene << " of seed " << options.seed << " fails: " << verdict.why << std::endl;
      if (!options.out.empty()) std::ofstream(folder / ("scene-" + std::to_string(scene) + ".toml")) << drawn.toml;
    }
  }
  for (const auto& [kind, n] : verdicts) std::cout << n << " scenes " << kind << "\n";
  std::cout << all.seconds() << " s\n";
  if (options.out.empty()) std::filesystem::remove_all(folder);
  return verdicts.count("failed") == 0;
}

}  // namespace
}  // namespace upbead::test

int main(int argc, char** argv) {
  upbead::test::Options options;
  CLI::App program(
      "Random scenes over the whole range of physics: each must be refused with a reason, or its numbers must hold "
      "what "
      "docs/reliability.md says. Exit code 1 where one does not.");
  program.add_option("--count", options.count, "how many scenes")->capture_default_str();
  program.add_option("--first", options.first, "number of the first one")->capture_default_str();
  program.add_option("--seed", options.seed, "stream of numbers")->capture_default_str();
  program.add_option("--out", options.out, "folder for scenes.csv and the case files of scenes that fail");
  program.add_option("--print", options.print, "print the case file of the scene with that number, and do no more");
  program.add_option("--case", options.file, "judge this case file, and do no more");
  program.add_option("--section", options.section, "section.geo as the cases name it")->capture_default_str();
  program.footer(
      "Examples:\n"
      "  stability_map --count 5000 --seed 1 --out map          the map; some minutes\n"
      "  stability_map --count 100000 --seed 2 --out nightly    a night's run\n"
      "  stability_map --seed 1 --print 17 --section ../section.geo > scenes/NAME.toml");
  CLI11_PARSE(program, argc, argv);
  if (options.print >= 0) {
    std::cout
        << upbead::test::random_case(options.seed, static_cast<std::uint64_t>(options.print), options.section).toml;
    return 0;
  }
  const upbead::PetscSession petsc;
  std::signal(SIGALRM, upbead::test::hang);
  if (!options.file.empty()) return upbead::test::judge_file(options.file);
  return upbead::test::run(options) ? 0 : 1;
}
