#include "cli/commands.h"

namespace upbead {

void add_common_options(CLI::App& command, CommonOptions& options) {
  command.add_option("FILE", options.file, "the case (TOML)")->required();
  command.add_flag("--json", options.json, "print the summary as JSON on stdout and nothing else");
  command.add_option("--out", options.out, "folder for the results (default: results/NAME, NAME as the case file's)")
      ->type_name("DIR");
  command.add_option("--set", options.overrides, "use another value of one key; may be given many times")
      ->type_name("KEY=VALUE")
      ->take_all()
      ->allow_extra_args(false);
}

}  // namespace upbead
