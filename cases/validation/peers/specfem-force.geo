// Half of a plane of rock with a small square in its middle, in which a force acts; symmetric about x = 0.
//
//          top                  y = above
//     +-+----------+
//     +-+----------+
// left|s|   rock   | far        |y| < half, x < half: source
//     +-+----------+
//     +-+----------+
//         bottom                y = -below

DefineConstant[
  half = 2,      // m: half the side of the square
  width = 1060,  // m: from the axis to the far side
  above = 680,   // m: height above the force
  below = 1060,  // m: depth below it
  size = 30      // m: size of the cells
];

xs[] = {0, half, width};
ys[] = {-below, -half, half, above};
For j In {0 : 3}
  For i In {0 : 2}
    Point(1 + i + 3 * j) = {xs[i], ys[j], 0};
  EndFor
EndFor
across[] = {1, Round((width - half) / size)};
up[] = {Round((below - half) / size), 1, Round((above - half) / size)};
For j In {0 : 3}
  For i In {0 : 1}
    Line(100 + i + 2 * j) = {1 + i + 3 * j, 2 + i + 3 * j};
    Transfinite Curve {100 + i + 2 * j} = across[i] + 1;
  EndFor
EndFor
For j In {0 : 2}
  For i In {0 : 2}
    Line(200 + i + 3 * j) = {1 + i + 3 * j, 4 + i + 3 * j};
    Transfinite Curve {200 + i + 3 * j} = up[j] + 1;
  EndFor
EndFor
For j In {0 : 2}
  For i In {0 : 1}
    n = 1 + i + 2 * j;
    Curve Loop(n) = {100 + i + 2 * j, 201 + i + 3 * j, -(102 + i + 2 * j), -(200 + i + 3 * j)};
    Plane Surface(n) = {n};
    Transfinite Surface {n};
    Recombine Surface {n};
  EndFor
EndFor
Physical Surface("source") = {3};
Physical Surface("rock") = {1, 2, 4, 5, 6};
Physical Curve("left") = {200, 203, 206};
Physical Curve("far") = {202, 205, 208};
Physical Curve("bottom") = {100, 101};
Physical Curve("top") = {106, 107};
