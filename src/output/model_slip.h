// The part of a reduced model's file that lets the caisson slip: the group /slip.
#pragma once

#include "hdf5_image.h"
#include "model_parts.h"
#include "upbead/output/model_file.h"

namespace upbead::detail {

void write_slip(Hdf5Image& image, const ModelSlip& slip);

/// None where the file has no such group; what is wrong with it is noted.
std::optional<ModelSlip> read_slip(ModelParts& parts);

}  // namespace upbead::detail
