#include "run/sliding/slip_ahead.h"

#include <algorithm>

#include "base/cores.h"
#include "dynamics/basis.h"
#include "fem/caisson/bottom.h"
#include "response/reduction.h"
#include "response/shear_response.h"
#include "run/soil_member.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

const CompiledScene& bonded_scene(const Simulation& simulation) {
  return simulation.member() ? simulation.member()->compiled : *simulation.compiled();
}

/// What of the scene tells the row of its slip.
SlipSystem slip_of(const Simulation& simulation) {
  if (simulation.member() && simulation.member()->slip) return *simulation.member()->slip;
  return slip_system(compile_bottom(simulation.scene(), *simulation.space()));
}

std::shared_ptr<BasisRoom> room_of(const Simulation& simulation) {
  return simulation.member() ? simulation.member()->room : simulation.room();
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
  return simulation.room() && !simulation.room()->slip() && !simulation.member() && has_spare_core() &&
         may_slip(simulation) && demand(simulation) > 1.;
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

bool may_slip(const Simulation& simulation) {
  return simulation.scene().sliding && simulation.compiled()->caisson && why_no_slip(simulation).empty();
}

std::shared_ptr<SlipBasis> basis_for_slip(const Simulation& simulation) {
  const CompiledScene& compiled = bonded_scene(simulation);
  const std::shared_ptr<BasisRoom> room = room_of(simulation);
  std::shared_ptr<GrowingBasis> bonded =
      room ? room->basis_about(room->shift().value_or(krylov_shift(simulation.scene())), compiled.body_coordinates)
           : nullptr;
  if (bonded && room->slip()) return room->slip();
  return slip_basis(simulation.scene(), compiled, slip_of(simulation), std::move(bonded));
}

SlidingSpace::SlidingSpace(const Simulation& simulation, std::shared_ptr<SlipBasis> basis)
    : space_(simulation.scene(), bonded_scene(simulation), slip_uplift(*simulation.scene().sliding), std::move(basis)) {
}

SlipAhead::SlipAhead(std::shared_ptr<const Simulation> simulation, std::shared_ptr<GrowingBasis> bonded)
    : simulation_(std::move(simulation)), left_mesh_(assembled_.get_future().share()) {
  space_ = std::async(std::launch::async, [this, bonded] {
    const SlipSystem slips = [&] {
      const KeptPromise left{assembled_};
      return slip_of(*simulation_);
    }();
    const auto basis = slip_basis(simulation_->scene(), bonded_scene(*simulation_), slips, bonded);
    auto space = std::make_unique<SlidingSpace>(*simulation_, basis);
    space->prepare();
    return space;
  });
}

std::unique_ptr<SlidingSpace> SlipAhead::space_for(const Simulation& simulation) {
  const bool fits =
      space_.valid() && slip_uplift(*simulation.scene().sliding) == slip_uplift(*simulation_->scene().sliding);
  return fits ? space_.get() : nullptr;
}

std::shared_ptr<SlipAhead> slip_ahead(const Simulation& simulation) {
  if (!is_worth_it(simulation)) return nullptr;
  const CompiledScene& compiled = *simulation.compiled();
  ReduceOptions options = reduce_options(simulation.scene(), compiled, {});
  options.shift = simulation.room()->shift().value_or(options.shift);
  try {
    return std::make_shared<SlipAhead>(std::make_shared<const Simulation>(simulation),
                                       simulation.room()->basis(compiled.system, options));
  } catch (const NumericsError&) {
    return nullptr;  // whoever reduces the scene is told so
  }
}

std::unique_ptr<SlidingSpace> sliding_space(const Simulation& simulation, SlipAhead* begun) {
  std::unique_ptr<SlidingSpace> space = begun != nullptr ? begun->space_for(simulation) : nullptr;
  if (!space) space = std::make_unique<SlidingSpace>(simulation, basis_for_slip(simulation));
  if (const auto room = room_of(simulation)) room->keep(space->basis());
  return space;
}

}  // namespace upbead
