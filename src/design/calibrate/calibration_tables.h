// The keys of [calibration], and the tables that they fill.
#pragma once

#include <map>
#include <string>

#include "../expected_tables.h"
#include "input/schema.h"
#include "number_list.h"

namespace upbead {

/// [calibration.models.NAME].
struct ScaledModel : DynamicsTable {
  double scale = 1.;  ///< length of this model's breakwater over that of [section]
};

/// [calibration]: a grid of waves and mounds, and what is asked of each.
struct CalibrationTable {
  NumberList relative_height{{0.3, 0.4, 0.5, 0.6, 0.7, 0.8}};        ///< H/h
  NumberList period;                                                 ///< T (s)
  NumberList relative_berm_depth{{0.3, 0.35, 0.4, 0.45, 0.5, 0.6}};  ///< d/h
  NumberList relative_berm_width{{0.02, 0.06, 0.12, 0.2, 0.3}};      ///< B_M/L
  NumberList ratios{{1.05, 1.2, 1.5, 2.}};                           ///< r = F_Smax/(mu W')
  Pair steepness{0.005, 0.14};                                       ///< least and largest H/L
  std::map<std::string, ScaledModel> models;
};

TableSchema<CalibrationTable> calibration_schema();

}  // namespace upbead
