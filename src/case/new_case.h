// A case to begin with: a caisson on a rubble mound in the sea under one design wave, from a few numbers.
#pragma once

#include <string>

namespace upbead {

/// What a person says of the section; soils and sides are assumed, which the case's comments tell.
struct NewCase {
  double width = 18., height = 16.;  ///< of the caisson (m)
  double depth = 15.;                ///< of still water over the seabed (m)
  double mound = 6., armour = 1.5;   ///< height of the mound, and of the armour in it (m)
  double shoulder = 7.;              ///< of the mound's crest beside the caisson, on either side (m)
  double seabed = 15.;               ///< thickness down to a rigid base (m)
  double wave_height = 11.;          ///< of the highest wave (m)
  double period = 12.;               ///< s
};

/// A TOML case with a comment where a number is an assumption. Throws InputError where the section does not stand in
/// the water.
std::string new_case(const NewCase& section, const std::string& title);

}  // namespace upbead
