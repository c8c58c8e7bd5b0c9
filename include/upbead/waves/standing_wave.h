// The standing wave of finite height before an upright wall, and the pressures of its crest and trough on the wall; for
// waves that do not break.
#pragma once

#include <memory>
#include <vector>

#include "upbead/waves/goda.h"

namespace upbead {

/// A wave that an upright wall reflects completely, on a flat bed.
struct StandingWaveGiven {
  double depth = 0.;   ///< h (m)
  double height = 0.;  ///< H of the incident wave (m): at the wall, crest and trough differ by 2H
  double period = 0.;  ///< T (s)
};

struct StandingSeries;
struct StandingInstant;

/// A standing wave at one time: what its places share is found once.
class StandingMoment {
 public:
  StandingMoment(const StandingSeries& series, double depth, double tau, double unit_weight);

  double surface(double x = 0.) const;  ///< eta above still water (m), x (m) seaward of the wall
  /// Change from the pressure in still water (Pa), at the height y above still water, x (m) seaward of the wall. Where
  /// there is no water the pressure is zero, and this change is rho g y below still water and 0 above.
  double pressure(double y, double x = 0.) const;

 private:
  std::shared_ptr<const StandingInstant> instant_;
  double k_, unit_weight_, at_wall_;
};

/// Potential flow by the full equations, as double Fourier series of surface and potential with unknown coefficients
/// and unknown wave number: standing_series.h (after Vanden-Broeck and Schwartz, Phys. Fluids 24 (1981) 812-815, and
/// Tsai and Jeng, Appl. Ocean Res. 16 (1994) 185-193). The crest stands at the wall at t = 0, the trough at T/2.
class StandingWave {
 public:
  /// Throws std::invalid_argument unless all numbers are positive; NumericsError where no such wave is found: it
  /// breaks, or the water is so shallow that the series do not converge. `lower`: a wave found before, or nullptr;
  /// where its depth and period are the same, and it is not higher, the search begins with it. That halves the time,
  /// and changes no more than the last step of its search.
  StandingWave(const StandingWaveGiven& given, const Water& water, const StandingWave* lower = nullptr);

  double wavelength() const;  ///< L (m), which depends on H
  int harmonics() const;      ///< largest, in space and in time
  /// Largest residual of the two conditions at the surface, between the points where they are satisfied: a head of
  /// water over 2H, a velocity over 2H omega. At most 1e-3.
  double residual() const;
  double period() const { return given_.period; }
  StandingMoment at(double time) const;
  double surface(double time, double x = 0.) const { return at(time).surface(x); }                 ///< as there
  double pressure(double y, double time, double x = 0.) const { return at(time).pressure(y, x); }  ///< as there

 private:
  StandingWaveGiven given_;
  Water water_;
  std::shared_ptr<const StandingSeries> series_;
};

/// Pressures of a standing wave on a caisson. They act on its front from the bottom to the crest, which higher water
/// overtops, and on its bottom as Goda's triangle with the pressure at the toe. Suction under the bottom,
/// p_u < 0, is not in U.
struct WallPressure {
  double time = 0.;           ///< s
  double surface = 0.;        ///< eta at the wall (m)
  double force = 0.;          ///< P, landward (N/m)
  double force_moment = 0.;   ///< M_P about the bottom's level, of the sign of P (N m/m)
  double edge_pressure = 0.;  ///< p_u, at the bottom's seaward edge (Pa); negative: suction
  double uplift = 0.;         ///< U = max(p_u, 0) B/2 (N/m)
};
WallPressure wall_pressure(const StandingWave& wave, const Section& section, double time);

/// The largest and the least P of a period.
struct StandingExtremes {
  WallPressure landward;           ///< P largest; of two equal maxima the first
  WallPressure seaward;            ///< P least
  double crest = 0., trough = 0.;  ///< of the surface at the wall, above still water (m)
};
StandingExtremes standing_extremes(const StandingWave& wave, const Section& section);

/// Heights above still water, ascending, from the bottom to the crest of the caisson or of the wave. Pressures at these
/// heights, linear between them, have the force and the moment of wall_pressure().
std::vector<double> wall_heights(const StandingWave& wave, const Section& section);
/// The pressures at wall_heights() (Pa).
std::vector<double> wall_pressures(const StandingWave& wave, const std::vector<double>& heights, double time);

}  // namespace upbead
