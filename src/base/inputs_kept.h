// What a person has given to be read is never written over.
#pragma once

#include <string>
#include <vector>

#include "upbead/base/error.h"

namespace upbead {

/// A file that is read, and the key or argument that names it.
struct InputFile {
  std::string path;
  Place place;
};

/// Throws InputError, at the places that name them, where files written into `folder` would take the place of an input.
/// `outputs`: relative to the folder; the last part may be a pattern (* ? [], as in a shell). Files are the same where
/// device and inode are, whatever they are called: links of either kind are followed.
void require_inputs_kept(const std::string& folder, const std::vector<std::string>& outputs,
                         const std::vector<InputFile>& inputs);

}  // namespace upbead
