// Tables of DualSPHysics, Proteus and SWASH.
#pragma once

#include "case/cfd/flow_record.h"
#include "case/cfd/flow_text.h"

namespace upbead {

/// Whether the first line of a file, unchanged, begins a table of this program.
bool is_dualsphysics(std::string_view line);
bool is_proteus(std::string_view line);

/// Reads the table of a force gauge, of ComputeForces, or of MeasureTool.
void read_dualsphysics(const std::string& path, const Place& place, FlowRecord& record);

/// Pressures at points, in columns `p [ x y z]`.
void read_proteus(const std::string& path, const Place& place, FlowRecord& record);

/// Reads a table without header and times: the file INPUT beside it gives both. False where there is no such file, or
/// where it does not mention the table.
bool read_swash(const std::string& path, const Place& place, FlowRecord& record);

}  // namespace upbead
