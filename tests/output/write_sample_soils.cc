// write_sample_soils FILE: writes two_soils() into a file, for tests of programs.
#include <fstream>

#include "sample_soils.h"

int main(int argc, char** argv) {
  if (argc != 2) return 1;
  std::ofstream file(argv[1], std::ios::binary);
  file << upbead::soil_model_file(upbead::test::two_soils());
  return file.flush() ? 0 : 1;
}
