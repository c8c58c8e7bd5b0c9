// Valid HDF5 files with random changes of their objects, like files of other programs, of other versions or with
// unfinished edits.
#pragma once

#include <string>
#include <string_view>

namespace upbead::fuzz {

/// The file `image` after the changes that `bytes` choose: objects removed, moved, linked, replaced by others of any
/// type, shape and value; single numbers changed; attributes set or removed.
std::string changed_hdf5(const std::string& image, std::string_view bytes);

/// A file of two waves of two loads, at four times.
std::string sample_waves();

}  // namespace upbead::fuzz
