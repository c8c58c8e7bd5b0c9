#include "input_files.h"

#include <fstream>
#include <sstream>

#include "case/case_schema.h"
#include "case/load_source.h"
#include "upbead/mesh/request.h"

namespace upbead {

std::vector<InputFile> input_files(const Case& problem) {
  std::vector<InputFile> files{{problem.document.path(), {problem.document.path()}}};
  const MeshRequest mesh = mesh_request(problem);
  files.push_back({mesh.file, mesh.place});
  for (const LoadSource* source : sources_of(problem)) append(files, source->files);
  for (const auto& [name, record] : problem.tables->measured)
    files.push_back({problem.resolve(record.file), problem.place(dotted("measured", name) + ".file")});
  append(files, files_of_cycles(problem));
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
