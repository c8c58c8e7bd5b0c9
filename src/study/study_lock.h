// One process at a time has a study's folder, or a part of the study.
#pragma once

#include <string>

namespace upbead {

/// A file in the folder's `journal`, which names this process. It comes into being whole, by link(2), of which one
/// alone succeeds on network file systems, too; locks of the file system (flock) may hang there. A process that has
/// ended on this machine holds nothing; of another machine nobody knows, and the message says which file to remove.
class StudyLock {
 public:
  static constexpr const char* of_study = "lock";  ///< the file of a whole study: it excludes all parts

  /// `file`: this one, or that of a part, which excludes the whole study and parts of another number of parts.
  /// Throws InputError where another process has it; never waits.
  explicit StudyLock(const std::string& output_folder, const std::string& file = of_study);
  /// Removes the file.
  ~StudyLock();
  StudyLock(const StudyLock&) = delete;
  StudyLock& operator=(const StudyLock&) = delete;

 private:
  void exclude_others(const std::string& output_folder) const;

  std::string path_;
};

/// "process 71 on node3"; "" where no such file is there, or its process has certainly ended.
std::string holder_of(const std::string& output_folder, const std::string& file);

}  // namespace upbead
