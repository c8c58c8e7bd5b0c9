// A rigid block on a layer that is 400 times wider than thick, and only shears.
#pragma once

#include <string>

namespace upbead::test {

/// With so many nodes along it.
inline std::string layer_geo(int nodes) {
  return R"(
Point(1) = {-200, 0, 0}; Point(2) = {200, 0, 0}; Point(3) = {200, 1, 0}; Point(4) = {-200, 1, 0};
Point(5) = {200, 3, 0}; Point(6) = {-200, 3, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Line(5) = {3, 5}; Line(6) = {5, 6}; Line(7) = {6, 4};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Curve Loop(2) = {-3, 5, 6, 7}; Plane Surface(2) = {2};
Transfinite Curve {1, 3, 6} = )" +
         std::to_string(nodes) + R"(; Transfinite Curve {2, 4, 5, 7} = 2;
Transfinite Surface {1, 2}; Recombine Surface {1, 2};
Physical Surface("soil") = {1}; Physical Surface("caisson") = {2};
Physical Curve("base") = {1}; Physical Curve("sides") = {2, 4}; Physical Curve("walls") = {5, 6, 7};
)";
}

/// The block of 4e6 kg/m under a triangle of 0.2 s; the table [time] follows.
inline std::string block_on_layer(double peak) {
  return R"(
[regions.caisson]
kind = "rigid"
mass = 4e6
[boundaries]
base = { displacement = "fixed" }
sides = {}
walls = {}
[loads.impact]
region = "caisson"
at = [0.0, 1.0]
pulse = { shape = "triangle", duration = 0.2, peak = )" +
         std::to_string(peak) + R"( }
[time]
)";
}

}  // namespace upbead::test
