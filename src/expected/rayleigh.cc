#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "upbead/expected/sea_state.h"

namespace upbead {

RayleighHeights::RayleighHeights(double significant_height, double cut)
    : significant_height_(significant_height), highest_(cut * significant_height), beyond_(std::exp(-2. * cut * cut)) {
  if (!(significant_height > 0. && std::isfinite(significant_height) && cut > 0.))
    throw std::invalid_argument("heights of waves need a significant height and a cut above 0");
}

double RayleighHeights::exceedance(double height) const {
  if (height >= highest_) return 0.;
  const double x = std::max(height, 0.) / significant_height_;
  return std::exp(-2. * x * x) - beyond_;
}

double RayleighHeights::density(double height) const {
  if (height <= 0. || height >= highest_) return 0.;
  const double x = height / significant_height_;
  return 4. * x / significant_height_ * std::exp(-2. * x * x);
}

double RayleighHeights::height(double exceedance) const {
  return significant_height_ * std::sqrt(0.5 * std::max(0., -std::log(exceedance + beyond_)));
}

}  // namespace upbead
