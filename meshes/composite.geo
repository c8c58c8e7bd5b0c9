// A composite breakwater: a caisson on a rubble mound on a seabed, in quadrilaterals only.
//
//                    top
//               +-----+-----+
//         front |  caisson  | back                  x = 0: the caisson's middle, positive landward; on demand a parapet
//               |           |                       y = 0: the seabed's surface, positive up
//          +----+--bottom---+----+
//         /|       mound         |\                  mound_surface: slopes and berms
//   bed  /_|____________________ |_\   bed
//  +----+--+----+-----+-----+----+--+----+
//  |    |  |    |     |     |    |  |    |          left, base, right: the outer sides of the ground
//  +----+--+----+-----+-----+----+--+----+          bottom: interior, between caisson and mound
//  |    |  |   subsoil (on demand)  |  |    |
//  +----+--+----+-----+-----+----+--+----+
//
// With seabed_depth = 0 the mound stands on a rigid floor, as in a flume: base is the mound's lower side, and there is
// no seabed, no left and no right; bed is the floor under a sea.
//
// With a sea, on either side or on both:
//
//              sea_surface
//           +--------+--+--+- -                     the caisson's wall is cut at the water level
//           |        |  |  | front
//  sea_left |     sea_front|                        behind the caisson: back, sea_back, sea_right
//           |        |  +--+- -
//           |        | /|  |                        bed and mound_surface: interior under a sea
//  +----+---+--------+--+--+- -
//  |    |   |        |  |  |                        the seabed's far column is cut below the sea's end
//  +----+---+--------+--+--+- -
//
// Nothing here is an absolute length: a section with all its lengths divided by 20 gets the same mesh, divided by 20.

DefineConstant[
  seabed_depth = 15,       // m: thickness of the seabed, above its rigid base or the subsoil; 0: the base is at y = 0
  subsoil_depth = 0,       // m: thickness of a second layer, from the seabed down to the base; 0: none
  seabed_front = 120,      // m: length of the seabed in front of the mound's seaward toe
  seabed_back = 120,       // m: length of the seabed behind the mound's landward toe
  mound_height = 6,        // m: height of the mound above the seabed
  mound_crest_front = 16,  // m: from the caisson's middle to the seaward edge of the mound's crest
  mound_crest_back = 16,   // m: from the caisson's middle to the landward edge of the mound's crest
  mound_slope = 2,         // -: slope of the mound's sides, horizontal per vertical
  mound_slope_front = 0,   // -: slope of the seaward side alone; 0: mound_slope
  mound_slope_back = 0,    // -: slope of the landward side alone; 0: mound_slope
  caisson_width = 18,      // m: width of the caisson
  caisson_height = 16,     // m: height of the caisson above the mound
  parapet_width = 0,       // m: width of a parapet on its top, from its seaward wall, which goes on up; 0: none
  parapet_height = 0,      // m: height of the parapet above the caisson; 0: none
  cells = 1,               // -: relative density of cells; 2 halves every cell in both directions
  grading = 12,            // -: size of the cells far from the caisson's bottom corners over that at the corners
  water_depth = 15,        // m: depth of the still water above the seabed; matters where there is a sea
  water_depth_back = 0,    // m: depth of the still water behind the caisson alone; 0: water_depth
  sea_front = 0,           // -: length of the sea in front of the caisson, from its wall, over its depth; 0: none
  sea_back = 0,            // -: length of the sea behind the caisson, from its wall, over its depth; 0: none
  sea_cells = 8            // -: cells over the depth of the water at the caisson's wall at cells = 1
];

// ------------------------------------------------------------------------------------------------ parameters
mistakes = 0;
Macro MustBePositive
  If (!(value > 0))
    Error(StrCat(name, " is %g; it must be greater than 0"), value);
    mistakes = 1;
  EndIf
Return
Macro MustNotBeNegative
  If (!(value >= 0))
    Error(StrCat(name, " is %g; it must be 0 (", meaning, ") or greater"), value);
    mistakes = 1;
  EndIf
