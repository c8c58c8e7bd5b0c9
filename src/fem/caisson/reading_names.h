// Names of the caisson's readings.
#pragma once

namespace upbead {

/// Names of readings that other code looks up.
namespace reading {
inline const char* const force = "force";                              ///< P, horizontal load on the caisson
inline const char* const force_vertical = "force_vertical";            ///< vertical load on the caisson, upward
inline const char* const water_force = "water_force";                  ///< P_water, of the modelled water
inline const char* const water_force_front = "water_force_front";      ///< its part on faces that look seaward
inline const char* const shear_force = "shear_force";                  ///< F_T by route (ii), the ground's reaction
inline const char* const inertia_force = "inertia_force";              ///< P + P_water - F_T = m x_G'' in balance
inline const char* const shear_by_inertia = "shear_force_by_inertia";  ///< F_T by route (i), P + P_water - m x_G''
inline const char* const normal_force = "normal_force";
inline const char* const base_moment = "base_moment";
inline const char* const uplift = "uplift";                ///< integral of the excess pore pressure over the bottom
inline const char* const uplift_moment = "uplift_moment";  ///< its moment about the middle of the bottom
inline const char* const displacement_x = "caisson/displacement_x";
inline const char* const velocity_x = "caisson/velocity_x";
inline const char* const rotation = "caisson/rotation";
}  // namespace reading

}  // namespace upbead
