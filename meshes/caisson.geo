// A caisson alone, for springs and dashpots in place of ground ([regions.caisson.springs]), on demand beside water.
//
//               top
//           +---------+   caisson_height             x = 0: the caisson's middle, positive landward
//   front   |         |   back                       y = 0: its base, positive up
//   +-------|         |-------+  water_depth         sea_surface: the level of the seas
//   | sea   | caisson |  sea  |                      sea_left, sea_right: their far ends
//   +-------+-bottom--+-------+  0                   bed: their floor, at the height of the base
//
// Nothing here is an absolute length: a section with all its lengths divided by 20 gets the same mesh, divided by 20.

DefineConstant[
  caisson_width = 18,   // m: width of the caisson
  caisson_height = 16,  // m: height of the caisson
  parapet_width = 0,    // m: width of a parapet on its top, from its seaward wall, which goes on up; 0: none
  parapet_height = 0,   // m: height of the parapet above the caisson; 0: none
  water_depth = 9,      // m: depth of the still water above the base; matters where there is a sea
  sea_front = 0,        // -: length of the sea in front of the caisson, over its depth; 0: none
  sea_back = 0,         // -: length of the sea behind the caisson, over its depth; 0: none
  sea_cells = 8,        // -: cells over the depth of the water at cells = 1
  cells = 1             // -: relative density of cells; 2 halves every cell in both directions
];

mistakes = 0;
Macro MustBePositive
  If (!(value > 0))
    Error(StrCat(name, " is %g; it must be greater than 0"), value);
    mistakes = 1;
  EndIf
Return
Macro MustBeALength
  If (!(value >= 0 && value <= 1000))
    Error(StrCat(name, " is %g; it must be from 0 (no sea) to 1000"), value);
    mistakes = 1;
  EndIf
Return
name = "caisson_width"; value = caisson_width;
Call MustBePositive;
name = "caisson_height"; value = caisson_height;
Call MustBePositive;
name = "sea_cells"; value = sea_cells;
Call MustBePositive;
name = "cells"; value = cells;
Call MustBePositive;
name = "sea_front"; value = sea_front;
Call MustBeALength;
name = "sea_back"; value = sea_back;
Call MustBeALength;
has_parapet = parapet_width > 0 && parapet_height > 0;
is_wide = parapet_width >= (1 - 1e-9) * caisson_width;
If (!has_parapet && parapet_width != 0 || !has_parapet && parapet_height != 0)
  Error("parapet_width is %g and parapet_height %g; give both, or none", parapet_width, parapet_height);
  mistakes = 1;
EndIf
If (parapet_width > (1 + 1e-9) * caisson_width)
  Error("parapet_width is %g; it must be at most caisson_width (%g): beyond it a parapet hangs in the air", parapet_width,
        caisson_width);
  mistakes = 1;
EndIf
has_sea = sea_front > 0 || sea_back > 0;
If (has_sea && !(water_depth > 0 && water_depth < caisson_height))
  Error("water_depth is %g; a sea must be deeper than 0 (the base) and shallower than %g (the caisson's top)",
        water_depth, caisson_height);
  mistakes = 1;
EndIf
// Beyond these a mesh outgrows the memory.
If (cells > 20)
  Error("cells is %g; it must be at most 20", cells);
  mistakes = 1;
EndIf
If (sea_cells > 100)
  Error("sea_cells is %g; it must be at most 100", sea_cells);
  mistakes = 1;
EndIf
If (mistakes)
  Abort;
EndIf

// The caisson is rigid: its cells cost nothing. Those of a sea grow by a tenth from column to column away from its wall.
wet = caisson_height / 2;
If (has_sea)
  wet = water_depth;
EndIf
rows = Max(2, Round(sea_cells * cells + 1e-6));
dry_rows = Max(1, Round(4 * cells * (caisson_height - wet) / caisson_width + 1e-6));
across = Max(2, Round(4 * cells + 1e-6));
growth = 1.1^(1 / cells);
length[] = {sea_front * wet, sea_back * wet};
For side In {0 : 1}
  columns[side] = Max(1, Round(Log(1 + length[side] * rows / wet * (growth - 1)) / Log(growth) + 1e-6));
EndFor