Return
name = "seabed_depth"; value = seabed_depth; meaning = "the mound stands on a rigid floor";
Call MustNotBeNegative;
name = "seabed_front"; value = seabed_front;
Call MustBePositive;
name = "seabed_back"; value = seabed_back;
Call MustBePositive;
name = "mound_height"; value = mound_height;
Call MustBePositive;
name = "mound_slope"; value = mound_slope;
Call MustBePositive;
name = "subsoil_depth"; value = subsoil_depth; meaning = "none";
Call MustNotBeNegative;
If (subsoil_depth > 0 && seabed_depth == 0)
  Error("subsoil_depth is %g, but seabed_depth is 0; one layer of ground is the seabed", subsoil_depth);
  mistakes = 1;
EndIf
has_seabed = seabed_depth > 0;
name = "mound_slope_front"; value = mound_slope_front; meaning = "mound_slope";
Call MustNotBeNegative;
name = "mound_slope_back"; value = mound_slope_back;
Call MustNotBeNegative;
name = "water_depth_back"; value = water_depth_back; meaning = "water_depth";
Call MustNotBeNegative;
name = "caisson_width"; value = caisson_width;
Call MustBePositive;
name = "caisson_height"; value = caisson_height;
Call MustBePositive;
name = "parapet_width"; value = parapet_width; meaning = "none";
Call MustNotBeNegative;
name = "parapet_height"; value = parapet_height; meaning = "none";
Call MustNotBeNegative;
same = 1e-9;
has_parapet = parapet_width > 0 && parapet_height > 0;
is_wide = parapet_width >= (1 - same) * caisson_width;
If (!has_parapet && parapet_width + parapet_height > 0)
  Error("parapet_width is %g and parapet_height %g; give both, or none", parapet_width, parapet_height);
  mistakes = 1;
EndIf
If (parapet_width > (1 + same) * caisson_width)
  Error("parapet_width is %g; it must be at most caisson_width (%g): beyond it a parapet hangs in the air", parapet_width,
        caisson_width);
  mistakes = 1;
EndIf
name = "cells"; value = cells;
Call MustBePositive;
// With pressures of degree 2, 8 to 10 cells give the sea's added mass to 0.1 %.
name = "sea_cells"; value = sea_cells;
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
If (sea_cells > 100)
  Error("sea_cells is %g; it must be at most 100", sea_cells);
  mistakes = 1;
EndIf

// A sea meets the caisson's wall, covers the slope and ends above the seabed. What is too long only by round-off, or
// by the digits that a message shows, ends at the seabed's side.
has_sea = sea_front > 0 || sea_back > 0;
Macro MustBeAfloat
  is_afloat = value > mound_height && value < mound_height + caisson_height;
  If (!is_afloat)
    Error(StrCat(name, " is %g; a sea must be deeper than %g (the mound's crest) and shallower than %g (the caisson's top)"),
          value, mound_height, mound_height + caisson_height);
    mistakes = 1;
  EndIf
Return
name = "water_depth"; value = water_depth; is_afloat = 0;
If (sea_front > 0 || (sea_back > 0 && !(water_depth_back > 0)))
  Call MustBeAfloat;
EndIf
afloat[] = {is_afloat, is_afloat};
water[] = {water_depth, water_depth};
If (water_depth_back > 0)
  water[1] = water_depth_back;
  name = "water_depth_back"; value = water_depth_back; is_afloat = 0;
  If (sea_back > 0)
    Call MustBeAfloat;
  EndIf
  afloat[1] = is_afloat;
EndIf
// Where a side has no sea, the caisson is cut at the level of the other.
If (!(sea_front > 0))
  water[0] = water[1];
ElseIf (!(sea_back > 0))
  water[1] = water[0];
EndIf
mean_water = (water[0] + water[1]) / 2;
slope[] = {mound_slope, mound_slope};
If (mound_slope_front > 0)
  slope[0] = mound_slope_front;
EndIf
If (mound_slope_back > 0)
  slope[1] = mound_slope_back;
