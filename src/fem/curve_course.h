// The points of a curve in order.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "upbead/mesh/mesh.h"
#include "upbead/model/scene.h"

namespace upbead {

/// Points (x, y) of a curve of the mesh, from its seaward end (if both ends have the same x, the lower one) to the
/// other end; empty where the curve is not one open line.
std::vector<std::array<double, 2>> course_of(const Mesh& mesh, const std::string& curve);

/// Gives the loads whose shapes follow a curve the points of that curve.
void follow_curves(const Mesh& mesh, Scene& scene);

}  // namespace upbead
