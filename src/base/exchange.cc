#include "exchange.h"

#include <fcntl.h>
#include <fnmatch.h>

#include <algorithm>
#include <cstdio>
#include <set>
#include <system_error>

namespace fs = std::filesystem;

namespace upbead {

namespace {

/// Folders of the files, and of files that match the patterns; relative, without the outermost.
std::set<fs::path> own_folders(const std::vector<fs::path>& files, const std::vector<std::string>& replaced) {
  std::set<fs::path> folders;
  const auto add = [&folders](fs::path folder) {
    for (; !folder.empty(); folder = folder.parent_path()) folders.insert(folder);
  };
  for (const fs::path& file : files) add(file.parent_path());
  for (const std::string& pattern : replaced) add(fs::path(pattern).parent_path());
  return folders;
}

/// Whether this process works in the folder or below it: a shell would find itself nowhere.
bool is_worked_in(const fs::path& folder) {
  std::error_code code;
  const fs::path here = fs::current_path(code);
  if (code) return true;
  const auto [end, ignored] = std::mismatch(folder.begin(), folder.end(), here.begin(), here.end());
  return end == folder.end();
}

/// Links what is kept into `fresh`; false where that is not possible.
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

}  // namespace

bool matches(const fs::path& file, const std::string& pattern) {
  return file.parent_path() == fs::path(pattern).parent_path() &&
         fnmatch(fs::path(pattern).filename().c_str(), file.filename().c_str(), 0) == 0;
}

bool exchange(const fs::path& fresh, const fs::path& old, const std::vector<fs::path>& files,
              const std::vector<std::string>& replaced) {
  if (is_worked_in(old) || !link_kept(fresh, old, files, replaced)) return false;
  std::error_code code;
  fs::permissions(fresh, fs::status(old, code).permissions(), code);
  return !code && renameat2(AT_FDCWD, fresh.c_str(), AT_FDCWD, old.c_str(), RENAME_EXCHANGE) == 0;
}

}  // namespace upbead
