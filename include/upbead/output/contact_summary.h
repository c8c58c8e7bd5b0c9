// The object `contact` of summary.json, and the histories of the nodes at the caisson's bottom.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace upbead {

/// How near the glued caisson comes to slipping or lifting, at the node where it comes nearest.
struct GluedDemand {
  double slip = 0.;          ///< largest |T_i| / (mu N_i); infinite (told as null) where a node pulls
  double least_normal = 0.;  ///< least N_i over N_i at rest; below 0 a node pulls
  double margin = 0.;        ///< of both, for errors of the forces: 0 where it was marched
  bool reached = false;      ///< whether one of them comes to its limit within the margin
};

/// What the bottom did, node by node.
struct NodeContact {
  double slip = 0.;                      ///< mean over the bottom in the end, landward: S (m)
  std::optional<double> error_estimate;  ///< of it (m); none where the case does not ask for one
  double largest_slip = 0.;              ///< mean over the bottom, of largest magnitude on the way (m)
  double least_slip = 0.;          ///< in the end, of the node that slipped least: so far the whole bottom has gone (m)
  double opening_seaward = 0.;     ///< largest, of the seaward end (m)
  double opening_landward = 0.;    ///< largest, of the landward end (m)
  double least_contact = 1.;       ///< least share of the bottom's width that is in contact
  double least_normal_force = 0.;  ///< least sum of N_i (N/m)
  std::optional<double> first_slip;    ///< when a node first slips (s)
  std::optional<double> first_open;    ///< when a node first opens (s)
  double dissipated = 0.;              ///< energy that friction took (J/m)
  int slip_steps = 0, open_steps = 0;  ///< steps in which a node slipped, was open
  int impacts = 0;                     ///< how often a node closed
  int fallbacks = 0;                   ///< contact problems that took the slow way
};

struct ContactSummary {
  double friction = 0.;  ///< mu
  double weight = 0.;    ///< sum of N_i at rest (N/m)
  int nodes = 0;
  GluedDemand demand;
  std::optional<NodeContact> solved;  ///< none where the glued solution obeys the law
};

/// At the ends of the steps; N by step and node, row by row.
struct ContactHistory {
  std::vector<double> position, length;           ///< of the nodes (m)
  std::vector<double> time;                       ///< s
  std::vector<double> slip, opening;              ///< m
  std::vector<double> shear_force, normal_force;  ///< T_i, landward on the ground, and effective N_i (N/m)
};

}  // namespace upbead
