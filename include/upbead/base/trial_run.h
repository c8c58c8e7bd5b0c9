// Work of a library that may break down on damaged files, tried out first.
#pragma once

#include <functional>
#include <string>

namespace upbead {

/// Does `work`, the reading of a file, in a copy of this process, which ends with it and leaves nothing behind. False
/// where it ended otherwise, as by a signal, or computed for longer than 5 s and 1 s per megabyte: gmsh 4.8 and
/// HDF5 1.10 end so on many a damaged file. True where the work was done or threw, and where there is no room for a
/// copy.
bool survives(const std::string& file, const std::function<void()>& work);

}  // namespace upbead
