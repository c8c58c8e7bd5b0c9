// How the files of a case's loads and uplift are read, for people.
#pragma once

#include "case/record_notes.h"
#include "upbead/case/case.h"

namespace upbead {

/// What is left out of the files, counters and values beyond the first of a history, and what may be read wrongly. Only
/// the beginning of each file is looked at once more: the rest of a long record would take as long as before.
RecordNotes record_notes(const Case& input);

}  // namespace upbead
