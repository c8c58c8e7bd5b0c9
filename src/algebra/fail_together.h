// What each process does for itself, and may fail in.
#pragma once

#include <functional>
#include <string>

#include "upbead/algebra/processes.h"
#include "upbead/base/error.h"

namespace upbead::detail {

/// Calls work(). Where it throws NumericsError on some process, NumericsError is thrown on all: none waits for one that
/// has given up.
inline void fail_together(const Sharing& sharing, const std::function<void()>& work) {
  if (!sharing.processes) return work();
  double failed = 0.;
  std::string why;
  try {
    work();
  } catch (const NumericsError& error) {
    failed = 1.;
    why = error.what();
  }
  const bool failed_here = failed > 0.;
  sharing.processes->sum(&failed, 1);
  if (failed_here) throw NumericsError(why);
  if (failed > 0.) throw NumericsError("another process could not factorise its part of the matrix");
}

}  // namespace upbead::detail
