#include "fingerprint.h"

#include <fstream>
#include <sstream>

#include "upbead/mesh/mesh.h"

namespace upbead {

void Fingerprint::add_file(const std::filesystem::path& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return;
  std::stringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  add(path.filename().string());
  add(text.str());
}

void Fingerprint::add_files(const Case& problem) {
  add_file(problem.document.path());
  add_file(mesh_request(problem).file);
  for (const auto& [name, source] : problem.sources)
    if (!source.history.empty()) add_file(problem.resolve(source.history));
  for (const auto& [name, load] : problem.gauges) add_file(problem.resolve(load.source.gauges));
  if (problem.uplift_gauges) add_file(problem.resolve(problem.uplift_gauges->source.gauges));
  if (!problem.uplift_history.empty()) add_file(problem.resolve(problem.uplift_history));
}

}  // namespace upbead
