// A reduced system one of whose coordinates slips under dry friction: one modal model for every phase of the motion.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "dynamics/contact.h"
#include "upbead/dynamics/modal_model.h"
#include "upbead/dynamics/reduced_system.h"
#include "upbead/system/system.h"

namespace upbead {

/// Names of the load and the readings that add_slip() adds.
namespace slip_name {
inline const char* const friction = "interface/friction";       ///< F_T (N/m)
inline const char* const slip = "interface/slip";               ///< s (m)
inline const char* const velocity = "interface/slip_velocity";  ///< s' (m/s)
}  // namespace slip_name

/// Turns the free unknown `slip`, the residual of whose row is -F_T, into a slip: adds F_T as the last load, -1 on
/// that row, and s and s' as the last readings. Both must be there when the system is reduced, with s among the
/// unknowns that are kept exactly.
void add_slip(System& system, int slip);

/// Coulomb's law, and the readings that are wanted.
struct SlipLaw {
  double friction = 0.;                              ///< mu
  std::vector<std::pair<int, double>> normal_force;  ///< readings, weighted: change of N' (N/m), compression positive
  std::vector<int> readings;                         ///< other readings that are wanted
};

/// The motion in one phase, from any state in energy coordinates (state_space.h).
struct SlipPhase {
  /// Loads: those of the reduced system without F_T, then N_0, the part of N' that is known beforehand: W' minus a
  /// prescribed uplift (N/m). Readings: F_T, N', s', then those wanted, where a position is without its share of s.
  /// Pairs of modes come before real ones.
  ModalModel modes;
  Eigen::MatrixXd to_state;    ///< N x 2M: the state of [Re z; Im z]
  Eigen::MatrixXd from_state;  ///< 2M x N; of the stuck phase without the last state, which is s' alone
};

/// Rows of the readings of a SlipPhase.
enum SlipReading : int { row_shear = 0, row_normal = 1, row_velocity = 2, first_row_wanted = 3 };

struct SlipModel {
  std::array<SlipPhase, 4> phases;  ///< by ContactState of the bottom
  Eigen::VectorXd share_of_slip;    ///< of the readings wanted: each is its row plus this share times s
  double friction = 0.;             ///< mu
  double growth = 0.;               ///< largest real part of a pole under friction, if above round-off (1/s)
  double damping_time = 0.;         ///< beta of the damping beta K that prevents flutter of fast modes (s)

  const SlipPhase& phase(ContactState contact) const { return phases[static_cast<std::size_t>(contact)]; }
  int n_loads() const { return phases[0].modes.n_loads(); }  ///< with N_0
};

/// With w' = ... - c F_T and s' = c.w in energy coordinates, and s the last coordinate, c has only its last entry:
///
///   stuck     the last state is zero, and its equation gives F_T; A has lost its row and column, still A + A^T <= 0;
///   slipping  F_T = +-mu N', N' = N_0 + n.s + g F_T, so F_T = kappa (N_0 + n.s) with kappa = +-mu / (1 -+ mu g): each
///             direction closes a loop of its own;
///   lifted    kappa = 0.
///
/// All phases have the same states, with s.s/2 the stored energy, so that a change of phase keeps the states: it is a
/// dense map between modal coordinates. A rigid motion of the upper body that K~ does not see has no strain, but a
/// pole at zero and a velocity; s itself is no state but the integral of s', so no Jordan block arises. A closed loop
/// is not dissipative in form: real parts up to 1e-9 of |A| are round-off and set to zero; larger ones mean that
/// friction feeds a motion through N' (flutter).
///
/// Flutter of fast modes: a pole sigma + i omega of the loop needs damping of the ratio sigma/omega to come to rest,
/// and damping beta K has the ratios beta omega/2, so beta = 2 sigma/omega^2. Modes beyond the load's band are not
/// those of the ground (a Krylov space holds their compliance, not their shapes), and no ground is without damping:
/// beta K, with twice that beta, is added to C as long as its ratio at s_0, the frequency of the load, stays within
/// 0.5 %. Poles that need more belong to the ground and its friction: they are kept and reported (`growth`).
/// `damping_time`: the least beta (s).
///
/// Throws NumericsError where 1 -+ mu g <= 0 (then slip is not well posed: friction produces more than its own normal
/// force), where s' depends directly on what a load prescribes, where a reading wanted drifts with more than s, and
/// as state_space() does; std::invalid_argument where there is no friction, or `reduced` lacks what add_slip() adds.
SlipModel slip_model(const ReducedSystem& reduced, const SlipLaw& law, double damping_time = 0.);

/// The motions that make up all phases, to compare reduced systems: the stuck motion under the loads, and the free
/// motion under the loads and F_T, side by side. Loads: those of the reduced system, F_T the last. Readings: F_T and
/// F_T + N' of the stuck motion, s' of the free motion, and N' of the free motion plus both F_T. So an error of N' is
/// compared with the forces that it limits, and not with N' itself, which is zero where all is symmetric. Throws as
/// slip_model() does.
ModalModel stuck_and_free(const ReducedSystem& reduced, const SlipLaw& law);

}  // namespace upbead
