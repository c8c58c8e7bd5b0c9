#include "base/files.h"

#include <fcntl.h>
#include <fnmatch.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <set>
#include <system_error>

#include "base/text.h"
#include "upbead/base/error.h"

namespace fs = std::filesystem;

namespace upbead {

namespace {

[[noreturn]] void fail(const std::string& what) {
  throw InputError(Place(), what, "choose another folder with --out DIR");
}

[[noreturn]] void fail(const std::string& what, const std::error_code& code) {
  fail(what + ": " + code.message());
}

std::error_code last_error() {
  return std::error_code(errno, std::generic_category());
}

bool is_there(const fs::path& path) {
  std::error_code ignored;  // a folder without permission fails later, when it is written to
  return fs::exists(path, ignored);
}

bool is_folder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

/// Every file below `from`, relative to it.
std::vector<fs::path> files_below(const fs::path& from) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(from))
    if (!entry.is_directory()) files.push_back(entry.path().lexically_relative(from));
  return files;
}

/// Refuses a move that would fail: a folder where a file goes, a file where a folder goes.
void check_room(const fs::path& target, const fs::path& file) {
  if (is_folder(target / file)) fail("'" + (target / file).string() + "' is a folder, not a file");
  for (fs::path folder = file.parent_path(); !folder.empty(); folder = folder.parent_path())
    if (is_there(target / folder) && !is_folder(target / folder))
      fail("'" + (target / folder).string() + "' is a file, not a folder");
}

/// Whether a file, relative to its folder, matches a pattern: * ? [] in the last part, as in a shell.
bool matches(const fs::path& file, const std::string& pattern) {
  return file.parent_path() == fs::path(pattern).parent_path() &&
         fnmatch(fs::path(pattern).filename().c_str(), file.filename().c_str(), 0) == 0;
}

/// Folders of `files` and of the patterns `replaced`; relative, without the outermost folder.
std::set<fs::path> own_folders(const std::vector<fs::path>& files, const std::vector<std::string>& replaced) {
  std::set<fs::path> folders;
  const auto add = [&folders](fs::path folder) {
    for (; !folder.empty(); folder = folder.parent_path()) folders.insert(folder);
  };
  for (const fs::path& file : files) add(file.parent_path());
  for (const std::string& pattern : replaced) add(fs::path(pattern).parent_path());
  return folders;
}

/// Whether this process works in the folder or below it: a shell there would lose its working folder by an exchange.
bool is_worked_in(const fs::path& folder) {
  std::error_code code;
  const fs::path here = fs::current_path(code);
  if (code) return true;
  const auto [end, ignored] = std::mismatch(folder.begin(), folder.end(), here.begin(), here.end());
  return end == folder.end();
}

/// Links the files of `old` that are kept into `fresh`; false where that is not possible.
bool link_kept(const fs::path& fresh, const fs::path& old, const std::vector<fs::path>& files,
               const std::vector<std::string>& replaced) {
  const std::set<fs::path> folders = own_folders(files, replaced);
  std::error_code code;
  for (fs::recursive_directory_iterator entry(old, code), end; !code && entry != end; entry.increment(code)) {
    const fs::path file = entry->path().lexically_relative(old);
    if (fs::is_directory(entry->symlink_status(code))) {
      if (folders.count(file) == 0) return false;
      continue;
    }
    if (std::find(files.begin(), files.end(), file) != files.end()) continue;
    if (std::any_of(replaced.begin(), replaced.end(),
                    [&](const std::string& pattern) { return matches(file, pattern); }))
      continue;
    fs::create_directories((fresh / file).parent_path(), code);
    if (!code) fs::create_hard_link(entry->path(), fresh / file, code);
    if (code) return false;
  }
  return !code;
}

/// Exchanges the folders `fresh` and `old` in one step: everybody sees either folder whole, even if this process is
/// killed. Other files in `old` are kept, by hard links in `fresh`: all but `files` (those of `fresh`, relative to
/// it) and those that match `replaced`. False, with `old` unchanged, where the file system cannot exchange, `old`
/// holds other folders, or this process works in it.
bool exchange(const fs::path& fresh, const fs::path& old, const std::vector<fs::path>& files,
              const std::vector<std::string>& replaced) {
  if (is_worked_in(old) || !link_kept(fresh, old, files, replaced)) return false;
  std::error_code code;
  fs::permissions(fresh, fs::status(old, code).permissions(), code);
  return !code && renameat2(AT_FDCWD, fresh.c_str(), AT_FDCWD, old.c_str(), RENAME_EXCHANGE) == 0;
}

}  // namespace

