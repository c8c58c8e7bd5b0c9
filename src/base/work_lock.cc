#include "base/work_lock.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "base/journal.h"
#include "upbead/base/error.h"

namespace fs = std::filesystem;

namespace upbead {

namespace {

std::string text_of(const fs::path& path) {
  std::ifstream stream(path);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// A process, so that another one can tell whether it still runs. As text, four words: "PID BEGAN SYSTEM HOST".
struct Owner {
  int pid = 0;
  std::string began;   ///< field 22 of /proc/PID/stat: another process of that number has another one
  std::string system;  ///< start of the machine and name space of its processes: only within it a PID means something
  std::string host;

  std::string text() const { return std::to_string(pid) + " " + began + " " + system + " " + host + "\n"; }
};

/// "" where there is no such process, or it has ended and its parent has not asked how.
std::string began(int pid) {
  const std::string stat = text_of("/proc/" + std::to_string(pid) + "/stat");
  std::istringstream after(stat.substr(std::min(stat.size(), stat.rfind(')') + 1)));  // its name may contain blanks
  std::string state, word;
  after >> state;
  for (int field = 4; field <= 22; ++field) after >> word;
  return after && state != "Z" && state != "X" ? word : "";
}

Owner this_process() {
  char host[256] = "?";
  gethostname(host, sizeof host - 1);
  std::string boot = text_of("/proc/sys/kernel/random/boot_id");
  boot = boot.substr(0, boot.find('\n'));
  std::error_code code;
  return {getpid(), began(getpid()), boot + fs::read_symlink("/proc/self/ns/pid", code).string(), host};
}

Owner owner_in(const std::string& text) {
  Owner owner;
  std::istringstream(text) >> owner.pid >> owner.began >> owner.system >> owner.host;
  return owner;
}

bool is_whole(const Owner& owner, const std::string& text) {
  return owner.text() == text && !owner.host.empty();
}

/// Whether the process has certainly ended: on this system as nothing of that number and beginning runs, on this
/// machine as it has been started anew since.
bool has_ended(const std::string& text) {
  const Owner owner = owner_in(text), self = this_process();
  if (!is_whole(owner, text)) return false;
  if (owner.system == self.system) return began(owner.pid) != owner.began;
  const auto boot = [](const Owner& o) { return o.system.substr(0, o.system.find("pid:")); };
  return owner.host == self.host && boot(owner) != boot(self);
}

[[noreturn]] void cannot_hold(const std::string& path) {
  throw InputError({path}, "cannot be written",
                   "give rights or room to write there, or choose another folder with --out DIR");
}

void write_owner(int descriptor, const std::string& made, const std::string& path) {
  const std::string text = this_process().text();
  const bool is_written = write(descriptor, text.data(), text.size()) == static_cast<ssize_t>(text.size());
  if (close(descriptor) == 0 && is_written) return;
  unlink(made.c_str());
  cannot_hold(path);
}

/// Makes a file of this process beside `path`, under a name that no other process has.
std::string own_file(const std::string& path) {
  std::string own = path + ".XXXXXX";
  const int descriptor = mkstemp(own.data());
  if (descriptor < 0) cannot_hold(path);
  fchmod(descriptor, 0644);  // for others to see whose it is
  write_owner(descriptor, own, path);
  return own;
}

/// The same where a file system has no hard links: a file that is for a moment there without its text.
bool make_without_links(const std::string& path) {
  const int descriptor = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
  if (descriptor < 0 && errno != EEXIST) cannot_hold(path);
  if (descriptor >= 0) write_owner(descriptor, path, path);
  return descriptor >= 0;
}

/// Makes the file of this process; false where there is one.
bool make(const std::string& path) {
  const std::string own = own_file(path);
  const int error = link(own.c_str(), path.c_str()) == 0 ? 0 : errno;
  struct stat there;
  const bool made = error == 0 || (stat(own.c_str(), &there) == 0 && there.st_nlink > 1);  // the answer was lost
  unlink(own.c_str());
  if (made || error == EEXIST) return made;
  if (error == ENOSPC || error == EDQUOT || error == EACCES) cannot_hold(path);
  return make_without_links(path);
}

bool take(const std::string& path);

/// Puts a file of this process into the place of one whose process has ended, unless another process was first. One
/// at a time may, so that none replaces the file of one that lives.
void replace(const std::string& path, const std::string& ended) {
  const std::string turn = path + ".turn";
  if (!take(turn)) return;
  if (text_of(path) == ended) {
    const std::string own = own_file(path);
    if (rename(own.c_str(), path.c_str()) != 0) unlink(own.c_str());
  }
  unlink(turn.c_str());
}

/// False where another process has the file, or may have.
bool take(const std::string& path) {
  while (!make(path)) {
    const std::string text = text_of(path);
    if (!has_ended(text)) {
      if (!fs::exists(path)) continue;  // it has just ended
      return false;
    }
    replace(path, text);
    return text_of(path) == this_process().text();
  }
  return true;
}

/// What works where: "" of a file that excludes nothing else; equal ones go together.
std::string division_of(const std::string& file) {
  if (file == WorkLock::of_all) return file;
  const std::size_t of = file.find("-of-");
  return of == std::string::npos ? "" : file.substr(of);
}

[[noreturn]] void refuse(const std::string& output_folder, const fs::path& path) {
  const std::string file = path.filename().string(), text = text_of(path);
  const Owner owner = owner_in(text);
  std::string what = "another process works in this folder";
  if (file.find("-of-") != std::string::npos) what = path.stem().string() + " is at work in this folder";
  if (is_whole(owner, text)) what += ", process " + std::to_string(owner.pid) + " on " + owner.host;
  std::string cure = "wait until it has ended, or choose another folder with --out DIR";
  if (owner.system != this_process().system)
    cure += "; from here nobody can see whether it still runs: where it does not, remove " + path.string();
  throw InputError({output_folder}, what, cure);
}

}  // namespace

WorkLock::WorkLock(const std::string& output_folder, const std::string& file) {
  const fs::path folder = journal_folder(output_folder);
  std::error_code code;
  fs::create_directories(folder, code);
  path_ = (folder / file).string();
  if (!take(path_)) refuse(output_folder, path_);
  try {
    exclude_others(output_folder);
  } catch (...) {
    unlink(path_.c_str());
    throw;
  }
}

/// Of two that begin at once each makes its file before it looks, so that one of them at least sees the other.
void WorkLock::exclude_others(const std::string& output_folder) const {
  const std::string own = division_of(fs::path(path_).filename().string());
  std::error_code code;
  for (fs::directory_iterator entry(journal_folder(output_folder), code), end; !code && entry != end;
       entry.increment(code)) {
    const std::string file = entry->path().filename().string(), other = division_of(file);
    const bool is_lock = file == of_all || entry->path().extension() == ".lock";
    if (is_lock && !own.empty() && !other.empty() && other != own && !holder_of(output_folder, file).empty())
      refuse(output_folder, entry->path());
  }
}

WorkLock::~WorkLock() {
  if (text_of(path_) == this_process().text()) unlink(path_.c_str());
}

std::string holder_of(const std::string& output_folder, const std::string& file) {
  const fs::path path = journal_folder(output_folder) / file;
  const std::string text = text_of(path);
  if (has_ended(text) || !fs::exists(path)) return "";
  const Owner owner = owner_in(text);
  return "process " + std::to_string(owner.pid) + " on " + owner.host;
}

}  // namespace upbead
