// A rigid block on a block of soil, each side of which may be wider.
DefineConstant[
  width = 4,      // m: of the rigid block
  height = 0.25,  // m: of the rigid block
  front = 2,      // m: of the soil in front of it
  back = 2,       // m: of the soil behind it
  depth = 2,      // m: of the soil
  size = 0.25     // m: of a cell
];
x0 = -front; x1 = 0; x2 = width; x3 = width + back;
Point(1) = {x0, 0, 0}; Point(2) = {x1, 0, 0}; Point(3) = {x2, 0, 0}; Point(4) = {x3, 0, 0};
Point(5) = {x0, depth, 0}; Point(6) = {x1, depth, 0}; Point(7) = {x2, depth, 0}; Point(8) = {x3, depth, 0};
Point(9) = {x1, depth + height, 0}; Point(10) = {x2, depth + height, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4};
Line(4) = {5, 6}; Line(5) = {6, 7}; Line(6) = {7, 8};
Line(7) = {1, 5}; Line(8) = {2, 6}; Line(9) = {3, 7}; Line(10) = {4, 8};
Line(11) = {6, 9}; Line(12) = {7, 10}; Line(13) = {9, 10};
Transfinite Curve {1, 4} = Max(Round(front / size), 1) + 1;
Transfinite Curve {2, 5, 13} = Max(Round(width / size), 1) + 1;
Transfinite Curve {3, 6} = Max(Round(back / size), 1) + 1;
Transfinite Curve {7, 8, 9, 10} = Max(Round(depth / size), 1) + 1;
Transfinite Curve {11, 12} = Max(Round(height / size), 1) + 1;
Curve Loop(1) = {1, 8, -4, -7}; Plane Surface(1) = {1};
Curve Loop(2) = {2, 9, -5, -8}; Plane Surface(2) = {2};
Curve Loop(3) = {3, 10, -6, -9}; Plane Surface(3) = {3};
Curve Loop(4) = {5, 12, -13, -11}; Plane Surface(4) = {4};
Transfinite Surface {1, 2, 3, 4};
Recombine Surface {1, 2, 3, 4};
Physical Surface("soil") = {1, 2, 3};
Physical Surface("caisson") = {4};
Physical Curve("base") = {1, 2, 3};
Physical Curve("left") = {7};
Physical Curve("right") = {10};
Physical Curve("ground") = {4, 6};
Physical Curve("front") = {11};
Physical Curve("back") = {12};
Physical Curve("top") = {13};
