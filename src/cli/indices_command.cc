// The command indices: Sobol indices of the numbers of a study.
#include <filesystem>
#include <iostream>

#include "base/files.h"
#include "cli/command.h"
#include "reliability/indices.h"

namespace upbead {

namespace {

struct IndicesOptions {
  std::string folder, out;
  std::vector<std::string> of;
  bool json = false;
};

int indices(const IndicesOptions& options) {
  const std::filesystem::path folder(options.folder);
  const StudyIndices found = find_indices(read_sobol_study(options.folder, options.of));
  const std::string out = options.out.empty() ? (folder / "indices.json").string() : options.out;
  const std::filesystem::path parent = std::filesystem::path(out).parent_path();
  require_inputs_kept(parent.empty() ? "." : parent.string(), {std::filesystem::path(out).filename().string()},
                      {{(folder / "study.h5").string(), {options.folder}}});
  const std::string json = to_json(found);
  write_whole(out, json);
  std::cerr << describe(warnings_of(found));
  std::cout << (options.json ? json : describe(found) + "written     " + out + "\n");
  return 0;
}

const char* const indices_footer =
    R"(Which share of the variance of a number is due to each varied key? The study needs
  sample = "sobol"
  n = 256                        # points, best a power of 2; it makes n (keys + 2) runs
  [vary."regions.seabed.shear_modulus"]
  distribution = "log_uniform"   # as in random samples, independent of each other
  low = 20e6
  high = 60e6

first: by the key alone; total: by the key, alone and together with others; both with intervals of 95 %. A key with a total
of 0 may be fixed; where first and total differ, it acts together with others. docs/study.md says how they are made.

Writes FOLDER/indices.json (or --out FILE). Warnings go to stderr and into that file.

Examples:
  upbead study cases/study/indices.toml
  upbead indices results/indices
  upbead indices results/indices --of response.shear_to_force_ratio --json | jq '.numbers[0].keys')";

}  // namespace

Command indices_command() {
  const auto options = std::make_shared<IndicesOptions>();
  Command command = sampling_commands().back();
  command.options = {
      {"FOLDER", &options->folder, "the results of a study with sample = \"sobol\"", "", true},
      {"--of", &options->of, "only this number, a path that the study read; may be given many times", "PATH"},
      {"--json", &options->json, "print indices.json on stdout and nothing else"},
      {"--out", &options->out, "the file (default: FOLDER/indices.json)", "FILE"}};
  command.footer = indices_footer;
  command.work = [options] { return indices(*options); };
  return command;
}

}  // namespace upbead
