#include "input_files.h"

#include <fstream>
#include <sstream>

#include "case/cfd/flow_source.h"
#include "upbead/mesh/request.h"

namespace upbead {

std::vector<InputFile> input_files(const Case& problem) {
  std::vector<InputFile> files{{problem.document.path(), {problem.document.path()}}};
  const auto add = [&](const std::string& file, const std::string& key) {
    if (!file.empty()) files.push_back({problem.resolve(file), problem.place(key)});
  };
  const MeshRequest mesh = mesh_request(problem);
  files.push_back({mesh.file, mesh.place});
  for (const auto& [name, source] : problem.sources) add(source.history, dotted("loads", name) + ".history");
  for (const auto& [name, by] : problem.flows)
    for (const std::string& file : by.flow->files)
      files.push_back({file, problem.place(dotted("loads", name) + ".from")});
  for (const auto& [name, load] : problem.gauges) add(load.source.gauges, dotted("loads", name) + ".gauges");
  if (problem.uplift_gauges) add(problem.uplift_gauges->source.gauges, "sliding.uplift.gauges");
  add(problem.uplift_history, "sliding.uplift.history");
  for (const auto& [name, source] : problem.measured) add(source.file, dotted("measured", name) + ".file");
  return files;
}

void Fingerprint::add_file(const std::filesystem::path& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return;
  std::stringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  add(path.filename().string());
  add(text.str());
}

void Fingerprint::add_files(const Case& problem) {
  for (const InputFile& file : input_files(problem)) add_file(file.path);
}

}  // namespace upbead
