// Landlock: file systems that can only be read.
#pragma once

namespace upbead::detail {

/// Takes from this process the rights to write, make, rename and remove files, to start programs, to open TCP
/// connections and to signal others, as far as the kernel knows them. False where it has no Landlock. Needs
/// no_new_privs. Source: man 7 landlock.
bool restrict_files();

}  // namespace upbead::detail
