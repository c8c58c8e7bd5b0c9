#include "reduced_slip.h"

#include "base/stopwatch.h"
#include "sliding/loose_scene.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

ModelSlip model_slip(const Simulation& simulation, const Reduction& glued,
                     const std::function<void(double)>& progress) {
  const Scene& s = simulation.scene;
  const Response response = respond(glued, s, simulation.compiled->system);
  SlipReduction reduction = reduce_loose(s, compile_loose(simulation), response.ends, progress);
  // whether slip is well posed shows here, not to the first who asks for waves
  slip_model(reduction.system, slip_law(reduction.system, s.sliding->friction, slip_uplift(*s.sliding)));
  return {std::move(reduction.system), reduction.error.history, reduction.glued_error, reduction.n_vectors,
          reduction.n_solves};
}

}  // namespace

ReducedSlip reduce_with_slip(const Simulation& simulation, const Reduction& glued,
                             const std::function<void(double)>& progress) {
  ReducedSlip slip;
  if (!simulation.scene.sliding) return slip;
  slip.why_not = why_no_slip(simulation);
  if (!slip.why_not.empty()) return slip;
  const Stopwatch watch;
  try {
    slip.model = model_slip(simulation, glued, progress);
  } catch (const NumericsError& error) {
    slip.why_not = error.what();
  }
  slip.seconds = watch.seconds();
  return slip;
}

}  // namespace upbead
