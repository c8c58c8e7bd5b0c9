// Loads of CFD records in the scene. Where the moment is not proportional to the force, the force becomes two
// landward forces, low and high, whose sum and moment are the record's at every time.
#pragma once

#include "case/cfd/flow_source.h"
#include "case/load_source.h"
#include "output/output_schema.h"
#include "upbead/output/summary.h"

namespace upbead {

struct Mesh;

/// A load of a record of CFD.
struct FlowCase : LoadSource {
  FlowLoad flow;
};

/// Gives the pieces on boundaries their shapes and histories. Throws InputError, at keys of the case, where a
/// boundary is level, where a point of a record lies too far from its boundary, or where the water rises above the
/// wall.
void place_flows(const Case& input, const Mesh& mesh, Scene& scene);

/// flow_arm_outside: forces whose resultant lies above or below the wall or region that they act on.
NumberedWarnings flow_arm_warnings(const Case& input, const Mesh& mesh);

std::vector<FlowSummary> flow_summaries(const Case& input);
OutputSchema<FlowSummary> flow_outputs();

}  // namespace upbead
