#include "upbead/algebra/versions.h"

#include <cholmod.h>
#include <dlfcn.h>
#include <mpi.h>
#include <petscsys.h>

#include <Eigen/Core>
#include <cstdlib>
#include <memory>

namespace upbead {

namespace {

std::string dotted(int first, int second, int third) {
  return std::to_string(first) + "." + std::to_string(second) + "." + std::to_string(third);
}

std::string petsc() {
  PetscInt major = 0, minor = 0, patch = 0;
  PetscGetVersionNumber(&major, &minor, &patch, nullptr);
  return dotted(major, minor, patch);
}

std::string cholmod() {
  int version[3];
  cholmod_version(version);
  return dotted(version[0], version[1], version[2]);
}

/// "Open MPI v4.1.4", of a text that goes on with the package and the machine that it was built on.
std::string mpi() {
  char text[MPI_MAX_LIBRARY_VERSION_STRING];
  int length = 0;
  MPI_Get_library_version(text, &length);
  const std::string all(text, length);
  return all.substr(0, all.find_first_of(",\n"));
}

/// Debian chooses a BLAS at run time by a link, so no header knows: the file that dgemm comes from, or, where that is
/// OpenBLAS, what it says of itself.
std::string blas() {
  Dl_info found;
  void* const dgemm = dlsym(RTLD_DEFAULT, "dgemm_");
  if (dgemm == nullptr || dladdr(dgemm, &found) == 0) return "unknown";
  const std::unique_ptr<char, void (*)(void*)> path(realpath(found.dli_fname, nullptr), std::free);
  std::string file = path ? path.get() : found.dli_fname;
  void* const config = dlsym(RTLD_DEFAULT, "openblas_get_config");
  if (config == nullptr || file.find("openblas") == std::string::npos) return file;
  std::string text = reinterpret_cast<const char* (*)()>(config)();
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

}  // namespace

Versions algebra_versions() {
  return {{"PETSc", petsc()},
          {"CHOLMOD", cholmod()},
          {"Eigen", dotted(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
          {"BLAS", blas()},
          {"MPI", mpi()}};
}

}  // namespace upbead
