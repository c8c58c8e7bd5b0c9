// A reduced model made by hand: a caisson on a spring and a dashpot.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include "upbead/output/model_file.h"

namespace upbead::test {

/// 604.8 t/m at 2 Hz with 15 % of critical damping under the loads `impact` and `slow`, both forces P; readings
/// `force`, `shear_force` and `caisson/displacement_x`, and a mode without physical meaning.
ReducedModelFile oscillator();

/// Larger models of oscillator() whose F_T is `middle` and `reference` times that of the model.
NestedModels nested_oscillators(double middle, double reference);

/// The same caisson, which slips on a ground of 50 t/m with the same spring and dashpot.
ModelSlip slipping_oscillator();

/// Two slip circles, of three slices each, with readings of random size in the modes of oscillator().
CircleModel circles_under_an_oscillator();

/// The messages with which a reader refuses a file, with "m" for its path; "" where it reads the file.
std::string refusal_by(const std::function<void(const std::string& path)>& read, const std::string& path);

/// A file that the destructor removes.
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
