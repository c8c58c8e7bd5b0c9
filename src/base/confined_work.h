// Work on files from unknown sources, in a separate process that can compute and return its result, and nothing else.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace upbead {

/// What a confined process may use, and how.
struct ConfinedLimits {
  double seconds = 60.;                       ///< of computing
  std::size_t memory = std::size_t{1} << 30;  ///< beyond the use of this process at its start (bytes); not under ASan
  /// A confined process does not see that files with this ending exist; "": all are seen.
  std::string hidden_ending;
};

/// How confined work ended.
struct ConfinedOutcome {
  std::optional<std::string> result;  ///< what the work returned
  std::string end;                    ///< why there is no result, as the rest of a sentence: "was ended by ..."
  std::vector<std::string> refused;   ///< what was tried and refused: "write the file '/tmp/x'", "start a program"
  bool confined = false;              ///< by seccomp or Landlock
};

/// Does `work` in a copy of this process. The copy cannot start programs, open connections, write, make, rename or
/// remove files, nor send signals: such calls fail with EPERM and are listed in `refused` (while signals are blocked,
/// they end the copy). The copy has no standard input, its output is lost, and no other file of this process is open
/// in it. An InputError of `work` is thrown here too; other exceptions, signals, exit(), too much time or memory, and
/// a minute without computing are described in `end`.
/// Needs the Linux kernel's seccomp (actions TRAP and ERRNO) or Landlock; without both, this process is safe from
/// crashes only.
/// Sources: man 2 seccomp, man 7 landlock, man 3 seccomp_rule_add.
ConfinedOutcome work_confined(const std::function<std::string()>& work, const ConfinedLimits& limits);

/// Call within such work, after a library has started and before it reads the file: calls refused so far are not
/// listed.
void forget_refused();

/// Whether this kernel has seccomp or Landlock.
bool can_confine();

/// Limits that suffice to read a file: 5 s and 1 s per megabyte; 1 GB and 64 times its size.
ConfinedLimits limits_for_file(const std::string& file);

}  // namespace upbead
