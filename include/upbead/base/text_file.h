// The text of a file, packed by gzip or not.
#pragma once

#include <cstdint>
#include <string>

#include "upbead/base/error.h"

namespace upbead {

/// The whole text. Throws InputError at `place` as require_readable does (input_file.h), and where a packed file is
/// damaged or holds more than `most` bytes once it is unpacked.
std::string read_text(const std::string& path, std::uintmax_t most, const Place& place);

}  // namespace upbead
