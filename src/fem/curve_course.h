// The course of a curve through its points.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "upbead/mesh/mesh.h"
#include "upbead/model/scene.h"

namespace upbead {

/// Points (x, y) of a curve of the mesh from its seaward end (of two as far seaward the lower one) to the other; empty
/// where it is not one open line.
std::vector<std::array<double, 2>> course_of(const Mesh& mesh, const std::string& curve);

/// Tells the loads whose shapes run along a curve where that runs.
void follow_curves(const Mesh& mesh, Scene& scene);

}  // namespace upbead
