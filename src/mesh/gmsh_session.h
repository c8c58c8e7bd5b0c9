// gmsh in this process, which is to be a confined one.
#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace upbead {

/// What gmsh itself said was wrong, message by message.
struct GmshError : std::runtime_error {
  explicit GmshError(std::vector<std::string> said) : std::runtime_error(said.front()), messages(std::move(said)) {}
  std::vector<std::string> messages;
};

/// gmsh from its beginning, without the settings of the user, silent. It has one state per process and is not closed:
/// the confined process ends with it. Where that does not end (fuzzing), the next session begins anew.
class GmshSession {
 public:
  GmshSession();

  /// Reads a .msh. Throws GmshError.
  void open_mesh(const std::string& file);
  /// Runs a .geo with `parameters` set before its first line. Throws GmshError.
  void open_script(const std::string& file, const std::map<std::string, double>& parameters);
  /// Meshes curves and surfaces of what is open. Throws GmshError.
  void generate();
};

}  // namespace upbead
