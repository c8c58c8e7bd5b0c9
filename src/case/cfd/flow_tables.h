// Tables of DualSPHysics, Proteus and SWASH.
#pragma once

#include "case/cfd/flow_record.h"
#include "case/cfd/flow_text.h"

namespace upbead {

/// Whether the first line of a file is one of such a table; `line` as it is.
bool is_dualsphysics(std::string_view line);
bool is_proteus(std::string_view line);

/// Force gauge, ComputeForces, or MeasureTool.
void read_dualsphysics(const std::string& path, const Place& place, FlowRecord& record);

/// Pressures at points, in columns `p [ x y z]`.
void read_proteus(const std::string& path, const Place& place, FlowRecord& record);

/// A table without header and times: both stand in the file INPUT beside it. False where there is no such file, or
/// where it does not know the table.
bool read_swash(const std::string& path, const Place& place, FlowRecord& record);

}  // namespace upbead
