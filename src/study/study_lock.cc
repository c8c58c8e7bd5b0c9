#include "study/study_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <thread>

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

/// "" where there is no such process.
std::string began(int pid) {
  const std::string stat = text_of("/proc/" + std::to_string(pid) + "/stat");
  std::istringstream after(stat.substr(std::min(stat.size(), stat.rfind(')') + 1)));  // its name may contain blanks
  std::string word;
  for (int field = 3; field <= 22; ++field) after >> word;
  return after ? word : "";
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

/// Whether the process has certainly ended: on this system as nothing of that number and beginning runs, on this
/// machine as it has been started anew since. A text that is not whole is of one that was killed before it could write.
bool has_ended(const std::string& text) {
  const Owner owner = owner_in(text), self = this_process();
  if (owner.text() != text || owner.host.empty()) return true;
  if (owner.system == self.system) return began(owner.pid) != owner.began;
  const auto boot = [](const Owner& o) { return o.system.substr(0, o.system.find("pid:")); };
  return owner.host == self.host && boot(owner) != boot(self);
}

/// Whether the file is there and younger than a minute: a disk may be slow.
bool is_young(const std::string& path) {
  std::error_code code;
  const fs::file_time_type written = fs::last_write_time(path, code);
  return !code && fs::file_time_type::clock::now() - written < std::chrono::minutes(1);
}

/// Moves the file of a process that has ended away; false where it was another's by then.
bool take_from_ended(const std::string& path, const std::string& text) {
  const std::string aside = path + "." + std::to_string(getpid());
  if (rename(path.c_str(), aside.c_str()) != 0) return true;  // another process has moved it: try again
  const bool was_it = text_of(aside) == text;
  if (!was_it && link(aside.c_str(), path.c_str()) != 0) return false;
  unlink(aside.c_str());
  return was_it;
}

}  // namespace

StudyLock::StudyLock(const std::string& output_folder) {
  const fs::path folder = fs::path(output_folder) / "journal";
  std::error_code code;
  fs::create_directories(folder, code);
  path_ = (folder / "lock").string();
  Attempt found = attempt();
  while (found == Attempt::again) found = attempt();
  if (found == Attempt::held) return;
  close(descriptor_);
  const Owner owner = owner_in(text_of(path_));
  std::string cure = "wait until it has ended, or choose another folder with --out DIR";
  if (!has_locks_) cure += "; this folder has no locks: where that process no longer runs, remove " + path_;
  throw InputError({output_folder},
                   "another study works in this folder" +
                       (owner.pid > 0 ? ", process " + std::to_string(owner.pid) + " on " + owner.host : std::string()),
                   cure);
}

StudyLock::~StudyLock() {
  if (has_locks_ || text_of(path_) == this_process().text()) unlink(path_.c_str());
  close(descriptor_);
}

StudyLock::Attempt StudyLock::attempt() {
  if (descriptor_ >= 0) close(descriptor_);
  descriptor_ = open(path_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  const bool is_new = descriptor_ >= 0;
  if (!is_new && errno == EEXIST) descriptor_ = open(path_.c_str(), O_RDWR | O_CLOEXEC);
  if (descriptor_ < 0 && errno == ENOENT && fs::exists(fs::path(path_).parent_path())) return Attempt::again;
  if (descriptor_ < 0)
    throw InputError({path_}, "cannot be written",
                     "give rights or room to write there, or choose another folder with --out DIR");
  if (flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
    if (errno == EWOULDBLOCK) return Attempt::other;
    has_locks_ = false;
    return attempt_without_locks(is_new);
  }
  struct stat locked, there;
  if (fstat(descriptor_, &locked) != 0 || stat(path_.c_str(), &there) != 0 || locked.st_ino != there.st_ino)
    return Attempt::again;  // its owner removed it meanwhile
  write_owner();
  return Attempt::held;
}

StudyLock::Attempt StudyLock::attempt_without_locks(bool is_new) {
  if (is_new) {
    write_owner();
    return text_of(path_) == this_process().text() ? Attempt::held
                                                   : Attempt::other;  // unless it was taken for a left one
  }
  std::string text = text_of(path_);
  while (text.empty() && is_young(path_)) {  // its owner may be about to write
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    text = text_of(path_);
  }
  return has_ended(text) && take_from_ended(path_, text) ? Attempt::again : Attempt::other;
}

void StudyLock::write_owner() const {
  const std::string text = this_process().text();
  if (ftruncate(descriptor_, 0) != 0 || write(descriptor_, text.data(), text.size()) < 0)
    throw InputError({path_}, "cannot be written", "make room on the disk, or choose another folder with --out DIR");
}

}  // namespace upbead
