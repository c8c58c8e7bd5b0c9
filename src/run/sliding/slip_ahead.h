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

/// A scene with its interface, and the space for its reduction. The simulation's scene must outlive it.
class SlidingSpace {
 public:
  SlidingSpace(const Simulation& simulation, AssembledScene assembled);
  /// Of a member of a family of soils that has a system for it.
  explicit SlidingSpace(const Simulation& simulation);
  SlipReduction reduce(const Series& bonded, const std::function<void(double)>& progress) {
    return space_.reduce(bonded, progress);
  }

 private:
  AssembledScene assembled_;
  SlipSpace space_;
};

/// Makes a SlidingSpace, either on another core while the bonded caisson is solved, or when it is asked for; the
/// space is the same in both cases.
class SlipAhead {
 public:
  /// Makes the space only when it is asked for.
  SlipAhead() = default;
  /// Makes it then, too, unless begin() is called.
  explicit SlipAhead(std::shared_ptr<const Simulation> simulation) : simulation_(std::move(simulation)) {}
  SlipAhead(const SlipAhead&) = delete;
  SlipAhead& operator=(const SlipAhead&) = delete;
  ~SlipAhead();

  /// Begins where another core is free and the loads exceed the friction: then a bonded caisson most likely reaches its
  /// friction, and the space will be asked for.
  void begin();
  /// Returns once the mesh is no longer read here: deal.II marks cells while it numbers unknowns, so that no other
  /// thread may go through the cells meanwhile.
  void leave_mesh() const;
  /// The space of that scene; what was begun for the same one, or one that differs in other keys of [sliding] than the
  /// kind of uplift, is given away at the first call. Throws what was thrown while the space was made.
  std::unique_ptr<SlidingSpace> space(const Simulation& simulation);

 private:
  std::shared_ptr<const Simulation> simulation_;
  std::promise<void> assembled_;
  std::future<std::unique_ptr<SlidingSpace>> space_;
  std::shared_future<void> left_mesh_;
};

}  // namespace upbead
