// Loads of CFD records in the scene. A force whose moment has a course of its own becomes two forces landward, low and
// high, whose sum and moment are the record's at every time.
#pragma once

#include "upbead/case/case.h"

namespace upbead {

struct Mesh;

/// Adds a force `flow` to the scene as the load `load` of that name; on a boundary with moments as two pieces without
/// histories, which follow with the mesh.
void add_flow_force(const std::string& name, const Load& load, const FlowLoad& flow, Scene& scene);

/// Gives the pieces on boundaries their shapes and histories. Throws InputError, at keys of the case, where a boundary
/// is level, where a point of a record lies too far from its boundary, or where water stands above the wall.
void place_flows(const Case& input, const Mesh& mesh, Scene& scene);

/// Warnings of the records' forces, and of those that are zero within the run.
NumberedWarnings flow_warnings(const Case& input);

struct FlowSummary;
std::vector<FlowSummary> flow_summaries(const Case& input);

}  // namespace upbead
