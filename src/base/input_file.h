// Files that people give to be read.
#pragma once

#include <cstdint>
#include <string>

#include "upbead/base/error.h"

namespace upbead {

/// Throws InputError at `place` where there is no file to be read, or what is there is a folder, a device, a socket or
/// a pipe, whose end may never come; and where a file holds more than `most` bytes: a wrong one named by mistake, which
/// would fill the memory.
void require_readable(const std::string& path, std::uintmax_t most, const Place& place);

}  // namespace upbead
