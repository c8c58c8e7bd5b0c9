// The command reliability: probability of failure of a section in one wave whose numbers are random.
#include "cli/design_command.h"
#include "reliability/answer.h"

namespace upbead {

namespace {

DesignOutput reliability(const Design& design, const DesignOptions&, const Stopwatch&) {
  const ReliabilityAnswer answer = find_reliability(design);
  Json summary = to_json(design, answer);
  std::string text = brief(design, answer, summary);
  return {{}, std::move(summary), std::move(text), describe(warnings_of(design, answer))};
}

const char* const reliability_footer =
    R"(How probable is it that the section fails in one occasion (the highest wave of a year, say), in a year and in a life?
Each way to fail has a margin g by formulas; it fails where g < 0. The numbers of the design that are random are named:
  [reliability]
  wave = "design"                # of [waves.design]
  occasions_per_year = 1         # the variables below are those of one occasion
  years = 50
  [reliability.variables.height]
  acts_on = "waves.design.height"   # a key of the design, or a factor: force (of P), uplift, friction, weight, ...
  distribution = "gumbel"           # of the highest wave of a year
  mean = 6.5                        # default: the number of the design; of a factor 1
  cov = 0.12
  [reliability.variables.goda]
  acts_on = "force"
  mean = 0.91
  cov = 0.17
  [reliability.system.washed_away]  # a fault tree; without one any way to fail is a failure
  any = ["sliding_distance", "overturning"]

Methods: form (beta, the distance of the nearest point of failure), sorm (with its curvature), importance (samples around
that point), subset (levels of g), plain (all by chance: the judge). Where they differ by more than 0.1 in beta, both stand
and the worse governs. docs/failure-chances.md says what each can and cannot see.

Writes into results/NAME-reliability (or --out DIR), all or nothing:
  summary.json   probability and beta by mode and method, design points, partial factors, demands of codes
  case.toml      the design with all defaults; runs again

Examples:
  upbead reliability cases/designer/reliability.toml
  upbead reliability cases/designer/reliability.toml --set section.width=21
  upbead reliability cases/designer/reliability.toml --json | jq '.modes.sliding.life'
  upbead reliability --keys)";

}  // namespace

Command reliability_command() {
  Command command = sampling_commands().front();
  command.footer = reliability_footer;
  return design_command(
      command, {"-reliability", {check_random}, {"summary.json", "case.toml"}, rows_of_reliability, reliability});
}

}  // namespace upbead
