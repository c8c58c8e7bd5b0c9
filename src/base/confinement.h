// Leaves a process the power to compute, and no other: seccomp and Landlock.
#pragma once

#include <string>
#include <vector>

// Whether this is a build under AddressSanitizer. Its runtime reserves terabytes of addresses, and makes pipes to see
// whether memory may be read.
#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define UPBEAD_ASAN
#endif
#elif defined(__SANITIZE_ADDRESS__)
#define UPBEAD_ASAN
#endif

namespace upbead::detail {

/// What a confined process tried. In memory shared with the process that waits for it, so that it is known after a
/// crash.
struct RefusedCalls {
  struct Call {
    int number;      ///< of the system call
    char path[240];  ///< its file, or ""
  };
  static constexpr int most = 8;  ///< number of calls that are kept
  int n = 0;
  Call call[most];
  bool confined = false;  ///< seccomp or Landlock is in force
};

/// Confines this process for good, as far as the kernel can. From then on calls that are not allowed fail, and are
/// noted in `refused`. `hidden_ending`: see ConfinedLimits.
void confine(RefusedCalls& refused, const std::string& hidden_ending);

/// What each call was for, each text once: "write the file '/tmp/x'". Harmless calls are left out.
std::vector<std::string> described(const RefusedCalls& refused);

}  // namespace upbead::detail
