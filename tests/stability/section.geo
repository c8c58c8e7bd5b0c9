// Three columns and up to four rows of blocks, for the scenes of the stability map; any row may be thin.
//
//                   top
//                +---------+
//                | caisson |  dry_height                 x = 0: the left side
//     sea_surface|         |                             y = 0: the ground's surface
//     +----------+ - - - - +----------+
//     |sea_front |         | sea_back |  wet_height      sea_left, sea_right: outer ends of the sea
//     +----------+--bottom-+----------+
//     | upper    | pad     |  upper   |  upper_height    bed: the ground's surface but for the bottom
//     +----------+---------+----------+                  left, base, right
//     | lower    | lower   |  lower   |  lower_height
//     +----------+---------+----------+
//
// Without a caisson, sea_front is one sea over all columns. Without a pad, upper goes through.

DefineConstant[
  left_width = 2,    // m
  middle_width = 2,  // m
  right_width = 2,   // m
  lower_height = 1,  // m
  upper_height = 1,  // m
  wet_height = 1,    // m: depth of the sea, and of the caisson's wet part
  dry_height = 1,    // m: the caisson's dry part
  skew = 0,          // -: how far the line between lower and upper is bent, over the blocks' size; below 0.5
  columns_left = 1,  // -: cells of each column
  columns_middle = 2,
  columns_right = 1,
  rows_lower = 1,    // -: cells of each row
  rows_upper = 1,
  rows_wet = 1,
  rows_dry = 1,
  pad = 0,           // -: 1: the middle block of the upper row is a region of its own
  caisson = 1,       // -: 1: with a caisson
  sea_front = 0,     // -: 1: with a sea to the left, or over all columns
  sea_back = 0       // -: 1: with a sea to the right of a caisson
];

// A slip of the pen must not make millions of cells.
most = 200;
If (Max(columns_left, Max(columns_middle, columns_right)) > most || Max(Max(rows_lower, rows_upper), Max(rows_wet, rows_dry)) > most)
  Error("a column or a row has more than %g cells", most);
  Abort;
EndIf

columns[] = {columns_left, columns_middle, columns_right};
rows[] = {rows_lower, rows_upper, rows_wet, rows_dry};
x[] = {0, left_width, left_width + middle_width, left_width + middle_width + right_width};
y[] = {-lower_height - upper_height, -upper_height, 0, wet_height, wet_height + dry_height};
bend_x = skew * Min(left_width, Min(middle_width, right_width));
bend_y = skew * Min(lower_height, upper_height);

For i In {0 : 3}
  For j In {0 : 4}
    p[5 * i + j] = newp;
    If (j == 1)
      side = 1 - 2 * (i % 2);
      along = (i == 0 || i == 3) ? 0 : bend_x;
      Point(p[5 * i + j]) = {x[i] + side * along, y[j] + side * bend_y, 0};
    Else
      Point(p[5 * i + j]) = {x[i], y[j], 0};
    EndIf
  EndFor
EndFor

// Which blocks there are: 1, by column and row.
For i In {0 : 2}
  there[4 * i] = 1;
  there[4 * i + 1] = 1;
  there[4 * i + 2] = 0;
  there[4 * i + 3] = 0;
EndFor
If (caisson)
  there[6] = 1;
  there[7] = 1;
  there[2] = sea_front;
  there[10] = sea_back;
Else
  there[2] = sea_front;
  there[6] = sea_front;
  there[10] = sea_front;
EndIf

// Lines along x (number 5 i + j, block i, line j) and upright ones (4 i + j, line i, block j), where a block needs them.
For i In {0 : 2}
  For j In {0 : 4}
    needed = 0;
    If (j < 4)
      needed = there[4 * i + j];
    EndIf
    If (j > 0)
      needed = Max(needed, there[4 * i + j - 1]);
    EndIf
    level[5 * i + j] = 0;
    If (needed)
      l = newl;
      Line(l) = {p[5 * i + j], p[5 * (i + 1) + j]};
      Transfinite Curve {l} = columns[i] + 1;
      level[5 * i + j] = l;
    EndIf
  EndFor
EndFor
For i In {0 : 3}
  For j In {0 : 3}
    needed = 0;
    If (i < 3)
      needed = there[4 * i + j];
    EndIf
    If (i > 0)
      needed = Max(needed, there[4 * (i - 1) + j]);
    EndIf
    upright[4 * i + j] = 0;
    If (needed)
      l = newl;
      Line(l) = {p[5 * i + j], p[5 * i + j + 1]};
      Transfinite Curve {l} = rows[j] + 1;
      upright[4 * i + j] = l;
    EndIf
  EndFor
EndFor

For i In {0 : 2}
  For j In {0 : 3}
    block[4 * i + j] = 0;
    If (there[4 * i + j])
      loop = newll;
      Curve Loop(loop) = {level[5 * i + j], upright[4 * (i + 1) + j], -level[5 * i + j + 1], -upright[4 * i + j]};
      s = news;
      Plane Surface(s) = {loop};
      Transfinite Surface {s};
      Recombine Surface {s};
      block[4 * i + j] = s;
    EndIf
  EndFor
EndFor

Physical Surface("lower") = {block[0], block[4], block[8]};
If (pad)
  Physical Surface("upper") = {block[1], block[9]};
  Physical Surface("pad") = {block[5]};
Else
  Physical Surface("upper") = {block[1], block[5], block[9]};
EndIf
Physical Curve("base") = {level[0], level[5], level[10]};
Physical Curve("left") = {upright[0], upright[1]};
Physical Curve("right") = {upright[12], upright[13]};
If (caisson)
  Physical Surface("caisson") = {block[6], block[7]};
  Physical Curve("bed") = {level[2], level[12]};
  Physical Curve("bottom") = {level[7]};
  Physical Curve("front") = {upright[6], upright[7]};
  Physical Curve("back") = {upright[10], upright[11]};
  Physical Curve("top") = {level[9]};
  If (sea_front)
    Physical Surface("sea_front") = {block[2]};
    Physical Curve("sea_left") = {upright[2]};
  EndIf
  If (sea_back)
    Physical Surface("sea_back") = {block[10]};
    Physical Curve("sea_right") = {upright[14]};
  EndIf
  If (sea_front && sea_back)
    Physical Curve("sea_surface") = {level[3], level[13]};
  ElseIf (sea_front)
    Physical Curve("sea_surface") = {level[3]};
  ElseIf (sea_back)
    Physical Curve("sea_surface") = {level[13]};
  EndIf
Else
  Physical Curve("bed") = {level[2], level[7], level[12]};
  If (sea_front)
    Physical Surface("sea_front") = {block[2], block[6], block[10]};
    Physical Curve("sea_left") = {upright[2]};
    Physical Curve("sea_right") = {upright[14]};
    Physical Curve("sea_surface") = {level[3], level[8], level[13]};
  EndIf
EndIf
