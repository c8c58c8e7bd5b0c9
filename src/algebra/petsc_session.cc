#include "upbead/algebra/petsc_session.h"

#include <petscsys.h>

#include <cstdlib>

#include "upbead/base/error.h"

namespace upbead {

namespace {

/// Without these Open MPI looks for a launcher's daemon and for network devices.
void start_as_lone_process() {
  if (std::getenv("OMPI_COMM_WORLD_SIZE") != nullptr) return;
  setenv("OMPI_MCA_btl", "self", 0);
  setenv("OMPI_MCA_pml", "ob1", 0);
  setenv("OMPI_MCA_ess", "singleton", 0);
  setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
}

}  // namespace

PetscSession::PetscSession() {
  PetscBool running = PETSC_FALSE;
  PetscInitialized(&running);
  if (running == PETSC_TRUE) return;
  start_as_lone_process();
  PetscErrorCode error = PetscOptionsSetValue(nullptr, "-no_signal_handler", "true");
  if (error == 0) error = PetscInitializeNoArguments();
  if (error == 0) error = PetscPushErrorHandler(PetscReturnErrorHandler, nullptr);
  if (error != 0) throw NumericsError("PETSc does not start (its error " + std::to_string(error) + ")");
  owner_ = true;
}

PetscSession::~PetscSession() {
  if (owner_) PetscFinalize();
}

}  // namespace upbead
