// What people read of the contact at the caisson's bottom.
#pragma once

#include <string>

#include "upbead/output/contact_summary.h"

namespace upbead {

/// Why the glued solution obeys the law of contact, with the numbers.
std::string why_glued(const ContactSummary& contact);

/// Lines of the report; empty where it was glued.
std::string describe(const ContactSummary& contact);

}  // namespace upbead
