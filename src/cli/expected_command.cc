#include <iostream>

#include "base/files.h"
#include "base/interrupt.h"
#include "base/stopwatch.h"
#include "cli/commands.h"
#include "design/design.h"
#include "design/design_files.h"
#include "design/expected_checks.h"
#include "design/expected_report.h"

namespace upbead {

namespace {

void expect(const CommonOptions& options, const Stopwatch& since_start) {
  ExpectedTiming timing;
  const Design design = read_design(options.file, options.overrides, {check_expected});
  timing.read = since_start.seconds();
  note_interrupts();
  const std::string out = options.out.empty() ? "results/" + design.stem + "-expected" : options.out;
  require_inputs_kept(out, {"results.h5", "case.toml", "summary.json"}, input_files(design));
  OutputFolder folder(out);
  const ExpectedAnswer answer = find_expected(design);
  folder.write("results.h5", expected_file(design, answer));
  folder.write("case.toml", effective_design(design, folder.name()));
  timing.total = since_start.seconds();
  const std::string json = to_json(design, answer, timing);
  folder.write("summary.json", json);
  check_interrupt();
  folder.commit();
  std::cerr << notes_and_warnings(answer);
  std::cout << (options.json ? json
                             : describe(design, answer) + "written     " + folder.name() +
                                   "/{summary.json, results.h5, case.toml}\n");
}

const char* const expected_footer =
    "Sums the sliding distances S of all waves of a record of sea states: heights by Rayleigh, S by four laws\n"
    "(docs/expected.md), quadrature. With [life] it also simulates lives by Monte Carlo, with [scatter.NAME] for what "
    "is\n"
    "uncertain. With [dynamics] every wave's impulsive force goes through the caisson's reduced model.\n\n"
    "Writes into results/NAME-expected (or --out DIR), all or nothing:\n"
    "  summary.json   expected distances, waves above heights, Monte Carlo; SI units\n"
    "  results.h5     S and its share in the expectation over the height, S of each life\n"
    "  case.toml      the design with all defaults; runs again\n\n"
    "Examples:\n"
    "  upbead expected cases/section4/hd12.toml\n"
    "  upbead expected cases/section4/hd12.toml --set life.lives=10000 --set scatter.force.cov=0.1\n"
    "  upbead expected cases/section4/hd10.toml --json | jq .expected.distance_paper\n"
    "  upbead expected --keys";

}  // namespace

void add_expected(CLI::App& program) {
  auto options = std::make_shared<CommonOptions>();
  auto keys = std::make_shared<bool>(false);
  CLI::App* command = program.add_subcommand("expected", "expected sliding distance of sea states, and of lives");
  add_common_options(*command, *options);
  command->get_option("FILE")->required(false)->description("the design (TOML)");
  command->get_option("--out")->description(
      "folder for the results (default: results/NAME-expected, NAME as the file's)");
  command->add_flag("--keys", *keys, "print every key of a design file with unit, range, default and meaning");
  command->footer(expected_footer);
  command->callback([options, keys, since_start = Stopwatch()] {
    if (*keys)
      std::cout << design_reference();
    else if (options->file.empty())
      throw CLI::RequiredError("FILE");
    else
      expect(*options, since_start);
  });
}

}  // namespace upbead
