// A lock that a process holds on a folder.
#pragma once

#include <filesystem>

namespace upbead {

/// flock(2) on the folder itself: no file is left behind, and it goes with the process however that ends. File systems
/// without such locks (some networks') count as not held.
class FolderLock {
 public:
  enum class Wait { yes, no };
  FolderLock(const std::filesystem::path& folder, Wait wait);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  bool held() const { return held_; }

 private:
  int descriptor_;
  bool held_;
};

}  // namespace upbead
