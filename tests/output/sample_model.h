// A reduced model made by hand: a caisson on a spring and a dashpot.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "upbead/output/model_file.h"

namespace upbead::test {

/// 604.8 t/m at 2 Hz with 15 % of critical damping under the loads `impact` and `slow`, each P; readings `force`,
/// `shear_force` and `caisson/displacement_x`, and a mode without meaning.
ReducedModelFile oscillator();

/// Larger models of it whose F_T is so many times that of the model itself.
NestedModels nested_oscillators(double middle, double reference);

/// That caisson on a ground of 50 t/m with the same spring and dashpot, over which it slips.
ModelSlip slipping_oscillator();

/// A file that is gone when the test is.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& bytes, const std::string& ending = ".h5")
      : path_((std::filesystem::temp_directory_path() / ("upbead-" + std::to_string(getpid()) + ending)).string()) {
    std::ofstream(path_, std::ios::binary) << bytes;
  }
  ~TemporaryFile() { std::filesystem::remove(path_); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

}  // namespace upbead::test
