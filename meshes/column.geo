// A column of soil: a rectangle with its base at y = 0.
//
//        top
//       +----+  height
//  left |soil| right
//       +----+  0
//        base

DefineConstant[
  height = 10,       // m: height of the column
  width = 1,         // m: width of the column
  cells = 20,        // -: cells over the height
  cells_across = 1,  // -: cells over the width
  grading = 1        // -: size of the lowest cell over that of the highest; 1 makes all alike
];

mistakes = 0;
Macro MustBePositive
  If (!(value > 0))
    Error(StrCat(name, " is %g; it must be greater than 0"), value);
    mistakes = 1;
  EndIf
Return
name = "height"; value = height;
Call MustBePositive;
name = "width"; value = width;
Call MustBePositive;
name = "grading"; value = grading;
Call MustBePositive;
Macro MustBeACount
  If (!(value >= 1 && value <= 100000))
    Error(StrCat(name, " is %g; it must be from 1 to 100000"), value);
    mistakes = 1;
  EndIf
Return
name = "cells"; value = cells;
Call MustBeACount;
name = "cells_across"; value = cells_across;
Call MustBeACount;
If (mistakes)
  Abort;
EndIf

rows = Round(cells);
columns = Round(cells_across);
If (rows > 1)
  ratio = grading^(-1 / (rows - 1));
Else
  ratio = 1;
EndIf

Point(1) = {0, 0, 0};
Point(2) = {width, 0, 0};
Point(3) = {width, height, 0};
Point(4) = {0, height, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {4, 3};
Line(4) = {1, 4};
Transfinite Curve {1, 3} = columns + 1;
Transfinite Curve {2, 4} = rows + 1 Using Progression ratio;
Curve Loop(1) = {1, 2, -3, -4};
Plane Surface(1) = {1};
Transfinite Surface {1};
Recombine Surface {1};

Physical Surface("soil") = {1};
Physical Curve("base") = {1};
Physical Curve("right") = {2};
Physical Curve("top") = {3};
Physical Curve("left") = {4};
