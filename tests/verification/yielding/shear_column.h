// An independent computation of a column of hysteretic soil in shear, in one dimension: linear elements, lumped
// masses, explicit steps, and in each element parallel springs with sliders (Iwan 1967). It uses no code of the
// program.
#pragma once

#include <array>
#include <functional>
#include <vector>

namespace upbead::test {

struct ShearSoil {
  double G = 0.;           ///< Pa
  double gamma_r = 0.;     ///< of the hyperbola G gamma/(1 + gamma/gamma_r)
  double density = 0.;     ///< kg/m3
  double height = 0.;      ///< m
  bool absorbing = false;  ///< true: the same soil continues below, elastic; false: rock below
};

struct ShearHistory {
  std::vector<double> time, displacement, velocity;  ///< of the top
  std::vector<double> strain, stress;                ///< of a height
};

/// Stiffness and strength of springs side by side (Pa).
using Sliders = std::vector<std::array<double, 2>>;

/// Of a polygon from the origin through these points; beyond them it is constant.
Sliders sliders(double G, const std::vector<double>& gamma, const std::vector<double>& tau);

/// Of one through n points of the hyperbola at strains from gamma_r/100 to 30 gamma_r, equally spaced in their
/// logarithms.
Sliders sliders(const ShearSoil& soil, int n);

/// Under a shear stress tau(t) (Pa) at the top, to the end (s); `at`: height of strain and stress (m). Kept at n_kept
/// equal times after t = 0.
ShearHistory shake(const ShearSoil& soil, const std::function<double(double)>& tau, double end, double at,
                   int n_elements, const Sliders& sliders, int n_kept);

}  // namespace upbead::test
