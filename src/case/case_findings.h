// What is said of a case beside its scene: its loads as they were read, checks by formulas, its files, its records.
#pragma once

#include <string>
#include <vector>

#include "case/records/measured.h"
#include "findings/find.h"
#include "upbead/case/case.h"

namespace upbead {

/// Both must outlive the findings; null: only the keys are asked for.
std::vector<Finding> case_findings(const Case* input, const std::vector<MeasuredRecord>* records);

/// The keys of the summary of `upbead run`.
const OutputSchema<Summary>& summary_outputs();

/// JSON with the keys of docs/output.md; null where a value does not exist. Throws NumericsError where one is not
/// finite.
std::string to_json(const Summary& summary);

}  // namespace upbead
