// Small-amplitude waves: how long they are.
#pragma once

namespace upbead {

/// kh with k = 2 pi / L, from omega^2 h / g = kh tanh(kh), to round-off at any depth.
/// `depth` h in m, `period` T in s, both above 0.
double relative_wave_number(double period, double depth, double gravity);

/// L at that depth (m).
double wavelength(double period, double depth, double gravity);

/// L_0 = g T^2 / (2 pi) (m).
double deep_water_wavelength(double period, double gravity);

}  // namespace upbead