void write_whole(const std::string& path, const std::string& text) {
  std::error_code code;
  const fs::file_type type = fs::symlink_status(path, code).type();
  const bool as_it_is = type != fs::file_type::regular && type != fs::file_type::not_found;
  const std::string partial = as_it_is ? path : path + ".partial";
  std::ofstream stream(partial, std::ios::binary);
  stream << text;
  stream.close();
  code.clear();
  if (stream && !as_it_is) fs::rename(partial, path, code);
  if (stream && !code) return;
  std::error_code ignored;
  if (!as_it_is) fs::remove(partial, ignored);
  throw InputError({path}, "the file cannot be written", "check the folder, the rights and the disk");
}

/// flock(2) on the folder itself: it leaves no file behind, and ends with the process, even a killed one. On file
/// systems without such locks (some network file systems) held() is false.
class FolderLock {
 public:
  /// `waiting`: LOCK_NB, or 0 to wait until others release the lock.
  FolderLock(const fs::path& folder, int waiting)
      : descriptor_(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)),
        held_(descriptor_ >= 0 && flock(descriptor_, LOCK_EX | waiting) == 0) {}
  ~FolderLock() {
    if (descriptor_ >= 0) close(descriptor_);
  }
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  bool held() const { return held_; }

 private:
  int descriptor_;
  bool held_;
};

OutputFolder::OutputFolder(const std::string& path) : name_(path) {
  if (path.empty()) fail("the output folder has no name");
  std::error_code code;
  target_ = fs::weakly_canonical(fs::absolute(path), code);
  if (code) fail("cannot use the output folder '" + path + "'", code);
  if (!target_.has_filename()) target_ = target_.parent_path();
  // all links that lead somewhere are followed by now
  if (fs::is_symlink(fs::symlink_status(target_, code))) fail("the output folder '" + path + "' is a link to nothing");
  if (is_there(target_) && !is_folder(target_)) fail("the output folder '" + path + "' is a file");
  check_rights();
  make_parents();
  remove_abandoned();
  make_partial();
}

OutputFolder::~OutputFolder() {
  std::error_code ignored;  // a destructor cannot report errors
  if (!partial_.empty()) fs::remove_all(partial_, ignored);
  remove_parents();
}

void OutputFolder::remove_parents() {
  std::error_code ignored;  // a parent folder stays if somebody else has written into it meanwhile
  for (auto parent = made_parents_.rbegin(); parent != made_parents_.rend(); ++parent) fs::remove(*parent, ignored);
  made_parents_.clear();
}

void OutputFolder::make_parents() {
  std::vector<fs::path> missing;
  for (fs::path parent = target_.parent_path(); !is_there(parent); parent = parent.parent_path())
    missing.push_back(parent);
  for (auto parent = missing.rbegin(); parent != missing.rend(); ++parent) {
    std::error_code code;
    if (!fs::create_directory(*parent, code) && code) {
      remove_parents();
      fail("cannot make the folder '" + parent->string() + "'", code);
    }
    made_parents_.push_back(*parent);
  }
}

void OutputFolder::check_rights() const {
  if (is_there(target_) && access(target_.c_str(), W_OK | X_OK) != 0)
    fail("cannot write into the output folder '" + name_ + "'", last_error());
}

/// Where the hidden folder is made: beside the wanted folder, or inside it where that is a file system of its own.
fs::path OutputFolder::home() const {
  struct stat folder, parent;
  const bool is_mount = stat(target_.c_str(), &folder) == 0 && stat(target_.parent_path().c_str(), &parent) == 0 &&
                        folder.st_dev != parent.st_dev;
  return is_mount ? target_ : target_.parent_path();
}

std::string OutputFolder::stem() const {
  return "." + target_.filename().string() + ".partial-";
}

/// Nobody locks a folder that a killed process has left. A folder younger than a minute may be about to be locked.
void OutputFolder::remove_abandoned() const {
  std::error_code code;
  const auto old = fs::file_time_type::clock::now() - std::chrono::minutes(1);
  std::vector<fs::path> abandoned;
  for (fs::directory_iterator entry(home(), code), end; !code && entry != end; entry.increment(code))
    if (entry->path().filename().string().rfind(stem(), 0) == 0 && fs::last_write_time(*entry, code) < old)
      abandoned.push_back(entry->path());
  for (const fs::path& folder : abandoned)
    if (FolderLock(folder, LOCK_NB).held()) fs::remove_all(folder, code);
}

void OutputFolder::make_partial() {
  const std::string stem = this->stem() + std::to_string(getpid());
  for (int i = 0;; ++i) {
    const fs::path candidate = home() / (stem + (i == 0 ? "" : "-" + std::to_string(i)));
    std::error_code code;
    if (fs::create_directory(candidate, code)) {
      partial_ = candidate;
      in_use_ = std::make_unique<FolderLock>(partial_, LOCK_NB);
      return;
    }
    if (code) {
      remove_parents();
      fail("cannot write beside the output folder '" + name_ + "'", code);
    }
  }
}

