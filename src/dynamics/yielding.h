// Marching a system whose soil may yield.
#pragma once

#include <memory>

#include "system/internal_force.h"
#include "upbead/dynamics/scheme.h"

namespace upbead {

/// Counts of the non-linear solves of a march.
struct YieldingReport {
  int stages = 0;
  int evaluations = 0;     ///< of the internal force; one per stage in which nothing yields
  int cut_steps = 0;       ///< steps that were halved, as a stage did not converge
  double dissipated = 0.;  ///< by the internal force (J/m)
};

struct YieldingOptions {
  /// Tolerable residual of the equation of motion, as a share of the largest norm so far of the soil's forces or of
  /// the loads; before any of these, of what moved boundaries exert on ground at rest. It is no share of p, which grows
  /// without end where soil flows, as K x does.
  double tolerance = 1e-6;
  bool refined = false;  ///< see SchemeOptions
  /// Norm of the weights that the soil bears at rest (N/m): a millionth of it is the least scale of the tolerance, as
  /// the soil's forces are differences from those at rest, with their round-off.
  double weight = 0.;
};

/// Scheme for a system with an internal force, "yielding": three stages of one L-stable tableau of order 2, whose
/// times ascend within the step. Each stage is a fixed point of the internal force, by Anderson mixing on the elastic
/// factorisation: p -> p(x(E^-1 (rhs + p))). Where nothing yields p is zero and the result is that of the elastic
/// system. Every stage starts from the soil's history at the beginning of the step; the end of the step becomes the
/// new history. A step in which a stage does not converge is halved, up to ten times; after that NumericsError gives
/// the time. Its report is Scheme::yielding().
///
/// Where the system has an interface, "yielding, contact": its nodes slip and open by the law of make_contact_scheme,
/// decided for every p on the way, so that at the fixed point of a stage both laws hold. Order 2 while no node closes;
/// four steps of order 1 where one does. Then Scheme::contact() reports as well, and no checkpoints are kept.
///
/// Where the system is divided, each process has the whole p and decides alike; then no checkpoints are kept, either.
///
/// `force` outlives the scheme.
std::unique_ptr<Scheme> make_yielding_scheme(const System& system, InternalForce& force,
                                             const YieldingOptions& options = {});

}  // namespace upbead
