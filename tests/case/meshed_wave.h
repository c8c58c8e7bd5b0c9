// Cases of waves on meshes that the program makes.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "good_case.h"
#include "upbead/algebra/petsc_session.h"
#include "upbead/base/error.h"
#include "upbead/case/case_run.h"

namespace upbead::test {

class MeshedWave : public InFolder {
 protected:
  MeshedWave() {
    static const PetscSession petsc;  // MPI starts once in a process
    unsetenv("UPBEAD_MESHES");
  }
  static Case read(const std::string& text, const std::vector<std::string>& overrides = {}) {
    write("case.toml", text);
    return read_case("case.toml", overrides);
  }
  /// What is wrong with a case once it is meshed; "" where nothing is.
  static std::string objections(const std::string& text, const std::vector<std::string>& overrides = {}) {
    try {
      simulation_of(read(text, overrides));
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
};

}  // namespace upbead::test
