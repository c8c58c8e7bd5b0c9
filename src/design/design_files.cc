#include "design_files.h"

namespace upbead {

std::vector<InputFile> input_files(const Design& design) {
  std::vector<InputFile> files{{design.document.path(), {design.document.path()}}};
  const auto add = [&](const std::string& file, const std::string& key) {
    if (!file.empty()) files.push_back({design.resolve(file), design.document.place(key)});
  };
  const DesignTables& tables = design.tables;
  if (tables.sea) add(tables.sea->states, "sea.states");
  if (tables.dynamics) add(tables.dynamics->model, "dynamics.model");
  if (tables.calibration)
    for (const auto& [name, model] : tables.calibration->models)
      add(model.model, dotted("calibration.models", name) + ".model");
  return files;
}

}  // namespace upbead
