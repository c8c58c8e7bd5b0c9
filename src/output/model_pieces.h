// Matrices and names in the file of a reduced model.
#pragma once

#include "hdf5_image.h"
#include "model_parts.h"
#include "upbead/dynamics/modal_model.h"

namespace upbead::detail {

/// Row by row.
void write_matrix(Hdf5Image& image, const std::string& path, const Eigen::MatrixXd& values, const Label& label);

/// Names, units and descriptions of readings, in a group of their own.
void write_labels(Hdf5Image& image, const std::string& group, const std::vector<ReadingLabel>& labels);
/// The same from a file; what is wrong is noted.
std::vector<ReadingLabel> read_labels(ModelParts& parts, const std::string& group);

}  // namespace upbead::detail
