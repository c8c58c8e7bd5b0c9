#include "upbead/material/elastic_law.h"

namespace upbead {

ElasticLaw elastic_law(double shear_modulus, double poissons_ratio) {
  return {shear_modulus, 2. * shear_modulus * poissons_ratio / (1. - 2. * poissons_ratio)};
}

std::array<std::array<double, 3>, 3> ElasticLaw::tangent() const {
  return {{{lambda + 2. * G, lambda, 0.}, {lambda, lambda + 2. * G, 0.}, {0., 0., G}}};
}

}  // namespace upbead
