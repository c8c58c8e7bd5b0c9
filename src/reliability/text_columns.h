// Tables for the terminal.
#pragma once

#include <string>
#include <vector>

namespace upbead {

using TextRow = std::vector<std::string>;

/// Columns as wide as needed, the first aligned to the left, all other ones to the right.
std::string columns(const std::vector<TextRow>& rows);

}  // namespace upbead
