// Sums of modes in the file of a reduced model: the groups /modes and /nested.
#pragma once

#include "hdf5_image.h"
#include "model_parts.h"
#include "upbead/output/model_file.h"

namespace upbead::detail {

/// Poles, loads and readings of modes in a group.
void write_modes(Hdf5Image& image, const std::string& group, const ModalModel& modes);
/// Of a group, for the loads and readings that `modes` names; what is wrong is noted.
void read_modes(ModelParts& parts, const std::string& group, ModalModel& modes);

void write_nested(Hdf5Image& image, const NestedModels& nested);
/// None where the file has no such group. `modes`: the model that they are larger than.
std::optional<NestedModels> read_nested(ModelParts& parts, const ModalModel& modes);

}  // namespace upbead::detail
