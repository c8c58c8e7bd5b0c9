// Who wrote a result.
#pragma once

namespace upbead {

/// "upbead 0.1.0".
const char* program_version();

}  // namespace upbead
