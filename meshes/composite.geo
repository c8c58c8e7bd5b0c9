// A composite breakwater: a caisson on a rubble mound on a seabed, in quadrilaterals only.
//
//                    top
//               +-----+-----+
//         front |  caisson  | back                  x = 0: the caisson's middle, positive landward
//               |           |                       y = 0: the seabed's surface, positive up
//          +----+--bottom---+----+
//         /|       mound         |\                  mound_surface: slopes and berms
//   bed  /_|____________________ |_\   bed
//  +----+--+----+-----+-----+----+--+----+
//  |    |  |    |     |     |    |  |    |          left, base, right: the seabed's outer sides
//  +----+--+----+-----+-----+----+--+----+          bottom: interior, between caisson and mound
//
// Nothing here is an absolute length: a section with all its lengths divided by 20 gets the same mesh, divided by 20.

DefineConstant[
  seabed_depth = 15,       // m: thickness of the seabed above its rigid base
  seabed_front = 60,       // m: length of the seabed in front of the mound's seaward toe
  seabed_back = 60,        // m: length of the seabed behind the mound's landward toe
  mound_height = 6,        // m: height of the mound above the seabed
  mound_crest_front = 16,  // m: from the caisson's middle to the seaward edge of the mound's crest
  mound_crest_back = 16,   // m: from the caisson's middle to the landward edge of the mound's crest
  mound_slope = 2,         // -: slope of the mound's sides, horizontal per vertical
  caisson_width = 18,      // m: width of the caisson
  caisson_height = 16,     // m: height of the caisson above the mound
  cells = 1,               // -: relative density of cells; 2 halves every cell in both directions
  grading = 12             // -: size of the cells far from the caisson's bottom corners over that at the corners
];

// ------------------------------------------------------------------------------------------------ parameters
mistakes = 0;
Macro MustBePositive
  If (!(value > 0))
    Error(StrCat(name, " is %g; it must be greater than 0"), value);
    mistakes = 1;
  EndIf
Return
name = "seabed_depth"; value = seabed_depth;
Call MustBePositive;
name = "seabed_front"; value = seabed_front;
Call MustBePositive;
name = "seabed_back"; value = seabed_back;
Call MustBePositive;
name = "mound_height"; value = mound_height;
Call MustBePositive;
name = "mound_slope"; value = mound_slope;
Call MustBePositive;
name = "caisson_width"; value = caisson_width;
Call MustBePositive;
name = "caisson_height"; value = caisson_height;
Call MustBePositive;
name = "cells"; value = cells;
Call MustBePositive;
If (!(mound_crest_front > caisson_width / 2))
  Error("mound_crest_front is %g; it must be greater than half of caisson_width (%g): the mound needs a berm",
        mound_crest_front, caisson_width / 2);
  mistakes = 1;
EndIf
If (!(mound_crest_back > caisson_width / 2))
  Error("mound_crest_back is %g; it must be greater than half of caisson_width (%g): the mound needs a berm",
        mound_crest_back, caisson_width / 2);
  mistakes = 1;
EndIf
If (!(grading >= 1))
  Error("grading is %g; it must be 1 (all cells alike) or greater", grading);
  mistakes = 1;
EndIf
// Beyond these a mesh outgrows the memory, or gmsh aborts.
If (cells > 20)
  Error("cells is %g; it must be at most 20", cells);
  mistakes = 1;
EndIf
If (grading > 200)
  Error("grading is %g; it must be at most 200", grading);
  mistakes = 1;
EndIf
If (mistakes)
  Abort;
EndIf

// -------------------------------------------------------------------------------------------- sizes of cells
// The stress is singular at the caisson's bottom corners, so the size of cells grows linearly with the distance from
// the nearer corner, from far_size / grading to far_size.
far_size = caisson_width / (6 * cells);
reach = caisson_width;

// Grade: an edge of a given `length` that starts at `distance` from the corner gets `count` cells, each `ratio` times
// as long as the one before it (counted away from the corner).
Macro Grade
  first = far_size * (1 / grading + (1 - 1 / grading) * Min(distance / reach, 1));
  last = far_size * (1 / grading + (1 - 1 / grading) * Min((distance + length) / reach, 1));
  If (last - first < 1e-9 * last)
    count = length / last;
  Else
    count = length * Log(last / first) / (last - first);
  EndIf
  // What is added keeps a count that is a half but for round-off from depending on the unit of length.
  count = Max(least, Round(count + 1e-6));
  ratio = (last / first)^(1 / count);
Return

// FractionOfPart: how far the first `part` of the `count` cells reach along the edge, as a fraction of its length.
Macro FractionOfPart
  If (Fabs(ratio - 1) < 1e-9)
    fraction = part / count;
  Else
    fraction = (ratio^part - 1) / (ratio^count - 1);
  EndIf
Return

least = 1;
distance = 0; length = caisson_width / 2;
Call Grade;
half_count = count; half_ratio = ratio;

distance = mound_height; length = seabed_depth;
Call Grade;
depth_count = count; depth_ratio = ratio;

