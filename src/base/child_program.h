// Another program of upbead that does a part of the work, in a process of its own.
#pragma once

#include <string>
#include <vector>

namespace upbead {

/// How a child has ended.
struct ChildEnd {
  int code = 0;      ///< its exit code; 128 + signal where a signal ended it
  std::string told;  ///< what it wrote to stderr, without lines of progress
};

/// Runs the program `name`, which lies beside this one, with these words on its command line, and waits for its end.
/// What it prints on stdout is lost; its progress is shown on this process's stderr. Where this process is interrupted
/// so is the child: throws Interrupted. Throws InputError where the program cannot be started.
/// `what`: the activity that is shown.
ChildEnd run_child(const std::string& name, const std::vector<std::string>& words, const std::string& what);

/// The text without lines of progress; `share` becomes that of the last one, 0 to 1.
std::string without_progress(const std::string& text, double& share);

}  // namespace upbead
