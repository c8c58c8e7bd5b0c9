// The sides where a mesh ends although the ground goes on.
#pragma once

#include <map>
#include <set>
#include <string>

#include "upbead/mesh/mesh.h"

namespace upbead {

/// Names of the outer curves that are upright lines and do not belong to the caisson, and of the surfaces behind them.
std::map<std::string, std::set<std::string>> far_sides(const Mesh& mesh);

}  // namespace upbead
