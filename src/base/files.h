// Output files appear complete or not at all, and never replace an input file.
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

/// Throws InputError, at the places that name the inputs, where files written into `folder` would replace an input.
/// `outputs`: relative to the folder; the last part may be a pattern (* ? [], as in a shell). Two files are the same
/// if their device and inode are: symbolic and hard links are followed.
void require_inputs_kept(const std::string& folder, const std::vector<std::string>& outputs,
                         const std::vector<InputFile>& inputs);

/// Writes one file, which appears whole or not at all; an older one stays where that fails. A link or a device is
/// written to as it is. Throws InputError where the file cannot be written.
void write_whole(const std::string& path, const std::string& text);

class FolderLock;

/// Files are written into a hidden folder beside the wanted one. The hidden folder is made at once, so that missing
/// rights are known before anything is computed. commit() puts it into the wanted folder's place in one step; without
/// commit() nothing is left behind. A folder that exists keeps its other files; where it holds other folders, is this
/// process's working folder, or its file system cannot exchange folders, files are moved into it one by one. Hidden
/// folders of killed processes are removed. Every error is an InputError that names the path and the cure.
class OutputFolder {
 public:
  /// `path`: the wanted folder; it and its parents need not exist.
  explicit OutputFolder(const std::string& path);
  /// Removes what has not been committed, and the parent folders made for it.
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// The wanted folder as the person wrote it, for messages.
  const std::string& name() const { return name_; }
  /// Where to write `file` until commit(); its subfolders are made.
  std::string path(const std::string& file) const;
  /// Writes a whole text file; a full disk is an error here.
  void write(const std::string& file, const std::string& text) const;
  /// Puts everything into place, replacing files of the same name only. Throws, before anything is moved, where a
  /// file has the name of a folder or the reverse. `replaced`: patterns of file names (* ? [] in the last part, as in
  /// a shell); older files that match them are removed. Call once, last.
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
  std::filesystem::path target_;        ///< absolute, links resolved
  std::filesystem::path partial_;       ///< hidden, in home(); empty once committed
  std::unique_ptr<FolderLock> in_use_;  ///< lock on partial_, so that no other process removes it as abandoned
  std::vector<std::filesystem::path> made_parents_;  ///< outermost first
};

}  // namespace upbead
