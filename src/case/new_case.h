// A case to begin with, from a few numbers: a caisson on a rubble mound in the sea under one design wave.
#pragma once

#include <string>

namespace upbead {

/// The numbers that a person gives; soils and sides are assumed, and the case's comments say how.
struct NewCase {
  double width = 18., height = 16.;  ///< of the caisson (m)
  double depth = 15.;                ///< of still water above the seabed (m)
  double mound = 6., armour = 1.5;   ///< height of the mound, and of the armour in it (m)
  double shoulder = 7.;              ///< width of the berm on either side (m)
  double seabed = 15.;               ///< thickness down to a rigid base (m)
  double wave_height = 11.;          ///< of the highest wave (m)
  double period = 12.;               ///< s
};

/// A case in TOML with a comment at each number that is assumed. Throws InputError where the section does not stand
/// in the water.
std::string new_case(const NewCase& section, const std::string& title);

}  // namespace upbead
