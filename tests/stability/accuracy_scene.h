// Random sections with a caisson, small enough to be solved on a far finer mesh as the truth.
#pragma once

#include <cstdint>
#include <string>

#include "random_case.h"

namespace upbead::test {

/// The scene with that number of the stream `seed`; `section_geo` is the path of section.geo as the case names it.
///
/// Mounds of any slope and height, symmetric or not, flat beds, layers with a contrast of up to 30; rigid and elastic
/// caissons; sides that hold, give way or absorb; damping 0 to 10 %; one to three loads of 5 ms to 5 s; forces near
/// the threshold of sliding, a few with contact node by node. Meshes are made for tolerances of 2 to 8 % times `part`.
RandomCase accuracy_scene(std::uint64_t seed, std::uint64_t number, const std::string& section_geo, double part = 1.);

}  // namespace upbead::test
