// Options of PETSc that a person gives.
#pragma once

#include <string>
#include <vector>

namespace upbead {

class PetscOptionsGiven {
 public:
  PetscOptionsGiven() = default;
  /// Hands options such as "-mat_mumps_icntl_14 400" to PETSc, which must run (PetscSession). Objects that PETSc makes
  /// later follow them. Throws InputError at a word that is neither an option nor its value.
  explicit PetscOptionsGiven(const std::string& text);

  /// Throws InputError at options that nothing in PETSc has asked for up to now.
  void require_used() const;

 private:
  std::vector<std::string> names_;  ///< each with its dash
};

}  // namespace upbead
