#include "reliability/chance.h"

#include <boost/math/distributions/normal.hpp>
#include <cmath>

namespace upbead {

std::optional<double> index_of(double probability) {
  if (!(probability > 0. && probability < 1.)) return {};
  return boost::math::quantile(boost::math::complement(boost::math::normal(), probability));
}

double of_occasions(double probability, double occasions) {
  return -std::expm1(occasions * std::log1p(-probability));
}

}  // namespace upbead
