// A checkpoint of a march as an HDF5 file: every number is kept to the last bit.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "upbead/dynamics/march.h"

namespace upbead {

struct CheckpointFile {
  std::uint64_t fingerprint = 0;  ///< of everything on which the march depends
  MarchCheckpoint march;
  std::vector<std::pair<double, std::string>> fields;  ///< time (s) and name of the files written so far
};

/// The bytes of the file, made in memory.
std::string checkpoint_file(const std::string& title, const CheckpointFile& checkpoint);

/// Throws InputError where the file cannot be read or is not a complete checkpoint.
CheckpointFile read_checkpoint(const std::string& path);

}  // namespace upbead
