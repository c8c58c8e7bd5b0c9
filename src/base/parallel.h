// Independent pieces of work on all cores.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace upbead {

/// Calls work(i) once for every i < n, from several threads, and shows how far it is as `what`. Throws the first
/// exception that a piece throws, and Interrupted; no piece begins after it.
void in_parallel(std::size_t n, const std::string& what, const std::function<void(std::size_t)>& work);

}  // namespace upbead
