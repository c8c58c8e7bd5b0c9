// A checkpoint of a march as an HDF5 file: every number as it was, to the last bit.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "upbead/dynamics/march.h"

namespace upbead {

struct CheckpointFile {
  std::uint64_t fingerprint = 0;  ///< of all that the march rests on
  MarchCheckpoint march;
  std::vector<std::pair<double, std::string>> fields;  ///< time (s) and name of the files written so far
};

/// The bytes of the file, made in memory.
std::string checkpoint_file(const std::string& title, const CheckpointFile& checkpoint);

/// Throws InputError where the file cannot be read or is not a whole checkpoint.
CheckpointFile read_checkpoint(const std::string& path);

}  // namespace upbead
