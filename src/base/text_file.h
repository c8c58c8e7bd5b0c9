// Text files given as input, packed by gzip or not.
#pragma once

#include <cstdint>
#include <string>

#include "upbead/base/error.h"

namespace upbead {

/// Throws InputError at `place` where there is no file, or a folder, a device, a socket or a pipe, whose end may
/// never come; and where a file holds more than `most` bytes, as the wrong file, named by mistake, would fill the
/// memory.
void require_readable(const std::string& path, std::uintmax_t most, const Place& place);

/// The whole text. Throws InputError at `place` as require_readable does, and where a packed file is damaged, holds
/// more than `most` bytes once it is unpacked, or more than 64 MB that are 100 times its size. It stops unpacking
/// there, to save time and memory.
std::string read_text(const std::string& path, std::uintmax_t most, const Place& place);

}  // namespace upbead
