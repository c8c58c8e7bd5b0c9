// A folder that takes the place of another one in a single step.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace upbead {

/// Whether a file, relative to its folder, matches a pattern: * ? [] in the last part, as in a shell.
bool matches(const std::filesystem::path& file, const std::string& pattern);

/// Puts the folder `fresh` in the place of `old`, and the reverse: whoever looks sees the one or the other as a whole,
/// whenever this process is killed. What else stands in `old` but `files` (those of `fresh`, relative to it) and what
/// matches `replaced` is kept, by hard links in `fresh`. False, with `old` as it was, where that is not possible or not
/// wanted: the file system cannot, `old` holds folders of others, or this process works in it.
bool exchange(const std::filesystem::path& fresh, const std::filesystem::path& old,
              const std::vector<std::filesystem::path>& files, const std::vector<std::string>& replaced);

}  // namespace upbead
