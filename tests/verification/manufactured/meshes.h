// Three families of quadrilaterals on the rectangle of a manufactured solution.
#pragma once

#include <memory>

#include "mms.h"

namespace upbead::test {

/// Each family has cells of the same shapes at every level: none becomes affine as h falls, and no new random draw
/// per level disturbs the order. (With one draw per level even the interpolant of p shows 2.89 instead of 3 from 4 to
/// 16 cells.)
///   uniform     squares
///   perturbed   blocks of 2 x 2 squares with straight outer edges and vertices moved by up to a quarter of their side,
///               at random, by the same numbers in every block
///   trapezoid   similar trapezoids whose parallel sides are as 3 to 5 [Arnold, Boffi and Falk 2002, Math. Comp. 71,
///               909-922: elements that lack a part of the mapped polynomials lose order on such meshes]
enum class Quads { uniform, perturbed, trapezoid };

const char* name_of(Quads quads);

/// Cells of mean side h; the sides of the rectangle and the interface stay straight. 2 h must divide their distances.
std::unique_ptr<Mesh> quadrilaterals(const Manufactured& mms, Quads quads, double h);

}  // namespace upbead::test
