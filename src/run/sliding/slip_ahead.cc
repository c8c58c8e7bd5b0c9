#include "run/sliding/slip_ahead.h"

#include <algorithm>

#include "base/cores.h"
#include "fem/caisson/bottom.h"
#include "response/shear_response.h"
#include "run/soil_member.h"

namespace upbead {

namespace {

AssembledScene with_interface(const Simulation& simulation) {
  return assemble_scene(simulation.scene(), *simulation.mesh(), simulation.absent(), simulation.soil_state(), true);
}

/// The largest horizontal force over the friction by the caisson's weight.
double demand(const Simulation& simulation) {
  const TimeFunction P = force_on_caisson(*simulation.compiled());
  const double end = simulation.scene().time.end;
  const SlidingChoice& sliding = *simulation.scene().sliding;
  return std::max(extremum(P, 0., end, 1).value, -extremum(P, 0., end, -1).value) /
         (sliding.friction * sliding.submerged_weight);
}

/// Fulfils a promise at the end of its scope, also after an exception.
struct KeptPromise {
  std::promise<void>& promise;
  ~KeptPromise() { promise.set_value(); }
};

bool is_worth_it(const Simulation& simulation) {
  return !simulation.member() && has_spare_core() && simulation.scene().sliding && simulation.compiled()->caisson &&
         why_no_slip(simulation).empty() && demand(simulation) > 1.;
}

}  // namespace

std::string why_no_slip(const Simulation& simulation) {
  const System& system = simulation.compiled()->system;
  if (system.is_divided()) return "several processes share the work";
  if (!simulation.scene().time.inertia) return "consolidation has no dynamics";
  if (yields(simulation.scene()))
    return "the soil yields, and slip as a whole is followed on a reduced model of linear ground alone";
  const std::string& region = simulation.compiled()->caisson->body.region;
  const std::vector<Body>& bodies = simulation.compiled()->bodies;
  if (std::none_of(bodies.begin(), bodies.end(), [&region](const Body& body) { return body.region == region; }))
    return "the caisson deforms";
  if (!bottom_is_level(*simulation.mesh())) return "the caisson's bottom is not level";
  if (simulation.scene().initial && simulation.scene().initial->harbour_level)
    return "still water at two levels shears the base before the wave, and slip as a whole begins without shear";
  return "";
}

UpliftKind slip_uplift(const SlidingChoice& choice) {
  const bool computed = choice.uplift && choice.uplift->kind == UpliftKind::computed;
  return computed ? UpliftKind::computed : UpliftKind::prescribed;
}

SlidingSpace::SlidingSpace(const Simulation& simulation, AssembledScene assembled)
    : assembled_(std::move(assembled)),
      space_(simulation.scene(), *assembled_.compiled, slip_uplift(*simulation.scene().sliding)) {}

SlipAhead::SlipAhead(std::shared_ptr<const Simulation> simulation)
    : simulation_(std::move(simulation)), left_mesh_(assembled_.get_future().share()) {
  space_ = std::async(std::launch::async, [this] {
    AssembledScene assembled = [&] {
      const KeptPromise left{assembled_};
      return with_interface(*simulation_);
    }();
    return std::make_unique<SlidingSpace>(*simulation_, std::move(assembled));
  });
}

SlidingSpace::SlidingSpace(const Simulation& simulation)
    : space_(simulation.scene(), simulation.member()->compiled, *simulation.member()->slip,
             slip_uplift(*simulation.scene().sliding)) {}

std::unique_ptr<SlidingSpace> SlipAhead::space_for(const Simulation& simulation) {
  const bool fits =
      space_.valid() && slip_uplift(*simulation.scene().sliding) == slip_uplift(*simulation_->scene().sliding);
  return fits ? space_.get() : nullptr;
}

std::shared_ptr<SlipAhead> slip_ahead(const Simulation& simulation) {
  if (!is_worth_it(simulation)) return nullptr;
  return std::make_shared<SlipAhead>(std::make_shared<const Simulation>(simulation));
}

std::unique_ptr<SlidingSpace> sliding_space(const Simulation& simulation, SlipAhead* begun) {
  if (begun != nullptr)
    if (auto space = begun->space_for(simulation)) return space;
  if (simulation.member() && simulation.member()->slip) return std::make_unique<SlidingSpace>(simulation);
  return std::make_unique<SlidingSpace>(simulation, with_interface(simulation));
}

}  // namespace upbead
