// The family of a model of soils in its file.
#pragma once

#include "output/model_parts.h"
#include "output/soil_model_file.h"

namespace upbead::detail {

/// A symmetric matrix in coordinates of two kinds, as blocks: those that are zero are left out, of those on the
/// diagonal the lower triangle is written, and of the two others the one whose rows are displacements. Throws
/// std::logic_error where it is not symmetric.
void write_blocks(Hdf5Image& image, const std::string& path, const Eigen::MatrixXd& matrix,
                  const std::vector<bool>& is_phi);
/// Reads the same; empty where there is no block.
Eigen::MatrixXd read_blocks(ModelParts& parts, const std::string& path, const std::vector<bool>& is_phi);

/// Writes a family in a group.
void write_family(Hdf5Image& image, const std::string& group, const SoilFamilyFile& family);
/// Reads the same, and notes mistakes.
SoilFamilyFile read_family(ModelParts& parts, const std::string& group);

}  // namespace upbead::detail
