// The impulsive pressure coefficient of Takahashi, Tanimoto and Shimosako (1994, HYDRO-PORT '94, pp. 489-504).
#pragma once

namespace upbead {

/// alpha_I1, of the mound's shape alone: its largest value 1 is at B_M/L = 0.12 and (h - d)/h = 0.6; below 0 on low
/// mounds (delta_22 < -0.3206), where no impulsive pressure is to be expected.
double alpha_I1(double berm_width_over_wavelength, double mound_height_over_depth);

/// alpha_I0 = min(H/d, 2).
double alpha_I0(double height, double berm_depth);

}  // namespace upbead
