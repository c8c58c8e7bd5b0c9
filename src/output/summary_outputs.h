// The keys of summary.json, and those that other files share.
#pragma once

#include "output/output_schema.h"
#include "upbead/output/summary.h"

namespace upbead {

OutputSchema<LoadOnCaisson> load_outputs();
OutputSchema<GaugeSummary> gauge_outputs();
OutputSchema<FlowSummary> flow_outputs();
OutputSchema<WaveLoadSummary> wave_load_outputs();
OutputSchema<Skipped> skipped_outputs();
OutputSchema<SlidingSummary> sliding_outputs();
OutputSchema<ContactSummary> contact_outputs();

/// Why the list `periods` of a caisson is empty, with a cure; "" where it is not empty, or there is no caisson.
std::string why_no_periods(const Summary& summary);

/// The keys of the summary of `upbead run`.
const OutputSchema<Summary>& summary_outputs();

}  // namespace upbead
