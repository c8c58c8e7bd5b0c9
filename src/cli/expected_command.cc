// The command expected, whole or by parts.
#include <algorithm>
#include <iostream>

#include "base/interrupt.h"
#include "base/parts.h"
#include "base/work_lock.h"
#include "cli/design_command.h"
#include "design/expected_report.h"
#include "design/lives.h"
#include "respond/node_slips.h"

namespace upbead {

namespace {

void require_lives(const Design& design, const std::string& option) {
  if (!design.tables.life)
    throw InputError({option}, "is of lives, and the design has none", "add a table [life], or leave out " + option);
}

int tell_lives_done(const Interrupted& interrupted, const Design& design, const DesignOptions& options,
                    const Part& part, const std::vector<int>& lives) {
  const KeptLives kept = read_lives(options.out, design, part.name() + "-");
  std::cerr << "upbead: interrupted; "
            << std::count_if(lives.begin(), lives.end(), [&kept](int life) { return kept.has(life); }) << " of "
            << lives.size() << " lives of the part are done, the same command goes on with the rest\n";
  return exit_signal + interrupted.signal();
}

/// Computes the lives of a part that have no result yet.
int compute_part(const Design& design, const DesignOptions& options) {
  if (options.merge)
    throw InputError({"--merge"}, "takes what all parts have computed, and computes none",
                     "leave out --part, or --merge");
  require_lives(design, "--part");
  const Part part = options.part == "auto" ? part_of_launch() : read_part(options.part);
  const WorkLock lock(options.out, part.lock());
  const std::vector<int> lives =
      dealt_in_stretches(design.tables.life->lives, part.of)[static_cast<std::size_t>(part.number) - 1].front();
  const KeptLives kept = read_lives(options.out, design, part.name() + "-");
  std::vector<int> left;
  for (const int life : lives)
    if (!kept.has(life)) left.push_back(life);
  if (kept.torn > 0 && !left.empty())
    std::cerr << "upbead: lines of the journal that are not whole: " << kept.torn << "; their lives are done again\n";
  try {
    // a part without a life shows that it was begun
    if (!left.empty() || lives.empty()) keep_lives(options.out, design, left, part.name() + "-0");
  } catch (const Interrupted& interrupted) {
    return tell_lives_done(interrupted, design, options, part, lives);
  }
  const std::size_t resumed = lives.size() - left.size();
  const std::string next = command_line("expected", options, " --merge");
  std::cout << (options.json ? json_text({{"part", part.text()}, {"lives", lives.size()}, {"resumed", resumed}})
                             : "part        " + part.text() + ", " + std::to_string(lives.size()) + " lives, " +
                                   std::to_string(resumed) + " of them done before\nnext        " + next +
                                   ", once all parts are done\n");
  return 0;
}

/// All lives of the parts. Throws InputError where some are missing, with the commands that compute them.
LivesByLaw merged_lives(const Design& design, const DesignOptions& options) {
  require_lives(design, "--merge");
  const KeptLives kept = read_lives(options.out, design);
  const std::optional<int> parts = parts_begun(options.out);
  if (!parts)
    throw InputError({options.out}, "holds no life of the design yet",
                     "compute them, in parts: " + command_line("expected", options, " --part K/N"));
  Diagnostics report;
  for (const MissingRuns& missing : missing_parts(options.out, dealt_in_stretches(design.tables.life->lives, *parts),
                                                  [&kept](int life) { return kept.has(life); }))
    report.add({"part " + missing.part},
               std::to_string(missing.runs.size()) + " lives have no result" +
                   (missing.holder.empty() ? "" : ", at which " + missing.holder + " works"),
               command_line("expected", options, " --part " + missing.part));
  report.throw_if_any();
  return by_law(kept);
}

DesignOutput expected(const Design& design, const DesignOptions& options, const Stopwatch& since_start) {
  ExpectedTiming timing;
  timing.read = since_start.seconds();
  const LivesByLaw lives = options.merge ? merged_lives(design, options) : LivesByLaw();
  const ExpectedAnswer answer = find_expected(design, options.merge ? &lives : nullptr, node_slips);
  const std::string results = expected_file(design, answer);
  timing.total = since_start.seconds();
  Json summary = to_json(design, answer, timing);
  std::string text = brief(design, answer, summary);
  return {{{"results.h5", results}},
          std::move(summary),
          std::move(text),
          note_lines(answer.notes) + describe(warnings_of(design, answer))};
}

const char* const expected_footer =
    R"(Sums the sliding distances S of all waves of a record of sea states: heights by Rayleigh up to Goda's highest random
breaker (sea.highest), S by four laws (docs/expected.md), quadrature. With [life] it also simulates lives by Monte Carlo, with [scatter.NAME] for what is
uncertain. With [dynamics] every wave's impulsive force goes through the caisson's reduced model.

Writes into results/NAME-expected (or --out DIR), all or nothing:
  summary.json   expected distances, waves above heights, Monte Carlo; SI units
  results.h5     S and its share in the expectation over the height, S of each life
  case.toml      the design with all defaults; runs again

Lives may be computed in parts, on many machines with a shared disk; --merge then makes the same files of them:
  sbatch --array=1-100 --wrap 'upbead expected DESIGN --part $SLURM_ARRAY_TASK_ID/100'
  parallel upbead expected DESIGN --part {}/8 ::: $(seq 8)
  upbead expected DESIGN --merge

Examples:
  upbead expected cases/section4/hd12.toml
  upbead expected cases/section4/hd12.toml --set life.simulated_lives=10000 --set scatter.force.cov=0.1
  upbead expected cases/section4/hd10.toml --json | jq .expected.distance_paper
  upbead expected --keys)";

}  // namespace

Command expected_command() {
  return design_command({"expected", "expected sliding distance of sea states, and of lives", {}, {}, expected_footer},
                        {"-expected",
                         {check_expected},
                         {"summary.json", "results.h5", "case.toml"},
                         rows_of_expected,
                         expected,
                         compute_part});
}

}  // namespace upbead
