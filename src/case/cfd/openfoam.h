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

/// The start in the name of a file such as force_0.8.dat, which OpenFOAM writes where a run found force.dat there.
std::optional<double> start_in(const std::string& name);

/// Names of `file` and of such files of other runs in a folder, by ascending start.
std::vector<std::string> runs_in(const std::string& folder, const std::string& file);

/// Forces of all runs: forces.dat, or force.dat with moment.dat; `file` is one of their names.
void read_openfoam_forces(const std::vector<FlowFolder>& folders, const std::string& file, const Place& place,
                          FlowRecord& record);

/// Probes: a file named after its field.
void read_openfoam_probes(const std::vector<FlowFolder>& folders, const std::string& file, const Place& place,
                          FlowRecord& record);

/// A sampled patch in a folder per time: FIELD_SURFACE.raw (surfaceFormat raw), or SURFACE.xy as of version 9 of the
/// OpenFOAM Foundation.
void read_openfoam_patch(const std::vector<FlowFolder>& folders, const std::string& file, const Place& place,
                         FlowRecord& record);

/// Throws InputError where a file is an output of OpenFOAM that is known and holds neither forces nor pressures at
/// points: names what it is, and what to write instead.
void refuse_other_output(const std::string& path, const Place& place);

}  // namespace upbead
