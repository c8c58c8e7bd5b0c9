// The table of all warnings, for `explain --warnings` and the page of reference.
#pragma once

#include <string>

namespace upbead {

/// A Markdown table; its links are relative to docs. A warning that is not in it makes a test fail.
std::string warning_reference();

}  // namespace upbead
