// What people read of the contact at the caisson's bottom.
#pragma once

#include <string>

#include "upbead/output/summary.h"

namespace upbead {

/// Lines of the report; empty where it was glued.
std::string describe(const ContactSummary& contact);

}  // namespace upbead