EndIf
Macro MustEndAboveTheSeabed
  shortest = (to_crest - caisson_width / 2 + slope[side] * mound_height) / water[side];
  longest = shortest + length / water[side];
  If (!(value >= 0))
    Error(StrCat(name, " is %g; it must be 0 (no sea) or greater"), value);
    mistakes = 1;
  ElseIf (value > 0 && afloat[side] && (value <= (1 + same) * shortest || value > (1 + same) * longest))
    Error(StrCat(name, " is %g; it must be greater than %.10g (the mound's toe) and at most %.10g (the seabed's end)"),
          value, shortest, longest);
    mistakes = 1;
  EndIf
Return
name = "sea_front"; value = sea_front; side = 0; to_crest = mound_crest_front; length = seabed_front;
Call MustEndAboveTheSeabed;
name = "sea_back"; value = sea_back; side = 1; to_crest = mound_crest_back; length = seabed_back;
Call MustEndAboveTheSeabed;
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

// The caisson's two columns meet at x = 0, or below the landward side of its parapet.
split = 0;
If (has_parapet && !is_wide)
  split = parapet_width - caisson_width / 2;
EndIf
least = 1;
For side In {0 : 1}
  distance = 0; length = caisson_width / 2 + (1 - 2 * side) * split;
  Call Grade;
  half_count[side] = count; half_ratio[side] = ratio;
EndFor

distance = mound_height; length = seabed_depth;
Call Grade;
depth_count = count; depth_ratio = ratio;

distance = mound_height + seabed_depth; length = subsoil_depth;
Call Grade;
subsoil_count = count; subsoil_ratio = ratio;

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
// Side 0 is seaward, side 1 landward.
foot[] = {slope[0] * mound_height, slope[1] * mound_height};
inner[] = {0.4 * foot[0], 0.4 * foot[1]};
crest[] = {mound_crest_front, mound_crest_back};
far[] = {seabed_front, seabed_back};
sea[] = {sea_front, sea_back};
least = 1;
For side In {0 : 1}
  distance = 0; length = crest[side] - caisson_width / 2;
  Call Grade;
  berm_count[side] = count; berm_ratio[side] = ratio;

  distance = distance + length; length = inner[side];
  Call Grade;
  inner_count[side] = count;

  // The far column, from the toe on. Where a sea ends above it, it is cut there: `outer` has no sea above.
  distance = crest[side] - caisson_width / 2 + foot[side]; length = far[side];
  outer[side] = 0;
  under_sea = sea[side] * water[side] - distance;
  If (under_sea > 0 && under_sea + distance < (1 - same) * (far[side] + distance))
    length = under_sea;
    outer[side] = far[side] - under_sea;
    far[side] = under_sea;
  EndIf
  Call Grade;
  far_count[side] = count; far_ratio[side] = ratio;

  distance = distance + length; length = outer[side];
  Call Grade;
  outer_count[side] = count; outer_ratio[side] = ratio;
EndFor

// The sea has as many rows everywhere as at the wall, and so has the wet part of the caisson. The caisson is rigid as a
// rule, so a few rows do for what is dry.
sea_rows = Max(2, Round(sea_cells * cells + 1e-6));
dry_height = caisson_height;
If (has_sea)
  dry_height = mound_height + caisson_height - mean_water;
EndIf
dry_rows = Max(1, Round(4 * cells * dry_height / caisson_width + 1e-6));
parapet_rows = Max(1, Round(4 * cells * parapet_height / caisson_width + 1e-6));

// ---------------------------------------------------------------------------------------------------- points
// Column lines from left to right: side, toe, inner part of the foot, crest, caisson, middle, and back again. Blocks
// above the mound stand on the same lines. Below the end of a sea there is one more line, if that is not the side.
x[] = {-crest[0] - foot[0] - far[0], -crest[0] - foot[0], -crest[0] - inner[0], -crest[0], -caisson_width / 2, split,
       caisson_width / 2, crest[1], crest[1] + inner[1], crest[1] + foot[1], crest[1] + foot[1] + far[1]};
middle_line = 5;
last_line = 10;
If (outer[0] > 0)
  x[] = {-crest[0] - foot[0] - seabed_front, x[]};
  middle_line = middle_line + 1;
  last_line = last_line + 1;
