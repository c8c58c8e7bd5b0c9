// What a result was computed with, for whoever repeats it.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "base/version.h"

namespace upbead {

/// The program, its compiler and every library that numbers go through.
const Versions& versions();

/// "upbead 0.9.0; compiler g++ 12.2.0; ...": the attribute `versions` of HDF5 files.
std::string versions_line();

/// "upbead 0.9.0", and a line for each of the others.
std::string versions_text();

/// {"upbead": "0.9.0", ...}: the key `versions` of summaries.
nlohmann::ordered_json versions_object();

}  // namespace upbead
