#include "cli/failure.h"

#include <exception>
#include <iostream>
#include <new>

#include "base/interrupt.h"
#include "upbead/base/error.h"

namespace upbead {

int tell_failure() {
  constexpr int exit_input = 1, exit_numerics = 2, exit_bug = 3, exit_signal = 128;
  try {
    throw;
  } catch (const InputError& error) {
    std::cerr << error.what() << "\n";
    return exit_input;
  } catch (const NumericsError& error) {
    std::cerr << "upbead: the numerics failed: " << error.what() << "\n";
    return exit_numerics;
  } catch (const Interrupted& interrupted) {
    std::cerr << "upbead: interrupted, nothing was written\n";
    return exit_signal + interrupted.signal();
  } catch (const std::bad_alloc&) {
    std::cerr << "upbead: the case does not fit in memory; use a coarser mesh, larger steps or fewer fields\n";
    return exit_numerics;
  } catch (const std::exception& error) {
    std::cerr << "upbead: this is a bug, please report it: " << error.what() << "\n";
    return exit_bug;
  }
}

}  // namespace upbead
