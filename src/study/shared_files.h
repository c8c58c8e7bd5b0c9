// Files of a folder into which several processes may write the same ones at once.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace upbead {

/// Writes files, each given by path and text, under names that no other process has, and renames them once all are
/// written: a file that is there is whole, whoever was last, and on a full disk the older ones stay. Throws InputError.
void write_together(const std::vector<std::pair<std::string, std::string>>& files);

/// Makes an empty file; false where it is there: of processes that ask one is the first, on network file systems, too.
bool is_first(const std::string& path);

}  // namespace upbead
