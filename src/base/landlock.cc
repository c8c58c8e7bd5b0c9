#include "landlock.h"

#include <sys/syscall.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>

namespace upbead::detail {

namespace {

// Debian 12's <linux/landlock.h> ends at version 2 of the interface; the kernel that runs may know more. Numbers and
// layout are those of the kernel's user interface, see man 2 landlock_create_ruleset.
constexpr long version_flag = 1;
constexpr std::uint64_t read_file = 1U << 2U, read_folder = 1U << 3U;

struct Ruleset {
  std::uint64_t files;   ///< rights that are taken
  std::uint64_t net;     ///< since version 4: bind and connect by TCP
  std::uint64_t scoped;  ///< since version 6: abstract sockets and signals of others
};

#ifdef SYS_landlock_create_ruleset
std::uint64_t rights_of_files(long version) {
  const int n = version >= 5 ? 16 : version >= 3 ? 15 : version == 2 ? 14 : 13;
  return ((std::uint64_t{1} << n) - 1U) & ~(read_file | read_folder);
}
#endif

}  // namespace

bool restrict_files() {
#ifdef SYS_landlock_create_ruleset
  const long version = syscall(SYS_landlock_create_ruleset, nullptr, 0, version_flag);
  if (version < 1) return false;
  const Ruleset rules{rights_of_files(version), 3U, 3U};
  const std::size_t size = version >= 6   ? sizeof rules
                           : version >= 4 ? offsetof(Ruleset, scoped)
                                          : offsetof(Ruleset, net);
  const long set = syscall(SYS_landlock_create_ruleset, &rules, size, 0);
  if (set < 0) return false;
  const bool done = syscall(SYS_landlock_restrict_self, set, 0) == 0;
  close(static_cast<int>(set));
  return done;
#else
  return false;
#endif
}

}  // namespace upbead::detail
