// gmsh in this process, from initialize to finalize.
#pragma once

#include <map>
#include <mutex>
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

/// gmsh has one state per process: while a session lives, others wait. Reads no configuration of the user and prints
/// nothing.
class GmshSession {
 public:
  GmshSession();
  ~GmshSession();
  GmshSession(const GmshSession&) = delete;
  GmshSession& operator=(const GmshSession&) = delete;

  /// Opens a .msh, or runs a .geo with `parameters` set before its first line. Throws GmshError.
  void open(const std::string& file, const std::map<std::string, double>& parameters);
  /// Meshes curves and surfaces of what is open. Throws GmshError.
  void generate();

 private:
  std::lock_guard<std::mutex> lock_;
};

}  // namespace upbead
