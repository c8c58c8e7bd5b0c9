// One target under libFuzzer; UPBEAD_TARGET is its function.
#include <cstddef>
#include <cstdint>

#include "target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  upbead::fuzz::UPBEAD_TARGET({reinterpret_cast<const char*>(data), size});
  return 0;
}