EndIf
If (outer[1] > 0)
  x[] = {x[], crest[1] + foot[1] + seabed_back};
  last_line = last_line + 1;
EndIf
wall_line[] = {middle_line - 1, middle_line + 1};
crest_line[] = {middle_line - 2, middle_line + 2};
inner_line[] = {middle_line - 3, middle_line + 3};
toe_line[] = {middle_line - 4, middle_line + 4};
For i In {0 : last_line}
  If (has_seabed)
    at_base[i] = newp; Point(at_base[i]) = {x[i], -seabed_depth, 0};
  EndIf
  at_bed[i] = newp; Point(at_bed[i]) = {x[i], 0, 0};
EndFor
For i In {crest_line[0] : crest_line[1]}
  at_middle[i] = newp; Point(at_middle[i]) = {x[i], middle, 0};
  at_crest[i] = newp; Point(at_crest[i]) = {x[i], mound_height, 0};
EndFor
// The dry part of the caisson stands on the water level where there is a sea, or else on the mound; between two levels
// on their straight connection.
level_at_wall[] = {water[0], mean_water, water[1]};
For i In {wall_line[0] : wall_line[1]}
  at_top[i] = newp; Point(at_top[i]) = {x[i], mound_height + caisson_height, 0};
  at_dry[i] = at_crest[i];
  If (has_sea)
    at_dry[i] = newp; Point(at_dry[i]) = {x[i], level_at_wall[i - wall_line[0]], 0};
  EndIf
EndFor

// ---------------------------------------------------------------------------------------------------- curves
// Along x, column i lies between the lines i and i + 1; its cells grow from left to right by column_ratio[i].
column_count[] = {far_count[0], upper_count, inner_count[0], berm_count[0], half_count[0],
                  half_count[1], berm_count[1], inner_count[1], upper_count, far_count[1]};
column_ratio[] = {1 / far_ratio[0], 1, 1, 1 / berm_ratio[0], half_ratio[0],
                  1 / half_ratio[1], berm_ratio[1], 1, 1, far_ratio[1]};
If (outer[0] > 0)
  column_count[] = {outer_count[0], column_count[]};
  column_ratio[] = {1 / outer_ratio[0], column_ratio[]};
EndIf
If (outer[1] > 0)
  column_count[] = {column_count[], outer_count[1]};
  column_ratio[] = {column_ratio[], outer_ratio[1]};
EndIf

// Along: a line of column i between the points `from` (left) and `to` (right). gmsh places nodes to 1e-9 only, so lines
// of the left half are drawn leftwards and have a minus: the halves then are mirror images to round-off.
Macro Along
  along = newl;
  If (i < middle_line)
    Line(along) = {to, from};
    along = -along;
  Else
    Line(along) = {from, to};
  EndIf
  Transfinite Curve {along} = column_count[i] + 1 Using Progression column_ratio[i];
Return
For i In {0 : last_line - 1}
  If (has_seabed)
    from = at_base[i]; to = at_base[i + 1];
    Call Along;
    along_base[i] = along;
  EndIf
  from = at_bed[i]; to = at_bed[i + 1];
  Call Along;
  along_bed[i] = along;
EndFor
For i In {crest_line[0] : crest_line[1] - 1}
  from = at_middle[i]; to = at_middle[i + 1];
  Call Along;
  along_middle[i] = along;
  from = at_crest[i]; to = at_crest[i + 1];
  Call Along;
  along_crest[i] = along;
EndFor
For i In {wall_line[0] : wall_line[1] - 1}
  from = at_top[i]; to = at_top[i + 1];
  Call Along;
  along_top[i] = along;
  along_dry[i] = along_crest[i];
  If (has_sea)
    from = at_dry[i]; to = at_dry[i + 1];
    Call Along;
    along_dry[i] = along;
  EndIf
EndFor

// Along y, all lines run downwards, away from the caisson; the caisson's and the sea's run upwards.
If (has_seabed)
  For i In {0 : last_line}
    through_seabed[i] = newl; Line(through_seabed[i]) = {at_bed[i], at_base[i]};
    Transfinite Curve {through_seabed[i]} = depth_count + 1 Using Progression depth_ratio;
  EndFor
