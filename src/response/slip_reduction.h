// The reduced model of a scene whose caisson may slip.
#pragma once

#include <functional>
#include <memory>

#include "dynamics/growing_model.h"
#include "dynamics/slip_basis.h"
#include "fem/compile.h"
#include "response/slip_law.h"
#include "upbead/dynamics/reduce.h"

namespace upbead {

/// A scene in a few coordinates, one of them s, and its errors.
struct SlipReduction {
  ReducedSystem system;  ///< of with_rigid_slip() with the load and the readings of add_slip()
  /// Difference between nested models: of F_T and N' of the caisson that sticks, and of s' and N' of one that slips
  /// freely, under all loads with F_T, and under each load alone. About the error of the smaller model.
  NestedError error;
  double bonded_error = 0.;  ///< largest difference between F_T while it sticks and the bonded history, over the peak
  bool converged = false;    ///< also where the space is exhausted
  int n_vectors = 0, n_solves = 0;
  double factorise_seconds = 0.;
};

/// The system of a scene whose caisson slips as a whole, with_rigid_slip() and add_slip(), and the unknowns that are
/// kept exactly, s the last of them. Beside the bonded scene only its row of s counts, see slip_row().
struct SlipSystem {
  System system;
  std::vector<int> exact;
};
/// Of a scene compiled with its interface. Throws std::invalid_argument where there is none.
SlipSystem slip_system(const CompiledScene& compiled);

/// How a scene that slips is reduced, with the training of reduce_slip(); the basis is given.
ReduceOptions slip_options(const Scene& scene, const CompiledScene& compiled, UpliftKind uplift, const Series& bonded);

/// The bonded basis of a scene, and the slip beside it, for all that slides on that scene. `bonded`: of the basis that
/// the scene was reduced in, about krylov_shift() with the body's coordinates exact; null: one is made now.
std::shared_ptr<SlipBasis> slip_basis(const Scene& scene, const CompiledScene& compiled, const SlipSystem& slips,
                                      std::shared_ptr<GrowingBasis> bonded = nullptr);

/// The space of such a reduction: the part that needs no bonded history, and may be made before there is one.
class SlipSpace {
 public:
  /// `compiled`: the bonded scene. Scene and compiled scene must outlive the object. Throws as reduce_slip() does.
  SlipSpace(const Scene& scene, const CompiledScene& compiled, UpliftKind uplift, std::shared_ptr<SlipBasis> basis);
  SlipSpace(const Scene& scene, const CompiledScene& compiled, const SlipSystem& slips, UpliftKind uplift);
  /// See SlipBasis::prepare().
  void prepare() { basis_->prepare(); }
  const std::shared_ptr<SlipBasis>& basis() const { return basis_; }
  /// See reduce_slip(). To be called once.
  SlipReduction reduce(const Series& bonded, const std::function<void(double)>& progress);

 private:
  const Scene& scene_;
  const CompiledScene& compiled_;
  std::shared_ptr<SlipBasis> basis_;
  GrowingModel model_;
};

/// Reduces a scene with an interface for its loads, F_T and s, at krylov_shift(), to its tolerance.
/// - compiled: with the interface, on one process.
/// - bonded: what the caisson's bonded twin reads, all readings of the system in their order; trains the model with F_T
///   cut off at 0.7 of its peak, and is compared with. Times ascend from 0.
/// - progress: called with 0 to 1 after every solve.
/// Throws NumericsError as reduce_scene() does, std::invalid_argument where there is no interface or no shear force.
SlipReduction reduce_slip(const Scene& scene, const CompiledScene& compiled, UpliftKind uplift, const Series& bonded,
                          const std::function<void(double)>& progress = {});

}  // namespace upbead
