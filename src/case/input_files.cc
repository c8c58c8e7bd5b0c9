#include "input_files.h"

#include "case/case_schema.h"
#include "case/load_source.h"
#include "mesh/geo_script.h"
#include "upbead/mesh/request.h"

namespace upbead {

std::vector<InputFile> input_files(const Case& problem) {
  std::vector<InputFile> files{{problem.document.path(), {problem.document.path()}}};
  const MeshRequest mesh = mesh_request(problem);
  for (const std::string& file : files_of_mesh(mesh.file)) files.push_back({file, mesh.place});
  for (const LoadSource* source : sources_of(problem)) append(files, source->files);
  for (const auto& [name, record] : problem.tables->measured)
    files.push_back({problem.resolve(record.file), problem.place(dotted("measured", name) + ".file")});
  append(files, files_of_cycles(problem));
  return files;
}

}  // namespace upbead