EndIf
For i In {crest_line[0] : crest_line[1]}
  through_upper[i] = newl; Line(through_upper[i]) = {at_crest[i], at_middle[i]};
  Transfinite Curve {through_upper[i]} = upper_count + 1 Using Progression mound_ratio;
  through_lower[i] = newl; Line(through_lower[i]) = {at_middle[i], at_bed[i]};
  Transfinite Curve {through_lower[i]} = lower_count + 1 Using Progression mound_ratio;
EndFor
For i In {wall_line[0] : wall_line[1]}
  through_dry[i] = newl; Line(through_dry[i]) = {at_dry[i], at_top[i]};
  Transfinite Curve {through_dry[i]} = dry_rows + 1;
  If (has_sea)
    through_wet[i] = newl; Line(through_wet[i]) = {at_crest[i], at_dry[i]};
    Transfinite Curve {through_wet[i]} = sea_rows + 1;
  EndIf
EndFor

// -------------------------------------------------------------------------------------------------- surfaces
seabed[] = {};
If (has_seabed)
  For i In {0 : last_line - 1}
    loop = newll; Curve Loop(loop) = {through_seabed[i], along_base[i], -through_seabed[i + 1], -along_bed[i]};
    seabed[i] = news; Plane Surface(seabed[i]) = {loop};
  EndFor
EndIf
mound[] = {};
For i In {crest_line[0] : crest_line[1] - 1}
  loop = newll; Curve Loop(loop) = {through_lower[i], along_bed[i], -through_lower[i + 1], -along_middle[i]};
  block = news; mound[] += block; Plane Surface(block) = {loop};
  Transfinite Surface {block};
  loop = newll; Curve Loop(loop) = {through_upper[i], along_middle[i], -through_upper[i + 1], -along_crest[i]};
  block = news; mound[] += block; Plane Surface(block) = {loop};
  Transfinite Surface {block};
EndFor
caisson[] = {};
For i In {wall_line[0] : wall_line[1] - 1}
  loop = newll; Curve Loop(loop) = {along_dry[i], through_dry[i + 1], -along_top[i], -through_dry[i]};
  block = news; caisson[] += block; Plane Surface(block) = {loop};
  If (has_sea)
    loop = newll; Curve Loop(loop) = {along_crest[i], through_wet[i + 1], -along_dry[i], -through_wet[i]};
    block = news; caisson[] += block; Plane Surface(block) = {loop};
  EndIf
EndFor

// The parapet stands on the seaward column, or on both where it is as wide as the caisson.
over_front[] = {}; over_back[] = {}; over_top[] = {along_top[wall_line[0]], along_top[middle_line]};
If (has_parapet)
  last_parapet = middle_line;
  If (is_wide)
    last_parapet = wall_line[1];
  EndIf
  For i In {wall_line[0] : last_parapet}
    at_parapet[i] = newp; Point(at_parapet[i]) = {x[i], mound_height + caisson_height + parapet_height, 0};
    through_parapet[i] = newl; Line(through_parapet[i]) = {at_top[i], at_parapet[i]};
    Transfinite Curve {through_parapet[i]} = parapet_rows + 1;
  EndFor
  For i In {wall_line[0] : last_parapet - 1}
    from = at_parapet[i]; to = at_parapet[i + 1];
    Call Along;
    over_top[i - wall_line[0]] = along;
    loop = newll; Curve Loop(loop) = {along_top[i], through_parapet[i + 1], -along, -through_parapet[i]};
    block = news; caisson[] += block; Plane Surface(block) = {loop};
  EndFor
  over_front[] = {through_parapet[wall_line[0]]};
  If (is_wide)
    over_back[] = {through_parapet[last_parapet]};
  Else
    over_top[] += {through_parapet[last_parapet]};
  EndIf
EndIf

