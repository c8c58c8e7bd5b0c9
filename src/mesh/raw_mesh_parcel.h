// A mesh on its way out of the confined process that read it.
#pragma once

#include <optional>

#include "base/parcel.h"
#include "raw_mesh.h"

namespace upbead {

void put(Parcel& parcel, const RawMesh& mesh);

/// None where its numbers do not fit together, as where the process was in the hands of the file.
std::optional<RawMesh> take_mesh(OpenParcel& parcel);

}  // namespace upbead
