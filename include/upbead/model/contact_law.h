// What holds the caisson's bottom on its ground.
#pragma once

#include <optional>

namespace upbead {

enum class ContactKind {
  tied,      ///< it neither slips nor lifts
  friction,  ///< Coulomb friction and no tension, node by node
};

struct ContactLaw {
  ContactKind kind = ContactKind::tied;
  std::optional<double> coefficient;  ///< mu; none: that of [sliding], or 0.6
};

}  // namespace upbead
