#include "both_ways.h"

#include <algorithm>
#include <cmath>

#include "case/case_findings.h"
#include "case/case_run.h"
#include "upbead/base/error.h"

namespace upbead::test {

namespace {

struct Answer {
  std::string refused;
  double peak = -1.;  ///< of |F_T|
  Ladder ladder;
};

Answer answer(const std::string& path, const std::string& scheme, double finer) {
  Case input = read_case(path, {"time.scheme=" + scheme});
  if (input.scene.time.step) *input.scene.time.step /= finer;
  require_loads(input);
  const Simulation scene = simulation_of(input);
  Answer answer;
  try {
    const Run run = solve(input, scene);
    to_json(run.summary);  // throws where a number is not finite
    answer.ladder = run.summary.ladder;
    if (const auto& r = run.summary.response) answer.peak = std::max(r->peak_shear, -r->peak_shear_seaward);
  } catch (const NumericsError& error) {
    answer.refused = error.what();
  }
  return answer;
}

}  // namespace

BothWays solve_both_ways(const std::string& path, double finer) {
  BothWays both;
  try {
    const Answer marched = answer(path, "sdirk4", finer), automatic = answer(path, "auto", finer);
    both.sdirk4 = marched.refused;
    both.steps_of_ladder = static_cast<int>(automatic.ladder.size());
    if (!automatic.refused.empty()) {
      both.kind = marched.refused.empty() ? Verdict::Kind::failed : Verdict::Kind::refused;
      both.why = automatic.refused;
      return both;
    }
    both.way = automatic.ladder.back().way;
    const double larger = std::max(marched.peak, automatic.peak);
    if (marched.refused.empty() && larger > 0.) both.difference = std::abs(marched.peak - automatic.peak) / larger;
  } catch (const InputError& error) {
    both.kind = Verdict::Kind::contradictory;
    both.why = error.diagnostics().list().front().what;
  }
  return both;
}

}  // namespace upbead::test
