// Files that `respond` is given and that are cases: what is made of them needs a mesh.
#pragma once

#include <functional>
#include <string>

#include "base/files.h"
#include "cli/command.h"
#include "respond/wave_files.h"
#include "upbead/output/model_file.h"

namespace upbead {

struct RespondCases {
  /// Reduces a case, and writes its reduced.h5 into the folder.
  std::function<ReducedModelFile(const std::string& path, OutputFolder& folder)> model;
  /// The loads of a case as one wave of a model, whose loads have the same names.
  std::function<WaveFile(const std::string& path, const ReducedModelFile& model)> wave;
};

/// Without functions: of a program that does not mesh, and is not given cases.
Command respond_command(const RespondCases& cases);

/// `respond` of the program that meshes.
Command respond_cases_command();

/// Whether a path is that of a case.
bool is_case(const std::string& path);

}  // namespace upbead
