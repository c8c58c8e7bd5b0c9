#include "contact_object.h"

#include <cmath>

#include "output/json_text.h"

namespace upbead {

using Json = nlohmann::ordered_json;

namespace {

Json to_object(const GluedDemand& d) {
  return {{"slip", std::isfinite(d.slip) ? Json(d.slip) : Json(nullptr)},
          {"least_normal", d.least_normal},
          {"margin", d.margin},
          {"reached", d.reached}};
}

Json to_object(const NodeContact& c) {
  return {{"slip", c.slip},
          {"error_estimate", json_or_null(c.error_estimate)},
          {"largest_slip", c.largest_slip},
          {"least_slip", c.least_slip},
          {"opening_seaward", c.opening_seaward},
          {"opening_landward", c.opening_landward},
          {"least_contact", c.least_contact},
          {"least_normal_force", c.least_normal_force},
          {"first_slip", json_or_null(c.first_slip)},
          {"first_open", json_or_null(c.first_open)},
          {"dissipated", c.dissipated},
          {"slip_steps", c.slip_steps},
          {"open_steps", c.open_steps},
          {"impacts", c.impacts},
          {"fallbacks", c.fallbacks}};
}

}  // namespace

Json to_object(const ContactSummary& contact) {
  return {{"friction", contact.friction},
          {"weight", contact.weight},
          {"nodes", contact.nodes},
          {"glued", to_object(contact.demand)},
          {"solved", contact.solved ? to_object(*contact.solved) : Json(nullptr)}};
}

}  // namespace upbead
