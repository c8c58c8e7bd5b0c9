// The one place that knows the TOML library: text to nodes.
#pragma once

#include <string>

#include "upbead/input/node.h"

namespace upbead {

/// Reads TOML `text` that stands in `file`. Throws InputError with the place of a syntax error.
Node parse_toml(const std::string& text, const std::string& file);

}  // namespace upbead
