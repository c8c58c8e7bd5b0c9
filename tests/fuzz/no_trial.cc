// For targets whose files the libraries can read: without a copy of the process for each, a hundred times as many.
#include "upbead/base/trial_run.h"

namespace upbead {

bool survives(const std::string&, const std::function<void()>&) {
  return true;
}

}  // namespace upbead
