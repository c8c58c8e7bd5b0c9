// A mesh's mirror image.
#pragma once

#include "upbead/mesh/mesh.h"

namespace upbead::test {

/// Mirrors the mesh about x = 0; names stay with their cells and faces, so `front` then looks landward. The mesh must
/// have been refined uniformly or not at all.
void mirror(Mesh& mesh);

}  // namespace upbead::test
