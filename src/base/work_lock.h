// One process at a time has the folder of a study's results, or a part of the work.
#pragma once

#include <string>

namespace upbead {

/// A file in the folder's `journal`, which names this process. It comes into being whole, by link(2), of which one
/// alone succeeds on network file systems, too; locks of the file system (flock) may hang there. A process that has
/// ended on this machine holds nothing; of another machine nobody knows, and the message says which file to remove.
class WorkLock {
 public:
  static constexpr const char* of_all = "lock";  ///< the file of all work: it excludes all parts

  /// `file`: this one, or that of a part, which excludes all work and parts of another number of parts.
  /// Throws InputError where another process has it; never waits.
  explicit WorkLock(const std::string& output_folder, const std::string& file = of_all);
  /// Removes the file.
  ~WorkLock();
  WorkLock(const WorkLock&) = delete;
  WorkLock& operator=(const WorkLock&) = delete;

 private:
  void exclude_others(const std::string& output_folder) const;

  std::string path_;
};

/// "process 71 on node3"; "" where no such file is there, or its process has certainly ended.
std::string holder_of(const std::string& output_folder, const std::string& file);

}  // namespace upbead
