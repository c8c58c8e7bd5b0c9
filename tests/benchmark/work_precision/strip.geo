// Two layers of soil under a rigid strip, as in tests/reference/ref2d_poro_strip.json, in quadrilaterals only.
//
//                +-------+               y = 0: the strip's bottom
//                |caisson|
//  +-------------+-------+-------------+
//  |             layer0                |   layer0, layer1: the soils, 5 m and 15 m
//  +-------------+-------+-------------+
//  |             layer1                |
//  +-----------------------------------+

DefineConstant[
  cells = 1,     // -: relative density of cells
  grading = 60   // -: size of the cells at 10 m from the strip's edges over that at the edges
];

half = 10;
width = 200;
near_size = 3 / cells;
far_size = 12 / cells;
skin = 0.1 / cells;  // cells at the top of the lower layer

// A line of `length` whose cells grow from `first` to `last`.
Macro Grow
  If (Fabs(last / first - 1) < 1e-9)
    count = length / last;
  Else
    count = length * Log(last / first) / (last - first);
  EndIf
  count = Max(2, Round(count + 1e-6));
  ratio = (last / first)^(1 / count);
Return

first = near_size / grading; last = near_size; length = half;
Call Grow;
near_count = count; near_ratio = ratio;
first = near_size; last = far_size; length = width - half;
Call Grow;
far_count = count; far_ratio = ratio;
first = near_size / grading; last = 0.5 * near_size; length = 5;
Call Grow;
count0 = count; ratio0 = ratio;
first = skin; last = near_size; length = 15;
Call Grow;
count1 = count; ratio1 = ratio;

x[] = {-half - width, -2 * half, -half, 0, half, 2 * half, half + width};
count_x[] = {far_count, near_count, near_count, near_count, near_count, far_count};
ratio_x[] = {1 / far_ratio, 1 / near_ratio, near_ratio, 1 / near_ratio, near_ratio, far_ratio};
y[] = {0, -5, -20};
count_y[] = {count0, count1};
ratio_y[] = {ratio0, ratio1};

For j In {0 : 2}
  For i In {0 : 6}
    at[7 * j + i] = newp; Point(at[7 * j + i]) = {x[i], y[j], 0};
  EndFor
EndFor
For i In {2 : 4}
  over[i] = newp; Point(over[i]) = {x[i], 5, 0};
EndFor
For j In {0 : 2}
  For i In {0 : 5}
    along[6 * j + i] = newl; Line(along[6 * j + i]) = {at[7 * j + i], at[7 * j + i + 1]};
    Transfinite Curve {along[6 * j + i]} = count_x[i] + 1 Using Progression ratio_x[i];
  EndFor
EndFor
For j In {0 : 1}
  For i In {0 : 6}
    down[7 * j + i] = newl; Line(down[7 * j + i]) = {at[7 * j + i], at[7 * (j + 1) + i]};
    Transfinite Curve {down[7 * j + i]} = count_y[j] + 1 Using Progression ratio_y[j];
  EndFor
EndFor
For i In {2 : 3}
  top[i] = newl; Line(top[i]) = {over[i], over[i + 1]};
  Transfinite Curve {top[i]} = count_x[i] + 1 Using Progression ratio_x[i];
EndFor
For i In {2 : 4}
  up[i] = newl; Line(up[i]) = {at[i], over[i]};
  Transfinite Curve {up[i]} = 3;
EndFor

For j In {0 : 1}
  For i In {0 : 5}
    loop = newll;
    Curve Loop(loop) = {-along[6 * j + i], down[7 * j + i], along[6 * (j + 1) + i], -down[7 * j + i + 1]};
    block[6 * j + i] = news; Plane Surface(block[6 * j + i]) = {loop};
  EndFor
EndFor
For i In {2 : 3}
  loop = newll;
  Curve Loop(loop) = {along[i], up[i + 1], -top[i], -up[i]};
  caisson[i] = news; Plane Surface(caisson[i]) = {loop};
EndFor
Transfinite Surface {block[{0 : 11}], caisson[2], caisson[3]};
Recombine Surface {block[{0 : 11}], caisson[2], caisson[3]};

Physical Surface("layer0") = {block[{0 : 5}]};
Physical Surface("layer1") = {block[{6 : 11}]};
Physical Surface("caisson") = {caisson[2], caisson[3]};
Physical Curve("rock") = {along[{12 : 17}]};
Physical Curve("far") = {down[0], down[7], down[6], down[13]};
Physical Curve("bed") = {along[0], along[1], along[4], along[5]};
Physical Curve("wall") = {up[2], up[4], top[2], top[3]};
