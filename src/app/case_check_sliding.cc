#include "case_checks.h"

namespace upbead {

namespace {

void check_uplift(const UpliftTable& uplift, const CaseTables& tables, const Objections& objections) {
  if (uplift.kind == UpliftKind::prescribed) {
    const bool by_history = !uplift.history_file.empty();
    if (uplift.peak && by_history)
      objections.add({"history", "both 'peak' and 'history' are given", "keep one of them"});
    if (!uplift.peak && !by_history)
      objections.add({"peak", "neither 'peak' nor 'history' of a prescribed uplift is given", "add peak or history"});
    if (by_history && uplift.lag > 0.)
      objections.add({"lag", "'lag' is that of an uplift that follows P, a history has its own times", "remove lag"});
  }
  for (const auto& [name, load] : tables.load_tables)
    if (load.boundary.empty() && load.region == caisson_name && load.direction[1] > 0. && load.factor != 0.)
      objections.add({"kind", "the load '" + name + "' lifts the caisson, so that an uplift would count twice",
                      "remove [sliding.uplift] or the upward part of [" + dotted("loads", name) + "]"});
}

/// Node by node and as a whole the caisson stands on one friction and one uplift.
void check_contact(const SlidingTable& sliding, const CaseTables& tables, bool has_friction,
                   const Objections& objections) {
  const std::optional<double>& mu = tables.regions.at(caisson_name).interface->coefficient;
  if (mu && has_friction && *mu != sliding.friction)
    objections.add({"friction",
                    "friction = " + number_text(sliding.friction) + " is not the coefficient = " + number_text(*mu) +
                        " of [regions.caisson] interface",
                    "give the same number, or only one of them"});
  if (sliding.uplift_table && sliding.uplift_table->kind == UpliftKind::prescribed)
    objections.add({"uplift", "a prescribed uplift cannot act node by node",
                    "write uplift = { kind = \"computed\" }, or [regions.caisson] interface = { kind = \"tied\" }"});
}

}  // namespace

void check_sliding(const CaseTables& tables, const Document& document, InputReport& report) {
  if (!tables.sliding_table || !report.sound("sliding")) return;
  const SlidingTable& sliding = *tables.sliding_table;
  const Objections objections("sliding", document, report);
  if (sliding.weight && sliding.buoyant_weight >= *sliding.weight)
    objections.add({"buoyant_weight",
                    "buoyant_weight = " + number_text(sliding.buoyant_weight) +
                        " N/m is not below weight = " + number_text(*sliding.weight) + " N/m",
                    "give W' in still water, W less the weight of the water that the caisson displaces"});
  if (report.sound("regions") && has_frictional_contact(tables))
    check_contact(sliding, tables, document.find("sliding.friction") != nullptr, objections);
  if (report.sound("regions") && tables.regions.count(caisson_name) == 0)
    objections.add({"friction", "there is no region 'caisson' that could slide",
                    "name the caisson's surface 'caisson', or remove [sliding]"});
  if (sliding.uplift_table) check_uplift(*sliding.uplift_table, tables, Objections("sliding.uplift", document, report));
}

}  // namespace upbead
