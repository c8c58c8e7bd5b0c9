// Pressures of a caisson on its base: over time, and the worst.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "upbead/waves/edge_pressures.h"

namespace upbead {

/// Over time. N' = W' + change of the normal force - U, M' = W' e_0 + base moment + M_U about the bottom's middle,
/// overturning landward positive; U is the uplift of the computed pore pressure and a prescribed one; e_0 is the
/// distance by which W' acts landward of the middle.
struct EffectiveBase {
  double width = 0.;                          ///< B (m)
  double weight = 0., weight_moment = 0.;     ///< W' (N/m), W' e_0 (N m/m)
  double push = 0., push_moment = 0.;         ///< of still water at two levels (N/m, N m/m); its moment is in W' e_0
  std::vector<double> uplift, uplift_moment;  ///< U (N/m), M_U (N m/m)
  std::vector<double> force;                  ///< N' (N/m), compression positive
  std::vector<double> moment;                 ///< M' (N m/m)
  /// Of loads that act up or down alone, without motion: downward (N/m), and their moment (N m/m); empty: there are
  /// none.
  std::vector<double> vertical{}, vertical_moment{};
};

/// Pressures on the base at rest, and the worst at the ends of the steps; effective stress varies linearly over the
/// width in contact.
struct BaseExtremes {
  double heel_pressure_at_rest = 0., toe_pressure_at_rest = 0., eccentricity_at_rest = 0.;  ///< Pa, Pa, m
  /// Of the landward and of the seaward edge (Pa); none where the resultant leaves the base there.
  std::optional<double> peak_heel_pressure = 0., peak_toe_pressure = 0.;
  double peak_heel_pressure_time = 0., peak_toe_pressure_time = 0.;  ///< when, or when the resultant first leaves (s)
  /// When an edge first has no pressure, stress being linear: from then on a base that cannot pull parts from its mound
  /// there (s); none where both edges always press.
  std::optional<double> lifts_time;
  std::string lifts;                                                 ///< that edge: seaward, landward, or all
  double largest_eccentricity = 0., largest_eccentricity_time = 0.;  ///< of largest magnitude, landward (m)
  double least_normal_force = 0., least_normal_force_time = 0.;      ///< N' (N/m)
  /// Least ratio of the moments that hold the caisson up to those that overturn it, about either edge; none where
  /// nothing overturns.
  std::optional<double> least_overturning_margin;
  double least_overturning_margin_time = 0.;
};

/// At rest, and the largest and least at the given times (s).
BaseExtremes base_extremes(const EffectiveBase& base, const std::vector<double>& time);

/// The least stress of an edge of a rigid bottom that is bonded to elastic ground.
struct EdgeStress {
  double stress = 0.;  ///< Pa, compression positive
  double force = 0., moment = 0., time = 0.;
};
EdgeStress least_edge_stress(const EffectiveBase& base, const std::vector<double>& time);
/// What it says where it is tension.
std::string lifts_text(const EdgeStress& least);

/// The worst pressures on the base under several waves, and at rest between them.
struct WorstBase {
  static constexpr double leaves = std::numeric_limits<double>::infinity();

  double heel_pressure = 0., toe_pressure = 0.;  ///< Pa; infinity where the resultant leaves the base there
  double eccentricity = 0.;                      ///< of largest magnitude, landward (m)
  double overturning_margin = leaves;            ///< least; infinity where nothing overturns
  double edge_stress = leaves;                   ///< least of a bonded edge, tension negative (Pa); where it was sought
};
WorstBase worst_of(const BaseExtremes& extremes);
/// The worst of both, quantity by quantity.
WorstBase worst_of(const WorstBase& a, const WorstBase& b);

}  // namespace upbead
