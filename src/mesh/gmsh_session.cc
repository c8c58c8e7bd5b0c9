#include "gmsh_session.h"

#include <gmsh.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <vector>

namespace upbead {

namespace {

std::mutex& gmsh_mutex() {
  static std::mutex mutex;
  return mutex;
}

/// A gmsh script of ours in the folder for temporary files, for as long as this lives.
class TemporaryScript {
 public:
  explicit TemporaryScript(const std::string& text)
      : path_((std::filesystem::temp_directory_path() / "upbead_XXXXXX.geo").string()) {
    const int file = mkstemps(path_.data(), 4);
    if (file < 0)
      throw GmshError({"cannot write a temporary file in " + std::filesystem::temp_directory_path().string()});
    close(file);
    std::ofstream(path_) << text;
  }
  ~TemporaryScript() { std::remove(path_.c_str()); }
  TemporaryScript(const TemporaryScript&) = delete;
  TemporaryScript& operator=(const TemporaryScript&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

std::vector<std::string> logged_errors() {
  std::vector<std::string> log, errors;
  gmsh::logger::get(log);
  const std::string mark = "Error: ";
  for (const std::string& line : log)
    if (line.rfind(mark, 0) == 0) errors.push_back(line.substr(mark.size()));
  return errors;
}

/// Runs one call of gmsh, which may throw, or log errors and return.
void run(const std::function<void()>& call) {
  gmsh::logger::start();
  std::string thrown;
  try {
    call();
  } catch (const std::string& error) {
    thrown = error.empty() ? "unknown error" : error;
  } catch (const std::exception& error) {  // std::bad_array_new_length, where a damaged .msh counts below zero
    thrown = error.what();
  }
  std::vector<std::string> errors = logged_errors();
  gmsh::logger::stop();
  if (errors.empty() && !thrown.empty()) errors.push_back(thrown);
  if (!errors.empty()) throw GmshError(errors);
}

std::string assignments(const std::map<std::string, double>& parameters) {
  std::string script;
  char number[40];
  for (const auto& [name, value] : parameters) {
    std::snprintf(number, sizeof number, "%.17g", value);
    script += name + " = " + number + ";\n";
  }
  return script;
}

}  // namespace

GmshSession::GmshSession() : lock_(gmsh_mutex()) {
  gmsh::initialize(0, nullptr, false);
  gmsh::option::setNumber("General.Terminal", 0);
  // By default gmsh throws from the middle of its parser, at the first error. That hides the other errors and leaves
  // the rest of the line behind, even beyond finalize, as the beginning of the next script.
  gmsh::option::setNumber("General.AbortOnError", 0);
}

GmshSession::~GmshSession() {
  gmsh::finalize();
}

void GmshSession::open(const std::string& file, const std::map<std::string, double>& parameters) {
  // gmsh's own -setnumber and its database of parameters outlive finalize, so the values go in by a script of their
  // own, whose variables open() forgets and merge() keeps. To include the file in that script would be a trap: its
  // `Abort` then closes a file twice.
  if (parameters.empty()) return run([&] { gmsh::open(file); });
  const TemporaryScript script(assignments(parameters));
  run([&] { gmsh::open(script.path()); });
  run([&] { gmsh::merge(file); });
}

void GmshSession::generate() {
  run([] { gmsh::model::mesh::generate(2); });
}

}  // namespace upbead
