// The designer's section as gmsh's tutorial would have it: points, lines, a size of cells at each point, no blocks.
//
//               back            top of the caisson at 22, sea level at 12, harbour at 11.5
//   sea     +---------+  harbour
//  ---------| caisson |---------          x = 0: the caisson's middle, positive landward
//     ______|_________|_______            y = 0: the seabed's surface, positive up
//  __/        mound           \___
//              sand
//              clay

far = 3.0;   // m: cells far away
near = 0.5;  // m: cells under the caisson's corners
crest = 1.5; // m: cells at the edges of the mound's crest

// ground: 200 m wide, 12 m of clay below 8 m of sand
Point(1) = {-100, -20, 0, far};
Point(2) = {100, -20, 0, far};
Point(3) = {-100, -8, 0, far};
Point(4) = {100, -8, 0, far};
Point(5) = {-100, 0, 0, far};
Point(6) = {100, 0, 0, far};
// mound: 5 m, slopes 1:2 and 1:1.5
Point(7) = {-28, 0, 0, far};
Point(8) = {29.5, 0, 0, far};
Point(9) = {-18, 5, 0, crest};
Point(10) = {22, 5, 0, crest};
// caisson: 20 m x 17 m
Point(11) = {-10, 5, 0, near};
Point(12) = {10, 5, 0, near};
Point(13) = {-10, 12, 0, far};
Point(14) = {10, 11.5, 0, far};
Point(15) = {-10, 22, 0, far};
Point(16) = {10, 22, 0, far};
// sea and harbour
Point(17) = {-100, 12, 0, far};
Point(18) = {100, 11.5, 0, far};

Line(1) = {1, 2};
Line(2) = {3, 4};
Line(3) = {1, 3};
Line(4) = {2, 4};
Line(5) = {3, 5};
Line(6) = {4, 6};
Line(7) = {5, 7};
Line(8) = {7, 8};
Line(9) = {8, 6};
Line(10) = {7, 9};
Line(11) = {9, 11};
Line(12) = {11, 12};
Line(13) = {12, 10};
Line(14) = {10, 8};
Line(15) = {11, 13};
Line(16) = {13, 15};
Line(17) = {15, 16};
Line(18) = {12, 14};
Line(19) = {14, 16};
Line(20) = {5, 17};
Line(21) = {17, 13};
Line(22) = {6, 18};
Line(23) = {14, 18};

Curve Loop(1) = {1, 4, -2, -3};
Plane Surface(1) = {1};
Curve Loop(2) = {2, 6, -9, -8, -7, -5};
Plane Surface(2) = {2};
Curve Loop(3) = {8, -14, -13, -12, -11, -10};
Plane Surface(3) = {3};
Curve Loop(4) = {12, 18, 19, -17, -16, -15};
Plane Surface(4) = {4};
Curve Loop(5) = {7, 10, 11, 15, -21, -20};
Plane Surface(5) = {5};
Curve Loop(6) = {13, 14, 9, 22, -23, -18};
Plane Surface(6) = {6};

Physical Surface("subsoil") = {1};
Physical Surface("seabed") = {2};
Physical Surface("mound") = {3};
Physical Surface("caisson") = {4};
Physical Surface("sea_front") = {5};
Physical Surface("sea_back") = {6};
Physical Curve("base") = {1};
Physical Curve("left") = {3, 5};
Physical Curve("right") = {4, 6};
Physical Curve("bed") = {7, 9};
Physical Curve("mound_surface") = {10, 11, 13, 14};
Physical Curve("bottom") = {12};
Physical Curve("front") = {15, 16};
Physical Curve("top") = {17};
Physical Curve("back") = {18, 19};
Physical Curve("sea_surface") = {21, 23};
Physical Curve("sea_left") = {20};
Physical Curve("sea_right") = {22};

Mesh.SubdivisionAlgorithm = 1;  // triangles become quadrilaterals, each side halved
