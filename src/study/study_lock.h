// One study at a time in a folder.
#pragma once

#include <string>

namespace upbead {

/// Holds a folder for a study. Where the file system has locks, flock(2) of a file in it, which ends with the process,
/// even a killed one, on any machine that shares the folder. Elsewhere that file itself, which names its process: one
/// that has ended on this machine holds nothing; of another machine nobody knows.
class StudyLock {
 public:
  /// Throws InputError where another study holds the folder.
  explicit StudyLock(const std::string& output_folder);
  /// Removes the file.
  ~StudyLock();
  StudyLock(const StudyLock&) = delete;
  StudyLock& operator=(const StudyLock&) = delete;

 private:
  enum class Attempt { held, other, again };
  Attempt attempt();
  Attempt attempt_without_locks(bool is_new);
  void write_owner() const;

  std::string path_;
  bool has_locks_ = true;
  int descriptor_ = -1;
};

}  // namespace upbead
