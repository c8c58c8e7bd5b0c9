// Files that people give to be read.
#pragma once

#include <cstdint>
#include <string>

#include "upbead/base/error.h"

namespace upbead {

/// Throws InputError at `place` where the file cannot be read, is a folder or a device, or holds more than `most`
/// bytes: a wrong file named by mistake, which would fill the memory.
void require_readable(const std::string& path, std::uintmax_t most, const Place& place);

}  // namespace upbead
