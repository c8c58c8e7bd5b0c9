// The units of the keys of a case.
#pragma once

#include <map>
#include <string>

#include "upbead/case/case.h"

namespace upbead {

/// Units by dotted key of every number that the case has, also of the parameters of its .geo where their comments name
/// one.
std::map<std::string, std::string> units_of_keys(const Case& problem);

}  // namespace upbead
