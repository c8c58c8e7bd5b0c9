// Commands for a design: they read it, answer, and write a folder.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/stopwatch.h"
#include "cli/command.h"
#include "design/design.h"
#include "output/output_schema.h"

namespace upbead {

/// The results of a command for a design.
struct DesignOutput {
  std::vector<std::pair<std::string, std::string>> files;  ///< names and bytes, without case.toml and summary.json
  Json summary;                                            ///< summary.json
  std::string brief, warnings;                             ///< for stdout and stderr
};

struct DesignOptions : CommonOptions {
  bool details = false;  ///< --details
  std::string part;      ///< expected: --part: K/N or auto
  bool merge = false;    ///< expected
};

struct DesignWork {
  std::string suffix;  ///< of the default folder
  std::vector<DesignCheck> checks;
  std::vector<std::string> files;    ///< the files written
  std::vector<OutputRow> (*rows)();  ///< keys of the summary
  DesignOutput (*answer)(const Design& design, const DesignOptions& options, const Stopwatch& since_start);
  /// What --part does instead, with its exit code; null of a command that has no parts.
  int (*part)(const Design& design, const DesignOptions& options) = nullptr;
};

/// `command`: its name, what it does, and its footer.
Command design_command(Command command, const DesignWork& work);

Command expected_command();

}  // namespace upbead
