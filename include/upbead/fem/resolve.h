// Decides what a scene leaves open, from its numbers on its mesh, and leaves out what does not matter.
#pragma once

#include <string>
#include <vector>

#include "upbead/fem/soil_state.h"
#include "upbead/mesh/mesh.h"
#include "upbead/model/scene.h"

namespace upbead {

/// One decision about one region.
struct Decision {
  std::string region;    ///< "" of the whole mesh
  std::string key;       ///< of the case, which sets it or could: "flow"
  std::string value;     ///< as in the case: "darcy"
  std::string why;       ///< for people, with the number that decided
  std::string left_out;  ///< for people: "relative inertia of the pore water in mound"; "" where nothing is left out
};

struct ResolvedScene {
  Scene scene;  ///< nothing is `automatic` in its regions
  std::vector<Decision> decisions;
  SoilState soil;            ///< by cell, where stiffness depends on stress; the region itself then has the largest G
  std::vector<bool> absent;  ///< cells to leave out, by active cell index; empty: none
};

/// Decides flow, deformation and compressibility of every region where the case says "auto", by the rules of
/// model/choices.h; leaves out water that touches nothing, and cells that are too far away: no wave from the loads can
/// reach them and come back to a reading before the end. The scene must have passed check_scene on this mesh.
ResolvedScene resolve(const Scene& scene, const Mesh& mesh);

}  // namespace upbead
