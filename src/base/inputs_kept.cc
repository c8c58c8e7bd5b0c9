#include "base/inputs_kept.h"

#include <algorithm>
#include <filesystem>

#include "base/quoted.h"
#include "exchange.h"

namespace fs = std::filesystem;

namespace upbead {

namespace {

/// Files that are there and would be replaced.
std::vector<fs::path> replaced_files(const fs::path& folder, const std::vector<std::string>& outputs) {
  std::vector<fs::path> files;
  for (const std::string& output : outputs) {
    const fs::path place = fs::path(output).parent_path();
    std::error_code code;  // a folder that is not there holds no input
    for (fs::directory_iterator entry(folder / place, code), end; !code && entry != end; entry.increment(code))
      if (matches(place / entry->path().filename(), output)) files.push_back(entry->path());
  }
  return files;
}

bool is_same(const fs::path& a, const fs::path& b) {
  std::error_code different;
  return fs::equivalent(a, b, different);
}

}  // namespace

void require_inputs_kept(const std::string& folder, const std::vector<std::string>& outputs,
                         const std::vector<InputFile>& inputs) {
  const std::vector<fs::path> files = replaced_files(folder, outputs);
  Mistakes mistakes;
  for (const InputFile& input : inputs) {
    const auto taken =
        std::find_if(files.begin(), files.end(), [&](const fs::path& file) { return is_same(file, input.path); });
    if (taken != files.end())
      mistakes.add(input.place,
                   quoted_path(input.path) + " is read, and " + quoted_path(taken->string()) +
                       ", which would be written, is the same file",
                   "choose another folder with --out DIR");
  }
  mistakes.throw_if_any();
}

}  // namespace upbead
