// Work on files of strangers, in a process of its own that can compute and hand back what it found, and nothing else.
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
  std::size_t memory = std::size_t{1} << 30;  ///< beyond what this process has when it begins (bytes); not under ASan
  /// Files whose names end so are not seen by whoever looks whether they exist; "": none.
  std::string hidden_ending;
};

/// How confined work ended.
struct ConfinedOutcome {
  std::optional<std::string> result;  ///< what the work returned
  std::string end;                    ///< why there is no result, as the rest of a sentence: "was ended by ..."
  std::vector<std::string> refused;   ///< what was tried and refused: "write the file '/tmp/x'", "start a program"
  bool confined = false;              ///< by seccomp or Landlock
};

/// Does `work` in a copy of this process. It cannot start programs, open connections, write, make, rename or remove
/// files, nor send signals: such calls fail with EPERM and are told in `refused` (or end it, while signals are
/// blocked). It sees no standard input, its output is lost, and it has no other open files of ours. An InputError of
/// `work` is thrown here too; other exceptions, signals, exit(), too much time or memory, and a wait for what does not
/// come (1 minute without computing) are the `end`.
/// Needs the Linux kernel's seccomp (actions TRAP and ERRNO) or Landlock; without both only crashes are kept off.
/// Sources: man 2 seccomp, man 7 landlock, man 3 seccomp_rule_add.
ConfinedOutcome work_confined(const std::function<std::string()>& work, const ConfinedLimits& limits);

/// Within such work: what was refused so far is not told, as it was a library's own beginning, which has seen no file
/// of a stranger.
void forget_refused();

/// Whether this kernel has seccomp or Landlock.
bool can_confine();

/// Enough to read a file: 5 s and 1 s per megabyte; 1 GB and 64 times its size.
ConfinedLimits limits_for_file(const std::string& file);

}  // namespace upbead
