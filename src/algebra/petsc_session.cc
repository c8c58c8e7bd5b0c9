#include "upbead/algebra/petsc_session.h"

#include <petscsys.h>
// after petscsys.h, which it needs
#include <petscblaslapack.h>

#include <cstdlib>
#if defined(__GLIBC__)
#include <malloc.h>
#endif
#include <vector>

#include "base/cores.h"
#include "base/launch.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

constexpr int keep_the_users = 0;

/// A solve of several processes is some dozens of messages. A process that waits for one leaves its core to others: by
/// default Open MPI lets it spin, and where other programs use the cores, too, each message takes a time slice of the
/// system (measured on two busy cores: 64 s for a run of 0.2 s).
void start_among_processes() {
  setenv("OMPI_MCA_mpi_yield_when_idle", "1", keep_the_users);
}

/// Without these settings, Open MPI looks for a launcher's daemon and for network devices, and makes a folder in /tmp
/// that all lone processes of a user share: a process that ends removes it while another starts, which then fails.
///
/// Where SLURM_NODELIST tells that srun has started it, but not by a PMI that Open MPI knows, Open MPI ends the
/// process.
void start_as_lone_process() {
  unsetenv("SLURM_NODELIST");
  setenv("OMPI_MCA_btl", "self", keep_the_users);
  setenv("OMPI_MCA_pml", "ob1", keep_the_users);
  setenv("OMPI_MCA_ess", "singleton", keep_the_users);
  setenv("OMPI_MCA_orte_create_session_dirs", "false", keep_the_users);
  setenv("OMPI_MCA_ess_singleton_isolated", "1", keep_the_users);
}

/// SuperLU_DIST, with which PETSc is linked, tells malloc when it is loaded never to give memory back: a process then
/// holds at its end all that it ever had. Here large arrays get pages of their own again, which go when they are freed,
/// as does the end of the heap; a quarter of a GB of it stays, where the next arrays find their pages (main.cc tells
/// why).
void let_malloc_give_back() {
#if defined(__GLIBC__)
  constexpr int most_arrays = 65536, large = 32 << 20, kept = 256 << 20;
  mallopt(M_MMAP_MAX, most_arrays);
  mallopt(M_MMAP_THRESHOLD, large);
  mallopt(M_TRIM_THRESHOLD, kept);
#endif
}

constexpr std::size_t more_than_blas_buffer = 160 << 20;  // bytes

/// Throws std::bad_alloc unless so much memory can be had.
void require_memory(std::size_t bytes) {
  ::operator delete(::operator new(bytes));  // the compiler might leave out a new-expression
}

/// Open MPI ends the process, as if the input were wrong, if it finds no memory while it starts: for its libraries, and
/// for the heaps of its two threads (glibc asks for 128 MB of addresses for each, and returns what it does not need).
void require_memory_to_start() {
  constexpr std::size_t threads = 256 << 20, libraries = 64 << 20;
  require_memory(threads + libraries + more_than_blas_buffer);
}

/// OpenBLAS retries for ever if it finds no memory for the buffer that it allocates at its first matrix product and
/// then keeps. Here there is memory, or std::bad_alloc; later a case may have taken all of it, and
/// would hang.
void let_blas_take_its_buffer() {
  require_memory(more_than_blas_buffer);
  const PetscBLASInt n = 128;
  const std::vector<double> A(n * n, 1.);
  std::vector<double> C(n * n);
  const double one = 1., zero = 0.;
  BLASgemm_("N", "N", &n, &n, &n, &one, A.data(), &n, A.data(), &n, &zero, C.data(), &n);
}

}  // namespace

PetscSession::PetscSession() {
  PetscBool running = PETSC_FALSE;
  PetscInitialized(&running);
  if (running == PETSC_TRUE) return;
  let_malloc_give_back();
  if (const auto launch = told_launch(); launch && launch->size == 1) leave_launcher();  // MPI would connect nobody
  is_launched() ? start_among_processes() : start_as_lone_process();
  require_memory_to_start();
  PetscErrorCode error = PetscOptionsSetValue(nullptr, "-no_signal_handler", "true");
  if (error == 0) error = PetscInitializeNoArguments();
  if (error == 0) error = PetscPushErrorHandler(PetscReturnErrorHandler, nullptr);
  if (error != 0) throw NumericsError("PETSc does not start (its error " + std::to_string(error) + ")");
  owner_ = true;
  let_blas_take_its_buffer();
}

PetscSession::~PetscSession() {
  if (owner_) PetscFinalize();
}

}  // namespace upbead
