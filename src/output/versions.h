// The versions with which a result was computed, so that it can be repeated.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "base/version.h"

namespace upbead {

/// The program, its compiler and every library that takes part in computing or storing numbers.
const Versions& versions();

/// "upbead 0.9.0; compiler g++ 12.2.0; ...": the attribute `versions` of HDF5 files.
std::string versions_line();

/// "upbead 0.9.0", and one line for the compiler and each library.
std::string versions_text();

/// {"upbead": "0.9.0", ...}: the key `versions` of summaries.
nlohmann::ordered_json versions_object();

}  // namespace upbead