half = caisson_width / 2;
Point(1) = {-half, 0, 0};
Point(2) = {half, 0, 0};
Point(3) = {half, wet, 0};
Point(4) = {-half, wet, 0};
Point(5) = {half, caisson_height, 0};
Point(6) = {-half, caisson_height, 0};
Line(2) = {2, 3};
Line(4) = {1, 4};
Line(5) = {3, 5};
Line(7) = {4, 6};
Transfinite Curve {2, 4} = rows + 1;
Transfinite Curve {5, 7} = dry_rows + 1;
caisson[] = {1, 2};
bottom[] = {1};
top[] = {6};
If (has_parapet && !is_wide)  // two columns, which meet below the parapet's landward side
  under = Max(1, Round(across * parapet_width / caisson_width + 1e-6));
  Point(7) = {parapet_width - half, 0, 0};
  Point(8) = {parapet_width - half, wet, 0};
  Point(9) = {parapet_width - half, caisson_height, 0};
  Line(31) = {1, 7};
  Line(32) = {7, 2};
  Line(33) = {4, 8};
  Line(34) = {8, 3};
  Line(35) = {6, 9};
  Line(36) = {9, 5};
  Line(37) = {7, 8};
  Line(38) = {8, 9};
  Transfinite Curve {31, 33, 35} = under + 1;
  Transfinite Curve {32, 34, 36} = Max(1, across - under) + 1;
  Transfinite Curve {37} = rows + 1;
  Transfinite Curve {38} = dry_rows + 1;
  Curve Loop(1) = {31, 37, -33, -4};
  Curve Loop(2) = {32, 2, -34, -37};
  Curve Loop(3) = {33, 38, -35, -7};
  Curve Loop(4) = {34, 5, -36, -38};
  Plane Surface(3) = {3};
  Plane Surface(4) = {4};
  caisson[] = {1, 2, 3, 4};
  bottom[] = {31, 32};
  top[] = {35, 36};
Else
  Line(1) = {1, 2};
  Line(3) = {4, 3};
  Line(6) = {6, 5};
  Transfinite Curve {1, 3, 6} = across + 1;
  Curve Loop(1) = {1, 2, -3, -4};
  Curve Loop(2) = {3, 5, -6, -7};
EndIf
Plane Surface(1) = {1};
Plane Surface(2) = {2};
front[] = {4, 7};
back[] = {2, 5};
If (has_parapet)
  Point(41) = {-half, caisson_height + parapet_height, 0};
  Point(42) = {parapet_width - half, caisson_height + parapet_height, 0};
  Line(41) = {6, 41};
  Line(42) = {41, 42};
  If (is_wide)
    Line(43) = {5, 42};
    back[] += {43};
    top[] = {42};
    Transfinite Curve {42} = across + 1;
    Curve Loop(5) = {6, 43, -42, -41};
  Else
    Line(43) = {9, 42};
    top[] = {42, 43, 36};
    Transfinite Curve {42} = under + 1;
    Curve Loop(5) = {35, 43, -42, -41};
  EndIf
  Transfinite Curve {41, 43} = Max(1, Round(4 * cells * parapet_height / caisson_width + 1e-6)) + 1;
  Plane Surface(5) = {5};
  caisson[] += {5};
  front[] += {41};
EndIf
Transfinite Surface {caisson[]};
Recombine Surface {caisson[]};
bed[] = {};
level[] = {};

If (sea_front > 0)
  Point(11) = {-half - length[0], 0, 0};
  Point(12) = {-half - length[0], wet, 0};
  Line(11) = {1, 11};
  Line(12) = {11, 12};
  Line(13) = {4, 12};
  Transfinite Curve {11, 13} = columns[0] + 1 Using Progression growth;
  Transfinite Curve {12} = rows + 1;
  Curve Loop(11) = {-11, 4, 13, -12};
  Plane Surface(11) = {11};
  Transfinite Surface {11};
  Recombine Surface {11};
  Physical Surface("sea_front") = {11};
  Physical Curve("sea_left") = {12};
  bed[] = {bed[], 11};
  level[] = {level[], 13};
EndIf
If (sea_back > 0)
  Point(21) = {half + length[1], 0, 0};
  Point(22) = {half + length[1], wet, 0};
  Line(21) = {2, 21};
  Line(22) = {21, 22};
  Line(23) = {3, 22};
  Transfinite Curve {21, 23} = columns[1] + 1 Using Progression growth;
  Transfinite Curve {22} = rows + 1;
  Curve Loop(21) = {21, 22, -23, -2};
  Plane Surface(21) = {21};
  Transfinite Surface {21};
  Recombine Surface {21};
  Physical Surface("sea_back") = {21};
  Physical Curve("sea_right") = {22};
  bed[] = {bed[], 21};
  level[] = {level[], 23};
EndIf
If (has_sea)
  Physical Curve("bed") = {bed[]};
  Physical Curve("sea_surface") = {level[]};
EndIf

Physical Surface("caisson") = {caisson[]};
Physical Curve("front") = {front[]};
Physical Curve("back") = {back[]};
Physical Curve("top") = {top[]};
Physical Curve("bottom") = {bottom[]};
