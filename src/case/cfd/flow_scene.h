// Loads of CFD records in the scene. Where the moment is not proportional to the force, the force becomes two
// landward forces, low and high, whose sum and moment are the record's at every time.
#pragma once

#include "upbead/case/case.h"

namespace upbead {

struct Mesh;

/// Adds the force `flow` to the scene as the load `load` of that name. On a boundary, a force with moments is added
/// as two pieces whose histories are set once the mesh is known.
void add_flow_force(const std::string& name, const Load& load, const FlowLoad& flow, Scene& scene);

/// Gives the pieces on boundaries their shapes and histories. Throws InputError, at keys of the case, where a
/// boundary is level, where a point of a record lies too far from its boundary, or where the water rises above the
/// wall.
void place_flows(const Case& input, const Mesh& mesh, Scene& scene);

/// Warnings of the records' forces, and of records that are zero within the run.
NumberedWarnings flow_warnings(const Case& input);

/// flow_arm_outside: forces whose resultant lies above or below the wall or region that they act on.
NumberedWarnings flow_arm_warnings(const Case& input, const Mesh& mesh);

struct FlowSummary;
std::vector<FlowSummary> flow_summaries(const Case& input);

}  // namespace upbead
