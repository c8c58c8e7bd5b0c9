#include "expected/storm_climate.h"

#include <algorithm>
#include <boost/math/distributions/extreme_value.hpp>
#include <boost/math/distributions/poisson.hpp>
#include <boost/math/distributions/weibull.hpp>
#include <cmath>

#include "base/constants.h"
#include "upbead/waves/random_breaking.h"

namespace upbead {

namespace {
constexpr double least_height = 0.01;  // m; a calm year is no error
}  // namespace

double deep_water_height(const StormClimate& c, double u) {
  const double height = c.kind == ExtremeKind::weibull
                            ? c.location + quantile(boost::math::weibull(c.shape, c.scale), u)
                            : quantile(boost::math::extreme_value(c.location, c.scale), u);
  return std::max(height, least_height);
}

double tide_level(const StormClimate& c, double u) {
  const double part = c.tide == TideKind::uniform ? u : 0.5 * (1. - std::cos(pi * u));
  return c.tide_low + part * (c.tide_high - c.tide_low);
}

double number_of_storms(const StormClimate& c, double years, double u) {
  const double mean = c.per_year * years;
  if (!c.poisson) return std::floor(mean) + (u < mean - std::floor(mean) ? 1. : 0.);
  using Up =
      boost::math::policies::policy<boost::math::policies::discrete_quantile<boost::math::policies::integer_round_up>>;
  return quantile(boost::math::poisson_distribution<double, Up>(mean), u);
}

SeaState storm_on(const Section& section, const Water& water, const StormClimate& c, double u_height, double u_tide) {
  SeaState sea;
  const double deep = deep_water_height(c, u_height);
  sea.water_level = tide_level(c, u_tide);
  sea.period = c.period ? *c.period : std::sqrt(2. * pi * deep / (water.gravity * c.steepness.value()));
  sea.angle = c.angle;
  sea.waves = c.duration / sea.period;
  sea.significant_height =
      design_heights({deep, sea.period, section.water_depth + sea.water_level, section.bed_slope}, water.gravity)
          .significant;
  return sea;
}

}  // namespace upbead
