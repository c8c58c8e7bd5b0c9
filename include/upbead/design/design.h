// The design file of `upbead waves` and `upbead expected`.
#pragma once

#include <string>
#include <vector>

namespace upbead {

/// The design as TOML with every default spelled out, and with paths as seen from `output_folder`. Throws InputError
/// with every mistake in the section and its waves.
std::string effective_design(const std::string& path, const std::vector<std::string>& overrides = {},
                             const std::string& output_folder = ".");

/// Every key of the design file as Markdown.
std::string design_reference();

}  // namespace upbead
