#include "algebra/petsc_options.h"

#include <petscsys.h>

#include <sstream>

#include "upbead/base/error.h"

namespace upbead {

namespace {

void check_options(PetscErrorCode error) {
  if (error != 0) throw NumericsError("PETSc does not take options (its error " + std::to_string(error) + ")");
}

bool is_option(const std::string& word) {
  PetscBool valid = PETSC_FALSE;
  check_options(PetscOptionsValidKey(word.c_str(), &valid));
  return valid == PETSC_TRUE;
}

}  // namespace

PetscOptionsGiven::PetscOptionsGiven(const std::string& text) {
  std::istringstream words(text);
  std::string known;
  bool may_be_value = false;  // at most one value follows an option
  for (std::string word; words >> word; known += word + " ") {
    const bool option = is_option(word);
    if (!option && !may_be_value)
      throw InputError({}, "--petsc: '" + word + "' is no option of PETSc",
                       "write it as in --petsc \"-mat_mumps_icntl_14 400\"");
    if (option) names_.push_back(word);
    may_be_value = option;
  }
  check_options(PetscOptionsInsertString(nullptr, known.c_str()));
}

void PetscOptionsGiven::require_used() const {
  Diagnostics mistakes;
  for (const std::string& name : names_) {
    PetscBool used = PETSC_FALSE;
    check_options(PetscOptionsUsed(nullptr, name.c_str() + 1, &used));
    if (used != PETSC_TRUE)
      mistakes.add({}, "--petsc: nothing in PETSc asks for " + name + " in this run",
                   "see PETSc's pages for its name, or leave it out");
  }
  mistakes.throw_if_any();
}

}  // namespace upbead
