// The parts of understand(), by what a record holds.
#pragma once

#include "case/cfd/flow_frame.h"

namespace upbead {

void understand_forces(const FlowRecord& record, const FlowContext& context, FlowLoad& load);
void understand_level(const FlowRecord& record, const FlowContext& context, FlowLoad& load);
void understand_points(const FlowRecord& record, const FlowContext& context, FlowLoad& load);

}  // namespace upbead
