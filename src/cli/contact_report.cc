#include "contact_report.h"

#include "base/text.h"

namespace upbead {

namespace {

std::string since(const std::optional<double>& time) {
  return time ? "from " + significant(*time, 4) + " s" : "never";
}

}  // namespace

std::string describe(const ContactSummary& contact) {
  if (!contact.solved) return "";
  const NodeContact& c = *contact.solved;
  std::string text = "contact     friction " + significant(contact.friction) + " at " + std::to_string(contact.nodes) +
                     " nodes, N at rest " + with_unit(contact.weight, "N/m") + "\n";
  text += "  slip        " + with_unit(c.slip, "m", c.largest_slip) +
          (c.error_estimate ? " (wrong by up to " + with_unit(*c.error_estimate, "m") + ")" : "") +
          " in the end, at most " + with_unit(c.largest_slip, "m") +
          " on the way, mean over the bottom; the whole of it " + with_unit(c.least_slip, "m", c.largest_slip) +
          "; nodes slip " + since(c.first_slip) + "\n";
  text += "  opening     seaward end " + with_unit(c.opening_seaward, "m") + ", landward end " +
          with_unit(c.opening_landward, "m") + "; nodes open " + since(c.first_open) + "; at least " +
          percent(c.least_contact) + " of the bottom touch\n";
  text += "  friction    took " + with_unit(c.dissipated, "J/m") + "; N falls to " +
          with_unit(c.least_normal_force, "N/m") + "\n";
  return text;
}

}  // namespace upbead
