#include "algebra/versions.h"

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

/// The version at compile time: asking the libraries would load them all.
std::string mpi() {
#ifdef OMPI_MAJOR_VERSION
  return "Open MPI v" + dotted(OMPI_MAJOR_VERSION, OMPI_MINOR_VERSION, OMPI_RELEASE_VERSION);
#else
  return "of standard " + std::to_string(MPI_VERSION) + "." + std::to_string(MPI_SUBVERSION);
#endif
}

/// Debian chooses a BLAS at run time by a link, so that no header knows it. Returns the file that dgemm comes from;
/// for OpenBLAS, the description that the library gives.
std::string blas() {
  Dl_info found;
  void* dgemm = dlsym(RTLD_DEFAULT, "dgemm_");
  void* const library = dgemm == nullptr ? dlopen("libblas.so.3", RTLD_LAZY) : RTLD_DEFAULT;
  if (dgemm == nullptr && library != nullptr) dgemm = dlsym(library, "dgemm_");
  if (dgemm == nullptr || dladdr(dgemm, &found) == 0) return "unknown";
  const std::unique_ptr<char, void (*)(void*)> path(realpath(found.dli_fname, nullptr), std::free);
  std::string file = path ? path.get() : found.dli_fname;
  void* const config = dlsym(library, "openblas_get_config");
  if (config == nullptr || file.find("openblas") == std::string::npos) return file;
  std::string text = reinterpret_cast<const char* (*)()>(config)();
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

}  // namespace

Versions algebra_versions() {
  return {{"PETSc", dotted(PETSC_VERSION_MAJOR, PETSC_VERSION_MINOR, PETSC_VERSION_SUBMINOR)},
          {"CHOLMOD", dotted(CHOLMOD_MAIN_VERSION, CHOLMOD_SUB_VERSION, CHOLMOD_SUBSUB_VERSION)},
          {"Eigen", dotted(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
          {"BLAS", blas()},
          {"MPI", mpi()}};
}

}  // namespace upbead
