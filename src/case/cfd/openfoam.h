// What OpenFOAM's function objects leave below postProcessing/NAME/START.
#pragma once

#include "case/cfd/flow_record.h"

namespace upbead {

/// A folder named after a time, below the folder of a function object; or a single file that lies in no such folder.
struct FlowFolder {
  std::string name;   ///< of the folder: the time of its start
  std::string path;   ///< of the folder
  double start = 0.;  ///< s
};

/// Subfolders named after a time, by ascending time.
std::vector<FlowFolder> time_folders(const std::string& path);

/// Forces of all runs: forces.dat, or force.dat with moment.dat; `file` is one of their names.
void read_openfoam_forces(const std::vector<FlowFolder>& folders, const std::string& file, const Place& place,
                          FlowRecord& record);

/// Probes: a file named after its field.
void read_openfoam_probes(const std::vector<FlowFolder>& folders, const std::string& file, const Place& place,
                          FlowRecord& record);

/// A sampled patch, surfaceFormat raw: FIELD_SURFACE.raw in a folder per time.
void read_openfoam_patch(const std::vector<FlowFolder>& folders, const std::string& file, const Place& place,
                         FlowRecord& record);

}  // namespace upbead
