// The text of a table, whatever wrote it: encodings, byte order marks, line ends; and files that are no text.
#pragma once

#include <string>
#include <string_view>

#include "upbead/base/error.h"

namespace upbead {

/// UTF-8 with lines that end in \n, of UTF-8, UTF-16 of both byte orders, or Windows-1252; without byte order mark.
/// Throws InputError at `place` where the bytes are no text: a workbook, HDF5, an archive, a document.
std::string as_utf8(std::string bytes, const std::string& path, const Place& place);

/// Whether bytes are valid UTF-8; else the first byte that is not, by its index.
std::size_t end_of_utf8(std::string_view text);

/// Whether a file begins as an HDF5 file does, whatever it is called.
bool is_hdf5_file(const std::string& path);

}  // namespace upbead