// The mound's height has an upper and a lower row of blocks, because its triangular slopes are made of three blocks. The
// upper row takes about a third of the height.
least = 2;
distance = 0; length = mound_height;
Call Grade;
mound_ratio = ratio;
If (Fabs(ratio - 1) < 1e-9)
  upper_count = count / 3;
Else
  upper_count = Log(1 + (ratio^count - 1) / 3) / Log(ratio);
EndIf
upper_count = Min(Max(1, Round(upper_count + 1e-6)), count - 1);
lower_count = count - upper_count;
part = upper_count;
Call FractionOfPart;
middle = mound_height * (1 - fraction);

// The slope's foot has an inner part under the crest's edge and a toe part, which has as many cells as the upper row.
foot = mound_slope * mound_height;
inner = 0.4 * foot;

// Side 0 is seaward, side 1 landward.
crest[] = {mound_crest_front, mound_crest_back};
far[] = {seabed_front, seabed_back};
least = 1;
For side In {0 : 1}
  distance = 0; length = crest[side] - caisson_width / 2;
  Call Grade;
  berm_count[side] = count; berm_ratio[side] = ratio;

  distance = distance + length; length = inner;
  Call Grade;
  inner_count[side] = count;

  distance = crest[side] - caisson_width / 2 + foot; length = far[side];
  Call Grade;
  far_count[side] = count; far_ratio[side] = ratio;
EndFor

// ---------------------------------------------------------------------------------------------------- points
// Column lines from left to right: side, toe, inner part of the foot, crest, caisson, middle, and back again. Blocks above the mound stand on the same lines.
x[] = {-crest[0] - foot - far[0], -crest[0] - foot, -crest[0] - inner, -crest[0], -caisson_width / 2, 0,
       caisson_width / 2, crest[1], crest[1] + inner, crest[1] + foot, crest[1] + foot + far[1]};
For i In {0 : 10}
  at_base[i] = newp; Point(at_base[i]) = {x[i], -seabed_depth, 0};
  at_bed[i] = newp; Point(at_bed[i]) = {x[i], 0, 0};
EndFor
For i In {3 : 7}
  at_middle[i] = newp; Point(at_middle[i]) = {x[i], middle, 0};
  at_crest[i] = newp; Point(at_crest[i]) = {x[i], mound_height, 0};
EndFor
For i In {4 : 6}
  at_top[i] = newp; Point(at_top[i]) = {x[i], mound_height + caisson_height, 0};
EndFor

// ---------------------------------------------------------------------------------------------------- curves
// Along x, column i lies between the lines i and i + 1; its cells grow from left to right by column_ratio[i].
column_count[] = {far_count[0], upper_count, inner_count[0], berm_count[0], half_count,
                  half_count, berm_count[1], inner_count[1], upper_count, far_count[1]};
column_ratio[] = {1 / far_ratio[0], 1, 1, 1 / berm_ratio[0], half_ratio,
                  1 / half_ratio, berm_ratio[1], 1, 1, far_ratio[1]};

// Along: a line of column i between the points `from` (left) and `to` (right). gmsh places nodes to 1e-9 only, so lines
// of the left half are drawn leftwards and have a minus: the halves then are mirror images to round-off.
Macro Along
  along = newl;
  If (i < 5)
    Line(along) = {to, from};
    along = -along;
  Else
    Line(along) = {from, to};
  EndIf
  Transfinite Curve {along} = column_count[i] + 1 Using Progression column_ratio[i];
Return
For i In {0 : 9}
  from = at_base[i]; to = at_base[i + 1];
  Call Along;
  along_base[i] = along;
  from = at_bed[i]; to = at_bed[i + 1];
  Call Along;
  along_bed[i] = along;
EndFor
For i In {3 : 6}
  from = at_middle[i]; to = at_middle[i + 1];
  Call Along;
  along_middle[i] = along;
  from = at_crest[i]; to = at_crest[i + 1];
  Call Along;
  along_crest[i] = along;
EndFor
For i In {4 : 5}
  from = at_top[i]; to = at_top[i + 1];
  Call Along;
  along_top[i] = along;
EndFor

// Along y, all lines run downwards, away from the caisson; the caisson's run upwards. The caisson is rigid as a rule,
// so a few rows do.
caisson_count = Max(1, Round(4 * cells * caisson_height / caisson_width + 1e-6));
For i In {0 : 10}
  through_seabed[i] = newl; Line(through_seabed[i]) = {at_bed[i], at_base[i]};
  Transfinite Curve {through_seabed[i]} = depth_count + 1 Using Progression depth_ratio;
EndFor
For i In {3 : 7}
  through_upper[i] = newl; Line(through_upper[i]) = {at_crest[i], at_middle[i]};
  Transfinite Curve {through_upper[i]} = upper_count + 1 Using Progression mound_ratio;
  through_lower[i] = newl; Line(through_lower[i]) = {at_middle[i], at_bed[i]};
  Transfinite Curve {through_lower[i]} = lower_count + 1 Using Progression mound_ratio;
