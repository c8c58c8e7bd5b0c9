// The keys of what formulas say of a section, which several summaries share.
#pragma once

#include "output/output_schema.h"
#include "upbead/waves/breaking_impact.h"
#include "upbead/waves/standing_stability.h"

namespace upbead {

/// Safety factors and p_e under Goda's pressures with alpha_I.
OutputSchema<Stability> stability_outputs();

/// An impact by PROVERBS.
OutputSchema<BreakingImpact> impact_outputs();

/// The same in a standing wave of finite height, in crest and trough, or why there is none, and a bound of its trough.
OutputSchema<StandingResult> standing_outputs();

}  // namespace upbead
