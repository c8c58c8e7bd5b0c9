// Why a part of a scene is wrong.
#pragma once

#include <string>

namespace upbead {

/// The key to look at (of the part, or dotted within the whole), what is wrong with it and how to mend it.
struct Objection {
  std::string key;
  std::string what;
  std::string cure;
};

}  // namespace upbead
