// The design file of `upbead expected`, with the files that it names.
#pragma once

#include <string>
#include <vector>

namespace upbead {

/// Reads and checks a design for `upbead expected`: its tables, the record of sea states, the reduced model. Throws
/// InputError with every mistake.
void check_expected_design(const std::string& path, const std::vector<std::string>& overrides = {});

}  // namespace upbead
