// PETSc runs for as long as an object lives.
#pragma once

namespace upbead {

/// Starts PETSc for this process, and MPI where it does not run yet; ends them again. main makes one before anything is
/// factorised. Without a launcher of MPI (is_launched() in base/cores.h), or as the only process of one, Open MPI
/// starts as a lone process, which takes 0.02 s instead of 0.4 s. PETSc installs no signal handler, and its errors come
/// back as error codes, not as prints. Throws NumericsError where PETSc does not start. Where PETSc runs already, does
/// nothing.
class PetscSession {
 public:
  PetscSession();
  ~PetscSession();
  PetscSession(const PetscSession&) = delete;
  PetscSession& operator=(const PetscSession&) = delete;

 private:
  bool owner_ = false;
};

}  // namespace upbead