// The slopes: triangles toe - foot of the crest - edge of the crest, each of three blocks about a point `centre`. The
// cut on the slope and the centre follow from the cuts of the other two sides (Ceva), so that the blocks keep in shape.
top_weight = middle / (mound_height - middle);
For side In {0 : 1}
  t = toe_line[side]; m = inner_line[side]; c = crest_line[side];
  sign = 2 * side - 1;
  toe_weight = inner[side] / (foot[side] - inner[side]);
  weights = toe_weight + 1 + top_weight;
  cut_x[side] = x[c] + sign * foot[side] * toe_weight / (toe_weight + top_weight);
  cut[side] = newp; Point(cut[side]) = {cut_x[side], mound_height * top_weight / (toe_weight + top_weight), 0};
  centre = newp;
  Point(centre) = {x[c] + sign * foot[side] * toe_weight / weights, mound_height * top_weight / weights, 0};

  slope_lower[side] = newl; Line(slope_lower[side]) = {at_bed[t], cut[side]};
  slope_upper[side] = newl; Line(slope_upper[side]) = {cut[side], at_crest[c]};
  to_foot = newl; Line(to_foot) = {centre, at_bed[m]};
  to_crest_line = newl; Line(to_crest_line) = {centre, at_middle[c]};
  to_slope = newl; Line(to_slope) = {centre, cut[side]};
  Transfinite Curve {slope_lower[side], to_foot} = lower_count + 1;
  Transfinite Curve {slope_upper[side], to_crest_line} = inner_count[side] + 1;
  Transfinite Curve {to_slope} = upper_count + 1;

  // Towards the toe the bed's columns are outwards on the landward side and inwards on the seaward one.
  If (side == 0)
    toe_to_foot = along_bed[t]; foot_to_crest = along_bed[m];
  Else
    toe_to_foot = -along_bed[m]; foot_to_crest = -along_bed[c];
  EndIf
  loop = newll; Curve Loop(loop) = {toe_to_foot, -to_foot, to_slope, -slope_lower[side]};
  block = news; mound[] += block; Plane Surface(block) = {loop};
  Transfinite Surface {block} = {at_bed[t], at_bed[m], centre, cut[side]};
  loop = newll; Curve Loop(loop) = {foot_to_crest, -through_lower[c], -to_crest_line, to_foot};
  block = news; mound[] += block; Plane Surface(block) = {loop};
  Transfinite Surface {block} = {at_bed[m], at_bed[c], at_middle[c], centre};
  loop = newll; Curve Loop(loop) = {to_crest_line, -through_upper[c], -slope_upper[side], -to_slope};
  block = news; mound[] += block; Plane Surface(block) = {loop};
  Transfinite Surface {block} = {centre, at_middle[c], at_crest[c], cut[side]};
EndFor

// The seas: four blocks each, from the wall outwards: over the berm, the slope's two parts and the far column.
// Their upright lines are 0 at the wall, 1 at the crest's edge, 2 at the cut of the slope, 3 at the toe, 4 at the end.
sea_surface[] = {};
For side In {0 : 1}
  If (sea[side] > 0)
    sign = 2 * side - 1;
    w = wall_line[side]; c = crest_line[side]; t = toe_line[side]; e = t + sign;
    // On the seaward side a column has the number of its outer line, on the landward side that of its inner one.
    berm = Min(w, c); end = Min(t, e);
    bottom[] = {sign * along_crest[berm], -slope_upper[side], -slope_lower[side], sign * along_bed[end]};
    bottom_count[] = {berm_count[side], inner_count[side], lower_count, far_count[side]};
    bottom_ratio[] = {berm_ratio[side], 1, 1, far_ratio[side]};
    foot_point[] = {at_crest[w], at_crest[c], cut[side], at_bed[t], at_bed[e]};
    foot_x[] = {x[w], x[c], cut_x[side], x[t], x[e]};
    level[] = {at_dry[w]};
    upright[] = {through_wet[w]};
    For j In {0 : 3}
      level[j + 1] = newp; Point(level[j + 1]) = {foot_x[j + 1], water[side], 0};
      upright[j + 1] = newl; Line(upright[j + 1]) = {foot_point[j + 1], level[j + 1]};
      Transfinite Curve {upright[j + 1]} = sea_rows + 1;
      surface = newl; sea_surface[] += surface; Line(surface) = {level[j], level[j + 1]};
      Transfinite Curve {surface} = bottom_count[j] + 1 Using Progression bottom_ratio[j];
      loop = newll; Curve Loop(loop) = {bottom[j], upright[j + 1], -surface, -upright[j]};
      sea_block[4 * side + j] = news; Plane Surface(sea_block[4 * side + j]) = {loop};
      Transfinite Surface {sea_block[4 * side + j]};
    EndFor
    sea_end[side] = upright[4];
  EndIf
