#include "gmsh_session.h"

#include <fcntl.h>
#include <gmsh.h>
#include <sys/mman.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "base/confined_work.h"
#include "base/text.h"
#include "mesh/geo_script.h"

namespace upbead {

namespace {

/// The errors that gmsh reported, one message each.
struct GmshError : std::runtime_error {
  explicit GmshError(std::vector<std::string> said) : std::runtime_error(said.front()), messages(std::move(said)) {}
  std::vector<std::string> messages;
};

/// A file that gmsh opens under a name chosen here. Beside any X that it opens, gmsh also runs the script X.opt;
/// beside this name there is none.
class NamedFile {
 public:
  explicit NamedFile(int file) : file_(file) {
    if (file < 0) throw GmshError({std::string("the file cannot be opened: ") + std::strerror(errno)});
  }
  ~NamedFile() { close(file_); }
  NamedFile(const NamedFile&) = delete;
  NamedFile& operator=(const NamedFile&) = delete;
  std::string name() const { return "/proc/self/fd/" + std::to_string(file_); }

 private:
  int file_;
};

/// A file in memory (its descriptor; -1 where that fails).
int file_with(const std::string& text) {
  const int file = memfd_create("script", MFD_CLOEXEC);
  if (file >= 0 && write(file, text.data(), text.size()) != static_cast<ssize_t>(text.size())) return -1;
  return file;
}

std::vector<std::string> logged_errors() {
  std::vector<std::string> log, errors;
  gmsh::logger::get(log);
  const std::string mark = "Error: ";
  for (const std::string& line : log)
    if (line.rfind(mark, 0) == 0) errors.push_back(line.substr(mark.size()));
  return errors;
}

/// Runs one call of gmsh, which may throw an exception, or log errors and return.
void run(const std::function<void()>& call) {
  gmsh::logger::start();
  std::string thrown;
  try {
    call();
  } catch (const std::string& error) {
    thrown = error.empty() ? "unknown error" : error;
  } catch (const std::exception& error) {  // std::bad_array_new_length: a damaged .msh has a negative count
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

void begin() {
  static bool had_a_session = false;  // as in fuzzing, where one process reads many files
  if (had_a_session) gmsh::finalize();
  had_a_session = true;
  gmsh::initialize(0, nullptr, false);
  forget_refused();  // FLTK would keep the preferences of a user here, which is refused
  gmsh::option::setNumber("General.Terminal", 0);
  // By default gmsh throws from within its parser at the first error, which hides the other errors.
  gmsh::option::setNumber("General.AbortOnError", 0);
}

/// Reads a .msh.
void read_file(const std::string& file) {
  const NamedFile named(open(file.c_str(), O_RDONLY | O_CLOEXEC));
  run([&] { gmsh::open(named.name()); });
}

/// Runs a .geo with `parameters` set before its first line.
void run_script(const std::string& file, const std::map<std::string, double>& parameters) {
  // Opened under its own name, so that the files it includes are found. Where calls are filtered, gmsh does not see
  // X.opt.
  if (std::filesystem::exists(file + ".opt"))
    throw GmshError({"there is '" + file + ".opt' beside it, which gmsh would run too: rename it"});
  // gmsh's own -setnumber and its database of parameters outlive finalize (which fuzzing needs). So a separate script
  // sets the values: open() forgets its variables, merge() keeps them. That script cannot include the file: after an
  // `Abort` in it, gmsh closes a file twice.
  if (parameters.empty()) return run([&] { gmsh::open(file); });
  const NamedFile script(file_with(assignments(parameters)));
  run([&] { gmsh::open(script.name()); });
  run([&] { gmsh::merge(file); });
}

enum class FileKind { script, mesh, unknown };

FileKind kind_of(const std::string& file) {
  const std::string ending = std::filesystem::path(file).extension().string();
  return ending == ".geo" ? FileKind::script : ending == ".msh" ? FileKind::mesh : FileKind::unknown;
}

/// gmsh runs as a script whatever does not begin as a mesh.
bool begins_as_mesh(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  std::string line;
  std::getline(in, line);
  return line.rfind("$MeshFormat", 0) == 0 || line.rfind("$Comments", 0) == 0;
}

bool has_mesh_format(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  std::string beginning(4096, '\0');
  in.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
  return beginning.find("$MeshFormat") != std::string::npos && begins_as_mesh(file);
}

bool ends_with_newline(const std::string& file) {
  std::ifstream in(file, std::ios::binary | std::ios::ate);
  if (in.tellg() <= 0) return true;
  in.seekg(-1, std::ios::end);
  return in.get() == '\n';
}

void check_file(const std::string& file, MeshReport& report) {
  if (!std::filesystem::exists(file))
    return report.add("there is no file '" + file + "'", "check the name and the folder");
  if (std::filesystem::is_directory(file)) return report.add("'" + file + "' is a folder", "name the file in it");
  if (!std::filesystem::is_regular_file(file))
    return report.add("'" + file + "' is not a file of a known length", "name a file on a disk");
  if (!std::ifstream(file)) return report.add("'" + file + "' cannot be read", "check its permissions");
  switch (kind_of(file)) {
    case FileKind::unknown:
      return report.add("it is neither a .geo nor a .msh",
                        "give a gmsh script (.geo) or a gmsh mesh (.msh); gmsh makes one of other meshes (.inp, .unv, "
                        ".vtk, .bdf, .med): gmsh FILE -save -o FILE.msh");
    case FileKind::mesh:
      if (!has_mesh_format(file))
        report.add("it is not a gmsh mesh: it has no $MeshFormat at its beginning",
                   "save it from gmsh: File > Export, format 2.2 or 4.1");
      return;
    case FileKind::script:
      if (!ends_with_newline(file))
        report.add("its last line does not end with a newline, so gmsh may lose it", "end the file with a newline");
  }
}

std::string with_default(const GeoParameter& parameter) {
  return parameter.name + " = " + parameter.default_value;
}

void check_parameters(const MeshRequest& request, MeshReport& report) {
  if (request.parameters.empty()) return;
  if (kind_of(request.file) == FileKind::mesh)
    return report.add_about_parameters(
        "a .msh is finished and takes no parameters, not '" + request.parameters.begin()->first + "'",
        "drop them, or name the .geo that made it");
  std::vector<std::string> names, defaults;
  for (const GeoParameter& parameter : geo_parameters(request.file)) {
    names.push_back(parameter.name);
    defaults.push_back(with_default(parameter));
  }
  for (const auto& [name, value] : request.parameters) {
    if (std::find(names.begin(), names.end(), name) == names.end()) {
      const std::string near = nearest(name, names);
      report.add_about_parameters("it has no parameter '" + name + "'",
                                  (near.empty() ? "" : "did you mean '" + near + "'? ") +
                                      (names.empty() ? "it has none (no DefineConstant)" : "it has " + join(defaults)));
    } else if (!std::isfinite(value)) {
      report.add_about_parameters("parameter '" + name + "' is not a finite number", "give a finite number");
    }
  }
}

}  // namespace

bool is_script(const std::string& file) {
  return kind_of(file) == FileKind::script;
}

void check_source(const MeshRequest& request, MeshReport& report) {
  check_file(request.file, report);
  if (report.empty()) check_parameters(request, report);
}

void open_mesh(const MeshRequest& request, MeshReport& report) {
  const bool script = is_script(request.file);
  begin();
  try {
    if (script) {
      run_script(request.file, request.parameters);
      run([] { gmsh::model::mesh::generate(2); });
    } else {
      read_file(request.file);
    }
  } catch (const GmshError& error) {
    // One mistake makes many messages; the first ones suffice.
    const std::size_t count = std::min<std::size_t>(error.messages.size(), 5);
    for (std::size_t i = 0; i < count; ++i)
      report.add_about_parameters("gmsh says: " + error.messages[i],
                                  script ? "mend the script or its parameters" : "save the mesh again from gmsh");
  }
}

}  // namespace upbead
