// Does a march of very many steps drift, and does a harmonic one reach the frequency response?

#include <CLI/CLI.hpp>
#include <cmath>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "long_march.h"
#include "upbead/algebra/petsc_session.h"

namespace upbead::test {
namespace {

using Json = nlohmann::ordered_json;

/// Collects the results, and whether they are within their bounds.
struct Findings {
  Json rows = Json::array();
  bool good = true;

  void add(const std::string& what, const std::string& tried, double value, double least, double largest) {
    std::ostringstream text;
    text.precision(2);
    text << std::scientific << value << " (at most " << largest << (least > 0. ? ", at least " : "");
    if (least > 0.) text << least;
    text << ")";
    const bool holds = value >= least && value <= largest;
    good = good && holds;
    rows.push_back({{"what", what}, {"tried", tried}, {"came_out", text.str()}});
    std::cout << (holds ? "ok    " : "FAILS ") << what << ", " << tried << ": " << text.str() << std::endl;
  }
};

std::string name_of(SchemeKind kind) {
  return kind == SchemeKind::sdirk4 ? "sdirk4" : "generalised_alpha";
}

/// Bound of the mean of an undamped oscillation about its centre, over the last tenth T of the march: 2 / (omega T).
double bound_of_mean(double periods) {
  return 10. / (std::acos(-1.) * periods);
}

void add_long(SchemeKind kind, bool wet, int steps, Findings& findings) {
  const LongMarch found = march_long(kind, wet, steps);
  std::ostringstream tried;
  tried << name_of(kind) << ", " << (wet ? "wet sand" : "dry sand without damping") << ", " << steps << " steps, "
        << static_cast<long>(found.periods) << " periods";
  findings.add("work minus all energies, over the largest work", tried.str(), found.energy, 0., 1e-9);
  findings.add("mean displacement less the static one, over that", tried.str(), found.drift, 0.,
               wet ? 1e-9 : bound_of_mean(found.periods));
  findings.add("kinetic energy in the last tenth over that in the first", tried.str(),
               found.finite ? found.motion : 1e300, 0., 1.);
}

void add_steady(SchemeKind kind, Findings& findings) {
  const std::vector<double> errors = steady_state_errors(kind, 5);
  const double order = kind == SchemeKind::sdirk4 ? 4. : 2., found = std::log2(*(errors.end() - 2) / errors.back());
  std::ostringstream steps;
  steps << name_of(kind) << ", " << (16 << (errors.size() - 1)) << " steps a period, 400 periods";
  findings.add("displacements against the frequency response", steps.str(), errors.back(), 0.,
               order > 3. ? 1e-7 : 1e-3);
  findings.add("order of that error in the step",
               name_of(kind) + ", between the last two of " + std::to_string(errors.size()) + " steps", found,
               order - 0.1, order + 0.3);
}

}  // namespace
}  // namespace upbead::test

int main(int argc, char** argv) {
  using namespace upbead::test;
  int steps = 20000;
  std::string facts;
  CLI::App program(
      "Marches of very many steps, and harmonic marches to the steady state. Exit code 1 where one drifts.");
  program.add_option("--steps", steps, "of the long marches")->capture_default_str();
  program.add_option("--facts", facts, "JSON file for docs/reference/reliability.md");
  CLI11_PARSE(program, argc, argv);
  const upbead::PetscSession petsc;
  Findings findings;
  for (const auto kind : {upbead::SchemeKind::sdirk4, upbead::SchemeKind::generalised_alpha}) {
    for (const bool wet : {false, true}) add_long(kind, wet, steps, findings);
    add_steady(kind, findings);
  }
  const Json page = {{"title", "Long time"},
                     {"text",
                      "A column of sand under a load that is put on at once and stays: after very many steps the "
                      "account of energy closes, the mean displacement is the static one and what still moves has "
                      "not grown. A harmonic load near resonance, marched to its steady state, is the frequency "
                      "response up to the order of the scheme."},
                     {"command", "build/tests/stability/long_time --steps " + std::to_string(steps)},
                     {"figure", nullptr},
                     {"rows", findings.rows}};
  if (!facts.empty()) std::ofstream(facts) << page.dump(2) << "\n";
  return findings.good ? 0 : 1;
}