EndFor

// The subsoil continues the seabed's columns; sides and base then are those of both. On a rigid floor only what has a
// sea above it is a bed; the rest of the floor's lines belongs to nothing.
ground_base[] = {along_bed[{toe_line[0] : toe_line[1] - 1}]};
bed[] = {};
If (sea_front > 0)
  bed[] += {along_bed[toe_line[0] - 1]};
EndIf
If (sea_back > 0)
  bed[] += {along_bed[toe_line[1]]};
EndIf
If (has_seabed)
  ground_left[] = {through_seabed[0]};
  ground_right[] = {through_seabed[last_line]};
  ground_base[] = along_base[];
  bed[] = {along_bed[{0 : toe_line[0] - 1}], along_bed[{toe_line[1] : last_line - 1}]};
EndIf
subsoil[] = {};
If (subsoil_depth > 0)
  ground_base[] = {};
  For i In {0 : last_line}
    at_rock[i] = newp; Point(at_rock[i]) = {x[i], -seabed_depth - subsoil_depth, 0};
    through_subsoil[i] = newl; Line(through_subsoil[i]) = {at_base[i], at_rock[i]};
    Transfinite Curve {through_subsoil[i]} = subsoil_count + 1 Using Progression subsoil_ratio;
  EndFor
  For i In {0 : last_line - 1}
    from = at_rock[i]; to = at_rock[i + 1];
    Call Along;
    ground_base[] += along;
    loop = newll; Curve Loop(loop) = {through_subsoil[i], along, -through_subsoil[i + 1], -along_base[i]};
    block = news; subsoil[] += block; Plane Surface(block) = {loop};
  EndFor
  ground_left[] += through_subsoil[0];
  ground_right[] += through_subsoil[last_line];
EndIf
Transfinite Surface {seabed[], caisson[], subsoil[]};
Recombine Surface {:};

// ----------------------------------------------------------------------------------------------------- names
If (has_seabed)
  Physical Surface("seabed") = seabed[];
  Physical Curve("left") = ground_left[];
  Physical Curve("right") = ground_right[];
EndIf
If (subsoil_depth > 0)
  Physical Surface("subsoil") = subsoil[];
EndIf
Physical Surface("mound") = mound[];
Physical Surface("caisson") = caisson[];

If (sea_front > 0)
  Physical Surface("sea_front") = sea_block[{0 : 3}];
EndIf
If (sea_back > 0)
  Physical Surface("sea_back") = sea_block[{4 : 7}];
EndIf

front[] = {through_dry[wall_line[0]], over_front[]};
back[] = {through_dry[wall_line[1]], over_back[]};
If (has_sea)
  front[] += through_wet[wall_line[0]];
  back[] += through_wet[wall_line[1]];
EndIf
Physical Curve("base") = ground_base[];
If (has_seabed || has_sea)
  Physical Curve("bed") = bed[];
EndIf
Physical Curve("mound_surface") = {slope_lower[], slope_upper[], along_crest[crest_line[0]], along_crest[wall_line[1]]};
Physical Curve("front") = front[];
Physical Curve("back") = back[];
Physical Curve("top") = over_top[];
Physical Curve("bottom") = {along_crest[wall_line[0]], along_crest[middle_line]};
If (has_sea)
  Physical Curve("sea_surface") = sea_surface[];
EndIf
If (sea_front > 0)
  Physical Curve("sea_left") = {sea_end[0]};
EndIf
If (sea_back > 0)
  Physical Curve("sea_right") = {sea_end[1]};
EndIf
