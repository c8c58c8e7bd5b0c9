// The waves of a calibration, and its breakwater at the size of a model.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "design/design_tables.h"
#include "expected/dynamic_law.h"

namespace upbead {

/// One wave on one mound.
struct FamilyWave {
  double height = 0., period = 0., wavelength = 0.;  ///< H (m), T (s), L (m)
  double berm_depth = 0., berm_width = 0.;           ///< d, B_M (m)
  double alpha_I = 0., alpha_star = 0.;
};

struct Family {
  std::vector<FamilyWave> waves;            ///< at the size of [section]
  std::size_t n_grid = 0;                   ///< of the whole grid
  std::map<std::string, std::size_t> left;  ///< waves left out, by why; each counts once
};

/// The grid of [calibration], without what is beyond the formulas: H/h above 0.8 and waves above Miche's limit as in
/// `waves` (validity.h), steepness outside the limits, berms below the caisson's bottom or the bed.
Family make_family(const DesignTables& tables);

/// Lengths times `scale`, weights times its square.
Section scaled(const Section& section, double scale);
/// The same with times by its root.
FamilyWave scaled(FamilyWave wave, double scale);

/// The section with the mound of a wave of the same size.
Section with_mound(Section section, const FamilyWave& wave);

/// H_1/3 = H/1.8, which tells where h_b is taken.
SeaState sea_state(const FamilyWave& wave);

}  // namespace upbead
