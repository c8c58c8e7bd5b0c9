#include "gmsh_session.h"

#include <fcntl.h>
#include <gmsh.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <functional>
#include <vector>

#include "base/confined_work.h"

namespace upbead {

namespace {

/// A file that gmsh opens by a name of our own. gmsh takes up X.opt, a script, beside whatever X it is asked to open;
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

/// A file in memory.
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

GmshSession::GmshSession() {
  static bool had_a_session = false;
  if (had_a_session) gmsh::finalize();
  had_a_session = true;
  gmsh::initialize(0, nullptr, false);
  forget_refused();  // FLTK would keep the preferences of a user here
  gmsh::option::setNumber("General.Terminal", 0);
  // By default gmsh throws from the middle of its parser, at the first error, which hides the others.
  gmsh::option::setNumber("General.AbortOnError", 0);
}

void GmshSession::open_mesh(const std::string& file) {
  const NamedFile named(open(file.c_str(), O_RDONLY | O_CLOEXEC));
  run([&] { gmsh::open(named.name()); });
}

void GmshSession::open_script(const std::string& file, const std::map<std::string, double>& parameters) {
  // Under its own name, or what it includes would not be found. Where calls are filtered, X.opt is not seen.
  if (std::filesystem::exists(file + ".opt"))
    throw GmshError({"there is '" + file + ".opt' beside it, which gmsh would run too: rename it"});
  // gmsh's own -setnumber and its database of parameters outlive finalize (which fuzzing needs), so the values go in by
  // a script of their own, whose variables open() forgets and merge() keeps. To include the file in that script would
  // be a trap: its `Abort` then closes a file twice.
  if (parameters.empty()) return run([&] { gmsh::open(file); });
  const NamedFile script(file_with(assignments(parameters)));
  run([&] { gmsh::open(script.name()); });
  run([&] { gmsh::merge(file); });
}

void GmshSession::generate() {
  run([] { gmsh::model::mesh::generate(2); });
}

}  // namespace upbead
