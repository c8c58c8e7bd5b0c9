// What a run found of slip: by formulas on F_T(t), as a block on the moving ground, and node by node.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "upbead/response/findings.h"
#include "upbead/sliding/history_sliding.h"

namespace upbead {

/// How near the bonded caisson comes to slipping or lifting, at the node where it comes nearest.
struct BondedDemand {
  double slip = 0.;          ///< largest |T_i| / (mu N_i); infinite (null in the file) where a node pulls
  double least_normal = 0.;  ///< least N_i over N_i at rest; below 0 where a node pulls
  double margin = 0.;        ///< of both, allowing for errors of the forces; 0 where it was marched
  bool reached = false;      ///< whether one of the two reaches its limit within the margin
};

/// The model of the ground with which contact node by node was solved.
struct ContactGround {
  int coordinates = 0;                              ///< besides the motions of the nodes
  int solves = 0;                                   ///< of the whole ground, to make it
  double slip = 0., peak_shear = 0., history = 0.;  ///< errors of S (m), and of peak F_T and F_T(t), relative
  double others = 0.;                               ///< largest of all other readings, over its peak
  std::vector<InexactReading> inexact;              ///< those that do not meet their tolerance
  double tolerance_of_others = 0.;
};

/// What the bottom did, node by node.
struct NodeContact {
  double slip = 0.;                      ///< S
  std::optional<double> error_estimate;  ///< none where the case asks for none
  double largest_slip = 0., least_slip = 0.;
  double opening_seaward = 0., opening_landward = 0.;
  double least_contact = 1., least_normal_force = 0.;
  std::optional<double> first_slip, first_open;
  double lift_energy = 0.;             ///< largest that the weight gains by openings (J/m)
  double closing_speed = 0.;           ///< largest at which an end closes (m/s)
  std::optional<double> closing_time;  ///< of that (s); none: neither end opens and closes
  std::optional<double> last_closing;  ///< since when all nodes touch (s); none: no node opened, or one is open
  double open_in_end = 0.;             ///< share of the width
  std::optional<double> gap_force;     ///< largest that the sea in gaps adds (N/m); none: they take it from the pores
  double dissipated = 0.;
  double end_velocity = 0.;             ///< in the last step, of the node that slips least then (m/s)
  int slip_steps = 0, open_steps = 0;   ///< steps in which a node slipped, was open
  int impacts = 0;                      ///< how often a node closed
  int fallbacks = 0;                    ///< contact problems that were solved by the slower method
  std::optional<ContactGround> ground;  ///< none where all unknowns were marched
};

struct ContactSummary {
  double friction = 0.;  ///< mu
  double weight = 0.;    ///< sum of N_i at rest (N/m)
  int nodes = 0;
  BondedDemand demand;
  std::optional<NodeContact> solved;  ///< none where the bonded solution obeys the law of contact
};

/// At the ends of the steps; N by step and node, row by row.
struct ContactHistory {
  std::vector<double> position, length;           ///< of the nodes (m)
  std::vector<double> time;                       ///< s
  std::vector<double> slip, opening;              ///< m
  std::vector<double> shear_force, normal_force;  ///< T_i, landward on the ground, and effective N_i (N/m)
  /// What the sea in gaps adds to a prescribed uplift: force (N/m), and moment about x = 0, overturning landward
  /// positive (N m/m), by step; empty where gaps take water from the pores alone.
  std::vector<double> gap_force, gap_moment;
};

/// S by tau_0 of eqs. (8)-(11) of Shimosako and Takahashi (1994) and the run's own F_Smax.
struct PulseSliding {
  double standing_duration = 0., factor = 0., duration = 0.;  ///< tau_0F (s), k(alpha*), tau_0 (s)
  double paper = 0.;                                          ///< S_CAL, eq. (7) (m)
  PaperParts paper_parts;                                     ///< S_1 and S_2
  double exact = 0.;                                          ///< by integrating eqs. (4) and (6) (m)
};

/// At the samples of the loads.
struct CoupledHistoryTable {
  std::vector<double> time;                       ///< s
  std::vector<double> shear_force, normal_force;  ///< F_T, N' (N/m)
  std::vector<double> velocity, slip;             ///< s' (m/s), s (m)
  std::vector<double> displacement;               ///< x_G, the slip included (m)
};

/// S of a caisson that slips as a whole, together with the motion of soil, mound and water of the scene.
struct CoupledSummary {
  Sliding slip;  ///< over the mound
  double dissipated = 0., peak_shear = 0., least_normal = 0., lifted_time = 0.;
  int vectors = 0;                      ///< 0 where the bonded caisson does not reach its friction
  double error = 0., glued_error = 0.;  ///< between nested models, and from the bonded solution
  double growth = 0.;                   ///< of the fastest vibration that friction feeds
  double damping_time = 0., damping_effect = 0.;
  double seconds = 0.;                         ///< wall time to find it
  std::optional<CoupledHistoryTable> history;  ///< where it slips
  std::optional<double> error_estimate;
};

/// The triangular pulse with the peak and the impulse of F_S.
struct EqualImpulse {
  double duration = 0., paper = 0., exact = 0.;  ///< as of PulseSliding
};

/// S by eq. (4) on F_T(t) (m), for each course that a prescribed peak of U may take.
struct UpliftCourses {
  double held = 0., in_phase = 0.;
};

/// The S to design by.
struct DesignSliding {
  double value = 0.;                     ///< m
  std::string measure;                   ///< the key of the summary that gives it
  std::string why;                       ///< this measure was chosen
  std::optional<double> error_estimate;  ///< m
  double largest = 0.;                   ///< of largest magnitude on the way, by the same measure (m)
  double end_velocity = 0.;              ///< at the end of the run (m/s)
  bool rests = true;                     ///< whether the loads at the end of the run let the caisson come to rest
  std::string why_not_all = {};          ///< why the value is not the whole distance though it rests; else ""
};

struct SlidingSummary {
  double weight = 0., submerged_weight = 0., friction = 0., drag = 0.;  ///< W, W', mu, F_D over velocity
  std::string uplift;                                                   ///< none, prescribed or computed
  HistorySliding history;
  DesignSliding design;
  std::optional<UpliftCourses> courses;       ///< where a peak of U is prescribed without its course
  std::optional<PulseSliding> pulse;          ///< where the case names a wave
  std::optional<EqualImpulse> equal_impulse;  ///< where F_S has a landward peak
  std::optional<CoupledSummary> coupled;      ///< where it could be computed
  std::string why_not_coupled;                ///< else
  bool coupled_failed = false;                ///< whether the numerics failed; false: the scene does not allow it
  std::optional<double> error_estimate;       ///< of S by eq. (4) on F_T(t) (m)
  std::string why_no_estimate;                ///< else
  double lift_of_loads = 0.;                  ///< largest force of the loads on the caisson upward (N/m)
};

}  // namespace upbead
