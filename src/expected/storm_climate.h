// Storms of a life from the statistics of extreme waves in deep water.
#pragma once

#include <optional>

#include "upbead/expected/sea_state.h"
#include "upbead/waves/section.h"

namespace upbead {

enum class ExtremeKind {
  weibull,  ///< F(x) = 1 - exp(-((x - location)/scale)^shape)
  gumbel,   ///< F(x) = exp(-exp(-(x - location)/scale))
};

enum class TideKind {
  sinusoidal,  ///< a storm meets any phase of a sinusoidal tide
  uniform,     ///< any level between the two
};

struct StormClimate {
  ExtremeKind kind = ExtremeKind::weibull;  ///< of H_0', the equivalent deep-water significant height of a storm
  double location = 0.;                     ///< m
  double scale = 0.;                        ///< m
  double shape = 1.;                        ///< of weibull
  double per_year = 1.;                     ///< storms
  bool poisson = false;                     ///< their number is random; else always the same
  double duration = 7200.;                  ///< s
  std::optional<double> period;             ///< T (s); or from steepness
  std::optional<double> steepness;          ///< H_0'/L_0, which makes T = sqrt(2 pi H_0' / (g steepness))
  double angle = 0.;                        ///< beta (rad)
  double tide_low = 0., tide_high = 0.;     ///< still water above that of the section (m)
  TideKind tide = TideKind::sinusoidal;
};

/// H_0' (m) that a share u of the storms stays below; at least 1 cm.
double deep_water_height(const StormClimate& climate, double u);
/// The level (m) that a share u of the storms stays below.
double tide_level(const StormClimate& climate, double u);
/// The least n such that a share u of all lives has at most n storms.
double number_of_storms(const StormClimate& climate, double years, double u);

/// A storm on the section: H_1/3 by random breaking [Goda 2000] in the depth h that the tide makes, duration/T waves.
SeaState storm_on(const Section& section, const Water& water, const StormClimate& climate, double u_height,
                  double u_tide);

}  // namespace upbead
