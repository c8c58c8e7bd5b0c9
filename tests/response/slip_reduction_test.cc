// Claims: the reduced model of a caisson that may slip sticks as its glued twin does and errs by less than was asked
// for; ...
#include "upbead/response/slip_reduction.h"

#include <gtest/gtest.h>

#include <chrono>
#include <iostream>

#include "scenes.h"
#include "upbead/fem/caisson_readings.h"
#include "upbead/response/reduction.h"
#include "upbead/sliding/coupled_slip.h"
#include "upbead/system/interface.h"

namespace upbead::test {
namespace {

TEST(SlipReduction, SticksAsItsGluedTwin) {
  constexpr double duration = 0.15;
  Scene scene = breakwater(triangle(1.6e6, duration));
  scene.time.end = 0.8;
  const auto mesh = breakwater_mesh(0.5);
  const Compiled compiled(scene, *mesh, true);
  const Compiled twin(scene, *mesh);
  const Response glued = run(twin, 0.8, duration / 32.);
  using Clock = std::chrono::steady_clock;
  auto t0 = Clock::now();
  const SlipReduction r = reduce_slip(compiled.resolved, compiled.scene, SlipUplift::computed, glued.ends);
  auto t1 = Clock::now();
  std::cout << "n " << compiled.scene.system.n_free() << " vectors " << r.n_vectors << " solves " << r.n_solves
            << " error " << r.error.of_reading.transpose() << " glued " << r.glued_error << " conv " << r.converged
            << " coords " << r.system.size() << " s " << std::chrono::duration<double>(t1 - t0).count() << std::endl;
  for (double mu : {0.6, 1.5}) {
    t0 = Clock::now();
    const SlipModel m = slip_model(r.system, slip_law(r.system, mu, SlipUplift::computed, {"caisson/displacement_x"}));
    t1 = Clock::now();
    double fastest = 0.;
    for (auto p : m.phases[1].modes.pole) fastest = std::max(fastest, std::abs(p));
    std::cout << "mu " << mu << " growth " << m.growth << " modes " << m.phases[0].modes.n_modes() << " states "
              << m.phases[0].to_state.rows() << " share " << m.share_of_slip << " fastest " << fastest << " s "
              << std::chrono::duration<double>(t1 - t0).count() << std::endl;
    const double peak = glued.ends.reading.row(compiled.scene.system.reading(reading::shear_force)).maxCoeff();
    for (const double safety : {1.2, 0.9, 0.7, 0.4}) {
      const double step = 1e-3;
      const double W = safety * peak / mu;
      WaveSamples wave(2, 2001);
      for (int i = 0; i < 2001; ++i) {
        wave(0, i) = compiled.scene.system.loads[0].history(i * step);
        wave(1, i) = W;
      }
      CoupledHistory h;
      const CoupledSlip slip(m, step);
      const CoupledSliding s = slip.slide(wave, &h);
      t0 = Clock::now();
      for (int i = 0; i < 20; ++i) slip.slide(wave);
      t1 = Clock::now();
      WaveSamples coarse(2, 1001);
      for (int i = 0; i < 1001; ++i) coarse.col(i) = wave.col(2 * i);
      const CoupledSliding c = CoupledSlip(m, 2 * step).slide(coarse);
      std::cout << "  sf " << safety << " S " << s.slip.residual << " double step " << c.slip.residual / s.slip.residual - 1.
                << " slips " << s.slip.slips.size() << " F " << s.peak_shear / (mu * W) << " N " << s.least_normal / W
                << " lift " << s.lifted_time << " D " << s.dissipated << " over " << s.n_passed_over << " waves/s "
                << 20. / std::chrono::duration<double>(t1 - t0).count() << " x " << h.wanted(0, 2000) << std::endl;
    }
  }
}

}  // namespace
}  // namespace upbead::test
