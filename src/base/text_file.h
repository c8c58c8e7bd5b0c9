// The text of a file, packed by gzip or not.
#pragma once

#include <cstdint>
#include <limits>
#include <string>

#include "upbead/base/error.h"

namespace upbead {

/// The whole text. Throws InputError at `place` as require_readable does (input_file.h), and where a packed file is
/// damaged, holds more than `most` bytes once it is unpacked, or more than 64 MB that are 100 times its size: while it
/// is unpacked, so that neither time nor memory goes into the rest.
/// `enough`: no more than about so many bytes are wanted of its beginning.
std::string read_text(const std::string& path, std::uintmax_t most, const Place& place,
                      std::uintmax_t enough = std::numeric_limits<std::uintmax_t>::max());

}  // namespace upbead
