// Measures for docs/expected.md how many waves a second one core takes. Not a test: it never fails.
//
//   bench_expected [MODEL.h5]     (of cases/fig2b-prototype.toml)

#include <cstdio>
#include <numeric>
#include <vector>

#include "base/stopwatch.h"
#include "expected/dynamic_law.h"
#include "upbead/expected/life.h"
#include "upbead/output/model_file.h"

using namespace upbead;

namespace {

/// The section of cases/expected/prototype.toml.
Breakwater prototype() {
  Breakwater b;
  b.section = {15., 9., 9., 7., 18., 7., 0.01, 5.933e6, 4.296e6, {}, 0.6, false, {}, {}, {}};
  return b;
}

const SeaState sea{6.5, 14., 1000., 0., 0.};

/// Prints how many waves of these heights a law computes in a second.
void measure(const char* name, const SlidingLaw& law, const std::vector<double>& heights) {
  const Stopwatch watch;
  double sum = 0.;
  std::size_t n = 0;
  for (; watch.seconds() < 1.; n += heights.size())
    for (const double height : heights) sum += law.distance(height);
  std::printf("%-45s %10.3g waves a second (mean S %.4g m)\n", name, static_cast<double>(n) / watch.seconds(),
              sum / static_cast<double>(n));
}

std::vector<double> heights(double from, double to) {
  std::vector<double> list(1000);
  for (std::size_t i = 0; i < list.size(); ++i) list[i] = from + (to - from) * (static_cast<double>(i) + 0.5) / 1000.;
  return list;
}

LifeSetup lives() {
  LifeSetup setup;
  setup.states = {sea};
  setup.record_years = setup.life_years = 1.;
  setup.law = [](const SeaState& state) { return formula_law(Law::exact, prototype(), state); };
  return setup;
}

void measure(const char* name, const LifeSetup& setup) {
  const LifeSimulation simulation(setup);
  const Stopwatch watch;
  Life sum;
  for (std::uint32_t i = 0; watch.seconds() < 1.; ++i) {
    const Life life = simulation.life(i);
    sum.waves += life.waves;
    sum.answered += life.answered;
  }
  std::printf("%-45s %10.3g waves a second, S computed for %.3g\n", name, sum.waves / watch.seconds(),
              sum.answered / watch.seconds());
}

Distribution normal(double cov, Per per) {
  Scatter scatter;
  scatter.cov = cov;
  scatter.per = per;
  return {scatter, 1.};
}

std::shared_ptr<const ShearAnswer> read(const char* path, double step) {
  const ReducedModelFile file = read_model_file(path);
  const ModalModel& modes = file.modes;
  return std::make_shared<const ShearAnswer>(
      ShearModel{modes, 0, modes.index("shear_force"), modes.feedthrough(modes.index("force"), 0), file.caisson_mass},
      step, 20.);
}

}  // namespace

int main(int argc, char** argv) {
  for (const Law law : {Law::paper, Law::exact, Law::combined}) {
    const auto of = formula_law(law, prototype(), sea);
    measure((std::string(word(law)) + ", waves that slide").c_str(), *of, heights(12.5, 20.));
  }
  LifeSetup setup = lives();
  measure("lives, only waves that may slide drawn", setup);
  setup.every_wave = true;
  measure("lives, every wave drawn", setup);
  setup = lives();
  setup.uncertain.force = normal(0.1, Per::storm);
  setup.uncertain.friction = normal(0.1, Per::life);
  measure("lives, force scatters by storm", setup);
  setup.uncertain.significant_height = normal(0.1, Per::storm);
  measure("lives, force and sea scatter by storm", setup);
  setup.uncertain.force = normal(0.1, Per::wave);
  setup.uncertain.friction = normal(0.1, Per::wave);
  measure("lives, force and friction scatter by wave", setup);
  if (argc < 2) return 0;
  for (const double step : {1e-3, 4e-3}) {
    const DynamicLaw dynamic(prototype(), sea, {}, read(argv[1], step));
    std::printf("steps of %g ms; waves are computed from H = %.2f m\n", 1e3 * step, dynamic.threshold({}));
    measure("  dynamic, waves that slide", dynamic, heights(10., 14.));
    measure("  dynamic, computed but not sliding", dynamic, heights(7., 9.));
    measure("  dynamic, skipped by the bound", dynamic, heights(1., 3.));
  }
  return 0;
}
