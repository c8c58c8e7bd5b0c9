// Files of text that people give to be read, packed by gzip or not.
#pragma once

#include <cstdint>
#include <limits>
#include <string>

#include "upbead/base/error.h"

namespace upbead {

/// Throws InputError at `place` where there is no file to be read, or what is there is a folder, a device, a socket or
/// a pipe, whose end may never come; and where a file holds more than `most` bytes: a wrong one named by mistake, which
/// would fill the memory.
void require_readable(const std::string& path, std::uintmax_t most, const Place& place);

/// The whole text. Throws InputError at `place` as require_readable does (input_file.h), and where a packed file is
/// damaged, holds more than `most` bytes once it is unpacked, or more than 64 MB that are 100 times its size: while it
/// is unpacked, so that neither time nor memory goes into the rest.
/// `enough`: no more than about so many bytes are wanted of its beginning.
std::string read_text(const std::string& path, std::uintmax_t most, const Place& place,
                      std::uintmax_t enough = std::numeric_limits<std::uintmax_t>::max());

}  // namespace upbead