std::string OutputFolder::path(const std::string& file) const {
  const fs::path full = partial_ / file;
  std::error_code code;
  fs::create_directories(full.parent_path(), code);
  if (code) fail("cannot make a folder for '" + (fs::path(name_) / file).string() + "'", code);
  return full.string();
}

void OutputFolder::write(const std::string& file, const std::string& text) const {
  errno = 0;
  std::ofstream stream(path(file), std::ios::binary);
  stream << text;
  stream.close();
  if (!stream) fail("cannot write '" + (fs::path(name_) / file).string() + "'", last_error());
}

void OutputFolder::move_files(const std::vector<fs::path>& files) const {
  std::error_code code;
  for (const fs::path& file : files) {
    fs::create_directories((target_ / file).parent_path(), code);
    if (!code) fs::rename(partial_ / file, target_ / file, code);
    if (code) fail("cannot write '" + (fs::path(name_) / file).string() + "'", code);
  }
}

void OutputFolder::remove_older(const std::string& pattern, const std::vector<fs::path>& files) const {
  const fs::path parent = fs::path(pattern).parent_path();
  std::vector<fs::path> older;
  std::error_code code;  // without the folder there is nothing to remove
  for (fs::directory_iterator entry(target_ / parent, code), end; !code && entry != end; entry.increment(code)) {
    const fs::path file = parent / entry->path().filename();
    if (matches(file, pattern) && !is_folder(entry->path()) &&
        std::find(files.begin(), files.end(), file) == files.end())
      older.push_back(file);
  }
  for (const fs::path& file : older)
    if (!fs::remove(target_ / file, code) && code)
      fail("cannot remove the older '" + (fs::path(name_) / file).string() + "'", code);
  if (!older.empty() && !parent.empty()) fs::remove(target_ / parent, code);  // removes the folder only if it is empty
}

void OutputFolder::put_into_place(const std::vector<std::string>& replaced) const {
  const FolderLock turn(target_.parent_path(), 0);  // two runs that write into one folder do so one after the other
  std::error_code code;
  if (!is_there(target_)) {
    fs::rename(partial_, target_, code);
    if (code) fail("cannot make the output folder '" + name_ + "'", code);
    return;
  }
  const std::vector<fs::path> files = files_below(partial_);
  for (const fs::path& file : files) check_room(target_, file);
  if (!exchange(partial_, target_, files, replaced)) {
    move_files(files);
    for (const std::string& pattern : replaced) remove_older(pattern, files);
  }
  fs::remove_all(partial_, code);
}

void OutputFolder::commit(const std::vector<std::string>& replaced) {
  put_into_place(replaced);
  partial_.clear();
  made_parents_.clear();
}

namespace {

/// Existing files that would be replaced.
std::vector<fs::path> replaced_files(const fs::path& folder, const std::vector<std::string>& outputs) {
  std::vector<fs::path> files;
  for (const std::string& output : outputs) {
    const fs::path place = fs::path(output).parent_path();
    std::error_code code;  // a folder that is not there holds no input
    for (fs::directory_iterator entry(folder / place, code), end; !code && entry != end; entry.increment(code))
      if (matches(place / entry->path().filename(), output)) files.push_back(entry->path());
  }
  return files;
}

bool is_same(const fs::path& a, const fs::path& b) {
  std::error_code different;
  return fs::equivalent(a, b, different);
}

/// Whether a folder has results, beside which case.toml is one of them; of `upbead scale` it is the only one.
bool has_results(const fs::path& folder) {
  std::string first_line;
  std::ifstream file(folder / "case.toml");
  std::getline(file, first_line);
  return first_line.rfind("# Made by `upbead scale ", 0) == 0 || is_there(folder / "summary.json") ||
         is_there(folder / "results.h5");
}

}  // namespace

void require_inputs_kept(const std::string& folder, const std::vector<std::string>& outputs,
                         const std::vector<InputFile>& inputs) {
  const std::vector<fs::path> files = replaced_files(folder, outputs);
  Diagnostics mistakes;
  const fs::path other = fs::path(folder) / "case.toml";
  if (std::find(files.begin(), files.end(), other) != files.end() && is_there(other) && !has_results(folder) &&
      std::none_of(inputs.begin(), inputs.end(), [&](const InputFile& input) { return is_same(other, input.path); }))
    mistakes.add({}, quoted_path(other.string()) + " would be written over, and lies beside no results",
                 "move it, or choose another folder with --out DIR");
  for (const InputFile& input : inputs) {
    const auto taken =
        std::find_if(files.begin(), files.end(), [&](const fs::path& file) { return is_same(file, input.path); });
    if (taken != files.end())
      mistakes.add(input.place,
                   quoted_path(input.path) + " is read, and " + quoted_path(taken->string()) +
                       ", which would be written, is the same file",
                   "choose another folder with --out DIR");
  }
  mistakes.throw_if_any();
}

}  // namespace upbead