EndFor
For i In {4 : 6}
  through_caisson[i] = newl; Line(through_caisson[i]) = {at_crest[i], at_top[i]};
  Transfinite Curve {through_caisson[i]} = caisson_count + 1;
EndFor

// -------------------------------------------------------------------------------------------------- surfaces
For i In {0 : 9}
  loop = newll; Curve Loop(loop) = {through_seabed[i], along_base[i], -through_seabed[i + 1], -along_bed[i]};
  seabed[i] = news; Plane Surface(seabed[i]) = {loop};
EndFor
mound[] = {};
For i In {3 : 6}
  loop = newll; Curve Loop(loop) = {through_lower[i], along_bed[i], -through_lower[i + 1], -along_middle[i]};
  block = news; mound[] += block; Plane Surface(block) = {loop};
  Transfinite Surface {block};
  loop = newll; Curve Loop(loop) = {through_upper[i], along_middle[i], -through_upper[i + 1], -along_crest[i]};
  block = news; mound[] += block; Plane Surface(block) = {loop};
  Transfinite Surface {block};
EndFor
caisson[] = {};
For i In {4 : 5}
  loop = newll; Curve Loop(loop) = {along_crest[i], through_caisson[i + 1], -along_top[i], -through_caisson[i]};
  block = news; caisson[] += block; Plane Surface(block) = {loop};
EndFor

// The slopes: triangles toe - foot of the crest - edge of the crest, each of three blocks about a point `centre`. The
// cut on the slope and the centre follow from the cuts of the other two sides (Ceva), so that the blocks keep in shape.
toe_line[] = {1, 9}; inner_line[] = {2, 8}; crest_line[] = {3, 7};
toe_weight = inner / (foot - inner); top_weight = middle / (mound_height - middle);
weights = toe_weight + 1 + top_weight;
For side In {0 : 1}
  t = toe_line[side]; m = inner_line[side]; c = crest_line[side];
  sign = 2 * side - 1;
  cut = newp;
  Point(cut) = {x[c] + sign * foot * toe_weight / (toe_weight + top_weight),
                mound_height * top_weight / (toe_weight + top_weight), 0};
  centre = newp;
  Point(centre) = {x[c] + sign * foot * toe_weight / weights, mound_height * top_weight / weights, 0};

  slope_lower[side] = newl; Line(slope_lower[side]) = {at_bed[t], cut};
  slope_upper[side] = newl; Line(slope_upper[side]) = {cut, at_crest[c]};
  to_foot = newl; Line(to_foot) = {centre, at_bed[m]};
  to_crest_line = newl; Line(to_crest_line) = {centre, at_middle[c]};
  to_slope = newl; Line(to_slope) = {centre, cut};
  Transfinite Curve {slope_lower[side], to_foot} = lower_count + 1;
  Transfinite Curve {slope_upper[side], to_crest_line} = inner_count[side] + 1;
  Transfinite Curve {to_slope} = upper_count + 1;

  // Towards the toe the bed's columns are outwards on the landward side and inwards on the seaward one.
  If (side == 0)
    toe_to_foot = along_bed[1]; foot_to_crest = along_bed[2];
  Else
    toe_to_foot = -along_bed[8]; foot_to_crest = -along_bed[7];
  EndIf
  loop = newll; Curve Loop(loop) = {toe_to_foot, -to_foot, to_slope, -slope_lower[side]};
  block = news; mound[] += block; Plane Surface(block) = {loop};
  Transfinite Surface {block} = {at_bed[t], at_bed[m], centre, cut};
  loop = newll; Curve Loop(loop) = {foot_to_crest, -through_lower[c], -to_crest_line, to_foot};
  block = news; mound[] += block; Plane Surface(block) = {loop};
  Transfinite Surface {block} = {at_bed[m], at_bed[c], at_middle[c], centre};
  loop = newll; Curve Loop(loop) = {to_crest_line, -through_upper[c], -slope_upper[side], -to_slope};
  block = news; mound[] += block; Plane Surface(block) = {loop};
  Transfinite Surface {block} = {centre, at_middle[c], at_crest[c], cut};
EndFor
Transfinite Surface {seabed[], caisson[]};
Recombine Surface {:};

// ----------------------------------------------------------------------------------------------------- names
Physical Surface("seabed") = seabed[];
Physical Surface("mound") = mound[];
Physical Surface("caisson") = caisson[];

Physical Curve("base") = along_base[];
Physical Curve("left") = {through_seabed[0]};
Physical Curve("right") = {through_seabed[10]};
Physical Curve("bed") = {along_bed[0], along_bed[9]};
Physical Curve("mound_surface") = {slope_lower[], slope_upper[], along_crest[3], along_crest[6]};
Physical Curve("front") = {through_caisson[4]};
Physical Curve("back") = {through_caisson[6]};
Physical Curve("top") = {along_top[4], along_top[5]};
Physical Curve("bottom") = {along_crest[4], along_crest[5]};
