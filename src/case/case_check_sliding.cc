#include "case_checks.h"
#include "records/gauge_keys.h"

namespace upbead {

namespace {

/// Exactly one of the ways to prescribe it.
void check_prescribed(const UpliftTable& uplift, const Objections& objections) {
  std::vector<std::string> ways;
  if (uplift.peak) ways.emplace_back("peak");
  if (!uplift.history_file.empty()) ways.emplace_back("history");
  if (!uplift.gauges.empty()) ways.emplace_back("gauges");
  if (ways.size() > 1)
    objections.add({ways[1], "both '" + ways[0] + "' and '" + ways[1] + "' are given", "keep one of them"});
  if (ways.empty())
    objections.add(
        {"peak", "neither 'peak' nor 'history' nor 'gauges' of a prescribed uplift is given", "add one of them"});
  if (!uplift.peak && !ways.empty() && uplift.lag > 0.)
    objections.add({"lag", "'lag' is that of an uplift that follows P, a history has its own times", "remove lag"});
}

void check_uplift(const UpliftTable& uplift, const CaseTables& tables, const Document& document, InputReport& report) {
  const Objections objections("sliding.uplift", document, report);
  if (uplift.kind == UpliftKind::prescribed) check_prescribed(uplift, objections);
  if (!uplift.gauges.empty()) {
    check_gauges(uplift, bottom_words, "sliding.uplift", document, report);
    if (!uplift.ends)
      objections.add({"ends", "it is not said where the bottom ends", "add ends = [seaward, landward] (m)"});
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
  if (sliding.uplift_table) check_uplift(*sliding.uplift_table, tables, document, report);
}

}  // namespace upbead
