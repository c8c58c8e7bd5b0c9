#include <gtest/gtest.h>

#include "upbead/algebra/petsc_session.h"

int main(int argc, char** argv) {
  const upbead::PetscSession petsc;
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
