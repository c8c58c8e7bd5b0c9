// The reduced space of a caisson that slips, made beside the bonded caisson on another core.
#pragma once

#include <future>
#include <memory>
#include <string>

#include "fem/compile.h"
#include "response/slip_reduction.h"
#include "upbead/run/simulation.h"

namespace upbead {

/// Why such a slip cannot be told of a scene with a caisson; "" where it can.
std::string why_no_slip(const Simulation& simulation);

/// What N' is without, by [sliding].
UpliftKind slip_uplift(const SlidingChoice& choice);

/// A scene with its interface, and what its slip is reduced by. The simulation's scene must outlive it.
class SlidingSpace {
 public:
  SlidingSpace(const Simulation& simulation, AssembledScene assembled);
  SlipReduction reduce(const Series& bonded, const std::function<void(double)>& progress) {
    return space_.reduce(bonded, progress);
  }

 private:
  AssembledScene assembled_;
  SlipSpace space_;
};

/// Makes a SlidingSpace while others solve the bonded caisson, or when it is asked for; it is the same in both cases.
class SlipAhead {
 public:
  /// Makes it when it is asked for.
  SlipAhead() = default;
  /// Begins at once where another core is free and the loads are larger than what friction holds: then a bonded caisson
  /// most likely reaches its friction, and the space will be asked for. The simulation must outlive it.
  explicit SlipAhead(const Simulation& simulation);
  SlipAhead(const SlipAhead&) = delete;
  SlipAhead& operator=(const SlipAhead&) = delete;
  ~SlipAhead();

  /// Returns when the mesh is read no more: deal.II marks cells while it numbers unknowns, so that nobody else may go
  /// through them meanwhile.
  void leave_mesh() const;
  /// To be called once, with the same scene. Throws what making it threw.
  std::unique_ptr<SlidingSpace> space(const Simulation& simulation);

 private:
  std::promise<void> assembled_;
  std::future<std::unique_ptr<SlidingSpace>> space_;
  std::shared_future<void> left_mesh_;
};

}  // namespace upbead
