// Random waves on a lumped breakwater that slips: how many are computed in a second, and whether one fails.
//
// usage: bench_slip WAVES
//
// Prints JSON. Of 2,000 samples each; friction from 0.3 to 1.5.

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <nlohmann/json.hpp>

#include "../sliding/lumped.h"
#include "../sliding/lumped_breakwater.h"
#include "../sliding/random_waves.h"
#include "base/stopwatch.h"
#include "sliding/coupled_slip.h"
#include "upbead/algebra/petsc_session.h"

namespace upbead {
namespace {

using Json = nlohmann::ordered_json;

constexpr int n_samples = 2000, n_frictions = 25;
constexpr double step = 1e-3;
constexpr double uplift_share = 0.5;  ///< of P, prescribed for every second wave, so that some lift the caisson

/// Number and time of the waves with sliding, or of those without.
struct Count {
  int waves = 0;
  double seconds = 0.;
  double per_second() const { return waves / std::max(seconds, 1e-9); }
};

Json measure(int n_waves) {
  const test::LumpedBreakwater breakwater;
  test::RandomWaves waves(20260101);
  Count slid, rested;
  int changes = 0, passed_over = 0, lifted = 0, states = 0, modes = 0;
  double least_dissipated = 0., growth = 0.;
  for (int i = 0; i < n_frictions; ++i) {
    const CoupledSlip slip(breakwater.model(0.3 + 1.2 * i / (n_frictions - 1)), step);
    states = static_cast<int>(slip.model().phases[0].to_state.rows());
    modes = slip.model().phases[0].modes.n_modes();
    growth = std::max(growth, slip.model().growth);
    for (int n = 0; n < n_waves / n_frictions; ++n) {
      WaveSamples loads = test::samples(waves.next(step), breakwater.weight, step, n_samples);
      if (n % 2 == 1) loads.row(1) -= uplift_share * loads.row(0).cwiseMax(0.);
      const Stopwatch watch;
      const CoupledSliding found = slip.slide(loads);
      Count& count = found.slip.path > 0. ? slid : rested;
      count.seconds += watch.seconds();
      ++count.waves;
      changes += found.n_changes;
      passed_over += found.n_passed_over;
      lifted += found.lifted_time > 0. ? 1 : 0;
      least_dissipated = std::min(least_dissipated, found.dissipated);
    }
  }
  return {{"states", states},
          {"modes", modes},
          {"growth", growth},
          {"waves", slid.waves + rested.waves},
          {"slid", slid.waves},
          {"lifted", lifted},
          {"changes_of_phase", changes},
          {"passed_over", passed_over},
          {"least_dissipated", least_dissipated},
          {"slid_per_second", slid.per_second()},
          {"stuck_per_second", rested.per_second()}};
}

}  // namespace
}  // namespace upbead

int main(int argc, char** argv) {
  const upbead::PetscSession petsc;
  const int n_waves = argc > 1 ? std::atoi(argv[1]) : 10000;
  std::cout << upbead::measure(n_waves).dump(2) << '\n';
  return 0;
}
