// Numbers of the summary that are taken from a response.
#pragma once

#include <array>
#include <optional>
#include <string>

namespace upbead {

/// Forces on a caisson and its motion. Peaks are signed: landward positive (SI, per metre of breakwater).
struct ShearResponse {
  double peak_force = 0., peak_force_time = 0.;                  ///< largest P, landward (N/m, s)
  double peak_force_seaward = 0., peak_force_seaward_time = 0.;  ///< least P
  double impulse = 0.;                                           ///< integral of P over the march (N s/m)
  double peak_shear = 0., peak_shear_time = 0.;                  ///< largest F_T, landward (N/m, s)
  double peak_shear_seaward = 0., peak_shear_seaward_time = 0.;  ///< least F_T
  double peak_shear_paper = 0.;                                  ///< largest P - m x_G'' (the paper's reading)
  double peak_shear_experiment = 0.;  ///< largest P + P_water,front - m x_G'' (what its experiment evaluates)
  /// Peak F_T / peak P, both landward, or both seaward where the largest |P| is seaward; none where P is 0 throughout.
  std::optional<double> shear_to_force_ratio;
  std::optional<double> shear_to_impulse;  ///< the same peak F_T / impulse (1/s); none where the impulse is round-off
  double peak_displacement = 0.;           ///< largest x_G, landward (m)
  /// x_G of largest magnitude, with its sign (m), and when (s)
  double largest_displacement = 0., largest_displacement_time = 0.;
  double peak_rotation = 0., largest_rotation = 0.;        ///< largest rotation landward, of largest magnitude (rad)
  std::optional<double> arm;                               ///< of P above the bottom when P is largest (m)
  double peak_base_moment = 0., largest_base_moment = 0.;  ///< landward, of largest magnitude (N m/m)
  double reaction_mismatch = 0.;  ///< largest difference between the two routes to F_T, see require_balance
};

/// A free vibration: exp(-damping_ratio |p| t) sin(2 pi t / period), p its pole.
struct NaturalPeriod {
  double period = 0.;         ///< 2 pi / |Im p| (s)
  double damping_ratio = 0.;  ///< -Re p / |p|
  double share = 0.;          ///< in F_T under the scene's loads
};

/// Differences between a computed and a measured history, over the times that both cover.
struct Comparison {
  double peak_measured = 0.;  ///< of largest magnitude
  double peak_computed = 0.;  ///< largest in the direction of that peak
  double peak_ratio = 0.;     ///< computed over measured
  double rms = 0.;            ///< root of the mean square of the difference
  double rms_relative = 0.;   ///< rms over the root mean square of the measured history
  double phase = 0.;          ///< delay of the computed history at which both correlate best (s)
};

/// Effect of cycles of shear on a region that packs denser. The pressure ratio is the loss of mean effective stress
/// over the mean effective stress at rest; where the total stress stays constant, the loss is the excess pore pressure.
struct CompactedSoil {
  std::string region;
  double mean = 0.;                                 ///< volumetric strain, mean over the area
  double largest = 0.;                              ///< volumetric strain, largest
  std::array<double, 2> at{0., 0.};                 ///< where that is (m)
  double largest_amplitude = 0.;                    ///< of shear strain in a half cycle
  int reversals = 0;                                ///< in the cell with most
  double largest_pressure_ratio = 0.;               ///< at any time, from 0 to 1
  std::array<double, 2> pressure_ratio_at{0., 0.};  ///< where that is (m)
  double pressure_ratio_at_end = 0.;                ///< the largest at the end of the march
  double share_liquefied = 0.;                      ///< share of the area where the ratio reached 0.95
  double left_out = 0.;  ///< share of the area, where the stress at rest is below a tenth of the region's mean
  std::optional<double> pressure_at_end;  ///< largest excess pore pressure (Pa); none where it is drained
  double energy = 0.;                     ///< taken by compaction, a part of EnergyAccount::plastic (J/m)
};

/// How much of a region's Mohr-Coulomb strength the sum of static and dynamic stresses mobilises. The mobilisation of a
/// cell, at its middle, is r / (c cos phi + s sin phi), r the radius and s the middle of Mohr's circle of effective
/// stresses in the plane: 1 where the circle touches the straight line of Coulomb. It is limited to 10, which also
/// stands for stresses beyond the tip of the cone.
struct MobilisedStrength {
  std::string region;
  double initial = 0.;               ///< largest at rest
  double initial_share = 0.;         ///< share of the area where it exceeds 1 at rest
  double largest = 0.;               ///< largest at any time
  std::array<double, 2> at{0., 0.};  ///< where that is (m)
  double time = 0.;                  ///< and when (s)
  double share = 0.;                 ///< share of the area where it exceeded 1 at some time
  double left_out = 0.;  ///< share of the area where s at rest is below a tenth of the region's mean: free surfaces
};

/// A reading that does not meet its tolerance, and the difference of the nested models in it, over its peak.
struct InexactReading {
  std::string name;
  double error = 0.;
};

}  // namespace upbead
