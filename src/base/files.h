// What is written appears whole or not at all, and never over what was given to be read.
#pragma once

#include <filesystem>
#include <memory>
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

class FolderLock;

/// Files are written into a hidden folder beside the wanted one, which is made at once, so that missing rights are
/// known before anything is computed. commit() puts it into the wanted one's place in one step; without it nothing is
/// left behind. A folder that exists keeps its other files; where it holds folders of others, is this process's working
/// folder, or its file system cannot exchange folders, files are moved into it one by one. What killed processes have
/// left beside it is removed. Every error is an InputError that names the path and the cure.
class OutputFolder {
 public:
  /// `path`: the wanted folder; it and its parents need not exist.
  explicit OutputFolder(const std::string& path);
  /// Removes what has not been committed, and parents made for it.
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// The wanted folder as the person wrote it, for messages.
  const std::string& name() const { return name_; }
  /// Where to write `file` (may hold subfolders, which are made) until commit().
  std::string path(const std::string& file) const;
  /// Writes a whole text file; a full disk is an error here.
  void write(const std::string& file, const std::string& text) const;
  /// Puts everything into place, replacing files of the same name only. Nothing has been moved where it throws because
  /// a file stands in a folder's place or the reverse. `replaced`: patterns of file names (* ? [] in the last part, as
  /// in a shell) of which nothing older may stay beside the new files. Call once, last.
  void commit(const std::vector<std::string>& replaced = {});

 private:
  void make_parents();
  void remove_parents();
  std::filesystem::path home() const;
  std::string stem() const;
  void make_partial();
  void remove_abandoned() const;
  void check_rights() const;
  void move_files(const std::vector<std::filesystem::path>& files) const;
  void remove_older(const std::string& pattern, const std::vector<std::filesystem::path>& files) const;
  void put_into_place(const std::vector<std::string>& replaced) const;

  std::string name_;
  std::filesystem::path target_;                     ///< absolute, links resolved
  std::filesystem::path partial_;                    ///< hidden, in home(); empty once committed
  std::unique_ptr<FolderLock> in_use_;               ///< on partial_, so that nobody takes it for abandoned
  std::vector<std::filesystem::path> made_parents_;  ///< outermost first
};

}  // namespace upbead
