// Random scenes over the whole range of physics, and whether each can be trusted.

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <regex>

#include "base/stopwatch.h"
#include "both_ways.h"
#include "judge.h"
#include "random_case.h"
#include "upbead/algebra/petsc_session.h"

namespace upbead::test {
namespace {

constexpr unsigned longest_scene = 120;  ///< s; then it counts as a hang

struct Options {
  int count = 200, first = 0;
  std::uint64_t seed = 1;
  int print = -1;
  bool both = false;
  double finer = 1.;
  std::string out, file, section = UPBEAD_SECTION_GEO;
};

const char* word(Verdict::Kind kind) {
  switch (kind) {
    case Verdict::Kind::passed:
      return "passed";
    case Verdict::Kind::contradictory:
      return "contradictory";
    case Verdict::Kind::refused:
      return "refused";
    default:
      return "failed";
  }
}

/// The folder, made if need be.
std::string prepared(const std::string& folder) {
  std::filesystem::create_directories(folder);
  return folder;
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

/// A scene that is not finished after longest_scene ends the program.
template <typename Result, typename Judge>
Result in_time(const RandomCase& drawn, const std::string& path, const Judge& judge_path) {
  std::ofstream(path) << drawn.toml;
  Result result;
  try {
    alarm(longest_scene);
    result = judge_path(path);
    alarm(0);
  } catch (const std::exception& error) {
    result = {};
    result.kind = Verdict::Kind::failed;
    result.why = std::string("exception: ") + error.what();
  }
  return result;
}

/// Counts how scenes ended, and the reasons of refusals, in which numbers and names are removed so that equal reasons
/// can be counted.
class Count {
 public:
  void add(const Verdict::Kind kind, const std::string& why) {
    ++verdicts_[word(kind)];
    if (kind != Verdict::Kind::passed) ++reasons_[word(kind) + std::string(": ") + class_of(why)];
  }

  bool none_failed() const { return verdicts_.count("failed") == 0; }

  void tell() const {
    int all = 0;
    for (const auto& [kind, n] : verdicts_) all += n;
    for (const auto& [kind, n] : verdicts_) std::cout << n << " scenes " << kind << "\n";
    const int possible = all - of("contradictory");
    if (possible > 0)
      std::cout << "of the " << possible << " that do not contradict themselves " << 100. * of("refused") / possible
                << " % are refused\n";
    std::vector<std::pair<int, std::string>> list;
    for (const auto& [reason, n] : reasons_) list.emplace_back(-n, reason);
    std::sort(list.begin(), list.end());
    for (const auto& [n, reason] : list) std::cout << "  " << -n << "  " << reason << "\n";
  }

 private:
  static std::string class_of(const std::string& why) {
    std::string text = std::regex_replace(why.substr(0, why.find(';')), std::regex("'[^']*'"), "'...'");
    text = std::regex_replace(text, std::regex("\\([^)]*\\)"), "(...)");
    text = std::regex_replace(text, std::regex("-?[0-9][0-9.e+-]*"), "#");
    return std::regex_replace(text, std::regex("\n"), " ").substr(0, 160);
  }
  int of(const std::string& kind) const {
    const auto found = verdicts_.find(kind);
    return found == verdicts_.end() ? 0 : found->second;
  }

  std::map<std::string, int> verdicts_, reasons_;
};

int judge_file(const std::string& path) {
  const Verdict verdict = judge(path);
  std::cout << word(verdict.kind) << (verdict.why.empty() ? "" : ": ") << verdict.why << "\n";
  return verdict.kind == Verdict::Kind::failed;
}

/// Calls `judge_scene(number, drawn, path)` for each scene; true where none failed.
template <typename JudgeScene>
bool sweep(const Options& options, const JudgeScene& judge_scene) {
  const std::filesystem::path folder =
      options.out.empty() ? std::filesystem::temp_directory_path() / ("stability-" + std::to_string(getpid()))
                          : std::filesystem::path(options.out);
  std::filesystem::create_directories(folder);
  Count count;
  const Stopwatch all;
  for (int scene = options.first; scene < options.first + options.count; ++scene) {
    const RandomCase drawn = random_case(options.seed, static_cast<std::uint64_t>(scene), options.section);
    const auto [kind, why] = judge_scene(scene, drawn, (folder / "scene.toml").string());
    count.add(kind, why);
    if (kind != Verdict::Kind::failed) continue;
    std::cout << "scene " << scene << " of seed " << options.seed << " fails: " << why << std::endl;
    if (!options.out.empty()) std::ofstream(folder / ("scene-" + std::to_string(scene) + ".toml")) << drawn.toml;
  }
  count.tell();
  std::cout << all.seconds() << " s\n";
  if (options.out.empty()) std::filesystem::remove_all(folder);
  return count.none_failed();
}

using Ending = std::pair<Verdict::Kind, std::string>;

bool run(const Options& options) {
  Table table(options.out.empty() ? "/dev/null" : prepared(options.out) + "/scenes.csv");
  return sweep(options, [&](int scene, const RandomCase& drawn, const std::string& path) {
    const Stopwatch watch;
    const auto verdict = in_time<Verdict>(drawn, path, judge);
    table.add(scene, drawn, verdict, watch.seconds());
    return Ending(verdict.kind, verdict.why);
  });
}

/// Each scene that sdirk4 solves, "auto" must solve.
bool run_both(const Options& options) {
  std::map<std::string, int> ways;
  std::vector<double> differences;
  int sdirk4_refused = 0;
  std::ofstream file(options.out.empty() ? "/dev/null" : prepared(options.out) + "/both.csv");
  file << "scene,verdict,way,tried,difference,sdirk4,why\n";
  const bool held = sweep(options, [&](int scene, const RandomCase& drawn, const std::string& path) {
    const auto both = in_time<BothWays>(
        drawn, path, [&](const std::string& scene_path) { return solve_both_ways(scene_path, options.finer); });
    file << scene << ',' << word(both.kind) << ',' << quoted(both.way) << ',' << both.steps_of_ladder << ','
         << both.difference << ',' << quoted(both.sdirk4) << ',' << quoted(both.why) << std::endl;
    if (both.kind == Verdict::Kind::passed) ++ways[both.way];
    if (both.kind == Verdict::Kind::passed && !both.sdirk4.empty()) ++sdirk4_refused;
    if (both.difference >= 0.) differences.push_back(both.difference);
    return Ending(both.kind, both.why);
  });
  for (const auto& [way, n] : ways) std::cout << n << " scenes answered by " << way << "\n";
  std::cout << sdirk4_refused << " of these sdirk4 alone does not answer\n";
  std::sort(differences.begin(), differences.end());
  if (!differences.empty())
    std::cout << "peaks of F_T differ by " << differences[differences.size() / 2] << " in the median, "
              << differences[differences.size() * 99 / 100] << " in 99 % of " << differences.size() << " scenes\n";
  return held;
}

}  // namespace
}  // namespace upbead::test

int main(int argc, char** argv) {
  upbead::test::Options options;
  CLI::App program(
      "Random scenes over the whole range of physics: each must be refused with a reason, or its numbers must hold "
      "what "
      "docs/reference/reliability.md says. Exit code 1 where one does not.");
  program.add_option("--count", options.count, "how many scenes")->capture_default_str();
  program.add_option("--first", options.first, "number of the first one")->capture_default_str();
  program.add_option("--seed", options.seed, "stream of numbers")->capture_default_str();
  program.add_option("--out", options.out, "folder for scenes.csv and the case files of scenes that fail");
  program.add_option("--print", options.print, "print the case file of the scene with that number, and do no more");
  program.add_flag("--both", options.both,
                   "solve each scene by sdirk4 and by auto instead; fails where only sdirk4 answers");
  program
      .add_option("--finer", options.finer, "with --both: divide steps by so much; then auto prefers reduced models")
      ->capture_default_str();
  program.add_option("--case", options.file, "judge this case file, and do no more");
  program.add_option("--section", options.section, "section.geo as the cases name it")->capture_default_str();
  program.footer(
      "Examples:\n"
      "  stability_map --count 5000 --seed 1 --out map          the map; some minutes\n"
      "  stability_map --count 100000 --seed 2 --out nightly    a night's run\n"
      "  stability_map --both --count 3000 --seed 3             auto answers whatever sdirk4 answers\n"
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
  return (options.both ? upbead::test::run_both(options) : upbead::test::run(options)) ? 0 : 1;
}
