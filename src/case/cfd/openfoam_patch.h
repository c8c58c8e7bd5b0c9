// Sampled patches at one time: the file of a folder, in either of its layouts.
#pragma once

#include "case/cfd/flow_record.h"

namespace upbead {

struct PatchFile {
  std::string field;
  bool faces = false, vertices = false;  ///< what the points are; neither where the file does not say it
  std::vector<Triple> at;
  std::vector<double> value;
};

/// Reads a table with places and fields in its columns, SURFACE.xy or SET.xy. Throws InputError where it does not
/// tell the places.
PatchFile read_xy_file(const std::string& path, const Place& place, FlowNotes& notes);

}  // namespace upbead
