// Stability of a section in a standing wave of finite height: landward at the crest, seaward in the trough.
#pragma once

#include <optional>
#include <string>

#include "upbead/waves/standing_wave.h"

namespace upbead {

/// By the section's own W', mu and t; in the trough about the seaward edge, without suction under the base, which is
/// only in the pressure of the toe, where it is larger with it.
struct StandingAnswer {
  double wavelength = 0.;  ///< L (m)
  double residual = 0.;    ///< StandingWave::residual
  StandingExtremes worst;
  Stability landward, seaward;  ///< heel_pressure of `seaward` is that of the toe
  StandingWave wave;
};

/// A bound of the trough, where no standing wave of finite height is known: Sainflou's (1928) trough without the rise
/// of the mean level that he finds, which draws the pressure at the wall down by rho g z to the depth H, and from there
/// in a straight line by rho g H / cosh(kh) at the bed, with the wave as if it came straight at a plain wall. Over h/L
/// from 0.07 to 1.1 and H/h from 0.05 to 0.5 it is 1.08 to 2.1 times the trough of the full equations, where that
/// exists; linear waves are down to half of it: tests/waves.
struct TroughBound {
  double force = 0.;         ///< seaward (N/m)
  double force_moment = 0.;  ///< about the bottom's level (N m/m)
  Stability seaward;         ///< suction under the base as in StandingAnswer
};
TroughBound trough_bound(const Section& section, const Water& water, const DesignWave& wave, double factor = 1.);

/// The answer, or why there is none, and then the bound.
struct StandingResult {
  std::optional<StandingAnswer> answer;
  std::string why_not;
  std::optional<TroughBound> bound{};

  /// Of either.
  const Stability& seaward() const { return answer ? answer->seaward : bound->seaward; }
};

/// For a wave that comes straight at a plain wall, on a flat bed without the mound. All its forces are multiplied by
/// `factor`, as those of a load are. `lower` as in StandingWave.
StandingResult standing_answer(const Section& section, const Water& water, const DesignWave& wave, double factor = 1.,
                               const StandingWave* lower = nullptr);

}  // namespace upbead
