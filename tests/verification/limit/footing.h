// A rigid strip on ground that fails: graded cells, settlement prescribed, its forces read.
#pragma once

#include <vector>

#include "fem/static_march.h"
#include "material/mohr_coulomb_law.h"

namespace upbead::test {

struct Footing {
  MohrCoulombStrength soil;
  double unit_weight = 0.;  ///< gamma (N/m3)
  double surcharge = 0.;    ///< q beside the footing (Pa)
  double shear_modulus = 1e7, poissons_ratio = 0.3;
  double width = 6., depth = 4.;       ///< of the ground (m) from the middle; the footing is 1 m wide
  double edge = 0.02;                  ///< size of the cells at its edge (m)
  double growth = 1.3, largest = 0.3;  ///< of cells from there, up to that size (m)
  double near = 1.5, below = 1.;       ///< as far from the edge, and as deep; beyond cells grow on (m)
  int degree = 2;
  double settlement = 0.05;  ///< m
  double K0 = 1.;            ///< horizontal over vertical stress before
  double sideways = 0.;      ///< horizontal displacement over settlement; needs the whole footing
};

struct FootingAnswer {
  std::vector<double> settlement, load, shear;  ///< V and H over the width (Pa)
  StaticReport report;
  int unknowns = 0;
  double seconds = 0.;
};

/// Rough; half of it where it moves straight down.
FootingAnswer push(const Footing& footing);

}  // namespace upbead::test
