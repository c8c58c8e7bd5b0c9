// The reduced space of a caisson that slips, made on another core while the bonded caisson is solved.
#pragma once

#include <future>
#include <memory>
#include <string>

#include "fem/compile.h"
#include "response/slip_reduction.h"
#include "upbead/run/simulation.h"

namespace upbead {

/// Why the slip of a scene with a caisson cannot be computed; "" where it can.
std::string why_no_slip(const Simulation& simulation);

/// The kind of uplift that N' must be reduced by, from [sliding].
UpliftKind slip_uplift(const SlidingChoice& choice);

/// Whether slip as a whole can be asked of a scene, so that the basis in which it is reduced is worth keeping.
bool may_slip(const Simulation& simulation);

/// What slip adds to the basis of the bonded scene: both from the simulation's room, where they are there.
std::shared_ptr<SlipBasis> basis_for_slip(const Simulation& simulation);

/// The space for the reduction of a scene that slips, beside the basis in which the bonded scene is reduced. The
/// simulation's scene must outlive it.
class SlidingSpace {
 public:
  SlidingSpace(const Simulation& simulation, std::shared_ptr<SlipBasis> basis);
  void prepare() { space_.prepare(); }
  const std::shared_ptr<SlipBasis>& basis() const { return space_.basis(); }
  SlipReduction reduce(const Series& bonded, const std::function<void(double)>& progress) {
    return space_.reduce(bonded, progress);
  }

 private:
  SlipSpace space_;
};

/// Makes a SlidingSpace on another core while the bonded caisson is solved.
class SlipAhead {
 public:
  /// `bonded`: the basis in which the bonded caisson is solved meanwhile.
  SlipAhead(std::shared_ptr<const Simulation> simulation, std::shared_ptr<GrowingBasis> bonded);
  SlipAhead(const SlipAhead&) = delete;
  SlipAhead& operator=(const SlipAhead&) = delete;

  /// Returns once the mesh is no longer read here: deal.II marks cells while it numbers unknowns, so that no other
  /// thread may go through the cells meanwhile.
  void leave_mesh() const { left_mesh_.wait(); }
  /// Gives the space away, at the first call, to a scene that is the same but for other keys of [sliding] than the kind
  /// of uplift; else null. Throws what was thrown while the space was made.
  std::unique_ptr<SlidingSpace> space_for(const Simulation& simulation);

 private:
  std::shared_ptr<const Simulation> simulation_;
  std::promise<void> assembled_;
  std::future<std::unique_ptr<SlidingSpace>> space_;
  std::shared_future<void> left_mesh_;
};

/// Begins where another core is free and the loads exceed the friction: then a bonded caisson most likely reaches its
/// friction, and the space will be asked for. Else null. The simulation has room for a basis, which is made here.
std::shared_ptr<SlipAhead> slip_ahead(const Simulation& simulation);

/// The space of that scene: what was begun, which may be null, or made now; both are the same. Where the simulation has
/// room, the bonded basis is taken from there, and what slip adds to it is left there.
std::unique_ptr<SlidingSpace> sliding_space(const Simulation& simulation, SlipAhead* begun);

/// At the end of its scope no other thread reads the mesh.
struct MeshLeft {
  const SlipAhead* ahead;  ///< may be null
  ~MeshLeft() {
    if (ahead != nullptr) ahead->leave_mesh();
  }
};

}  // namespace upbead
