// A rigid rough strip on ground that fails: its settlement is prescribed and its forces are read, on ever finer
// cells.
#pragma once

#include <vector>

#include "fem/static_march.h"
#include "material/mohr_coulomb_law.h"

namespace upbead::test {

struct Footing {
  MohrCoulombStrength soil;  ///< flow must be associated
  double unit_weight = 0.;   ///< gamma (N/m3)
  double surcharge = 0.;     ///< q beside the footing (Pa)
  double shear_modulus = 1e4, poissons_ratio = 0.3;
  double width = 6., depth = 4.;        ///< of the ground (m) from the middle; the footing is 1 m wide
  double cell = 0.25;                   ///< size of the cells at its edge (m), before any is split
  double growth = 1.2, largest = 0.25;  ///< growth of the cells from the edge on; size (m) of the largest
  double settlement = 0.05;             ///< m
  /// horizontal displacement over settlement; if not 0, the whole footing is modelled
  double sideways = 0.;
};

/// On undrained ground without weight, c = 1, in a domain that contains the mechanisms.
Footing on_clay();

struct FootingAnswer {
  std::vector<double> settlement, load, shear;  ///< by step (m); V and H over the width (Pa)
  std::vector<double> uneven;                   ///< by cell: see uneven_flow.h
  StaticReport report;
  int unknowns = 0;
  double seconds = 0.;
};

/// Pushes the footing, half of it if it moves straight down: once, and then `times` times on finer cells. Each time
/// the cells with 0.6 of all uneven flow are split into four. Ends with the first result that does not reach the
/// settlement.
std::vector<FootingAnswer> push(const Footing& footing, int times);

}  // namespace upbead::test
