#include "model/exclusions.h"

#include <algorithm>
#include <array>

namespace upbead {

namespace {

using Keys = std::vector<std::string>;

Keys when(bool asked, const std::string& key) {
  return asked ? Keys{key} : Keys();
}

/// Keys of the regions that have a table of that name.
template <class Table>
Keys in_regions(const Scene& scene, std::optional<Table> Region::*table, const std::string& name) {
  Keys keys;
  for (const auto& [region, values] : scene.regions)
    if (values.*table) keys.push_back("regions." + region + "." + name);
  return keys;
}

/// What a scene may ask for, and the keys by which one does.
struct Feature {
  const char* name;
  Keys (*asked)(const Scene& scene);
};

const Feature fields{"fields", [](const Scene& s) { return when(s.fields_every.has_value(), "output.fields"); }};
const Feature early_stop{"an early stop",
                         [](const Scene& s) { return when(s.time.stop_at_energy.has_value(), "time.stop_at_energy"); }};
const Feature strength{"strength of soil", [](const Scene& s) { return in_regions(s, &Region::strength, "strength"); }};
const Feature consolidation{"consolidation", [](const Scene& s) { return when(!s.time.inertia, "time.inertia"); }};
const Feature contact{"contact node by node",
                      [](const Scene& s) { return when(has_frictional_contact(s), "regions.caisson.interface"); }};
const Feature strain{"soil that follows its strain",
                     [](const Scene& s) { return in_regions(s, &Region::strain_law, "strain"); }};
const Feature by_reduced{"a reduced model by name",
                         [](const Scene& s) { return when(s.time.scheme == TimeScheme::reduced, "time.scheme"); }};

constexpr std::array way_names{"`time.scheme = \"reduced\"`", "`time.scheme = \"generalised_alpha\"`",
                               "`mesh.refine = \"auto\"`",    "`upbead reduce`",
                               "several processes",           "`--checkpoint`"};

struct Row {
  Treatment way;
  const Feature& feature;
  const char* why;
};

const std::vector<Row>& rows() {
  static const std::vector<Row> list{
      {Treatment::reduced_model, fields, "it gives no fields"},
      {Treatment::reduced_model, early_stop, "it keeps no account of energy to stop by"},
      {Treatment::reduced_model, strength, "it gives no stresses of all cells, which a strength needs"},
      {Treatment::reduced_model, consolidation, "it needs inertia"},
      {Treatment::reduced_model, contact, "it does not slip node by node"},
      {Treatment::generalised_alpha, contact, "it does not follow friction at the caisson's bottom"},
      {Treatment::adapted_mesh, consolidation, "time.inertia = false leaves nothing dynamic to tell"},
      {Treatment::reduce_command, consolidation, "consolidation cannot be reduced: inertia = false"},
      {Treatment::several_processes, by_reduced, "no reduced model is made"},
      {Treatment::several_processes, early_stop, "no run stops early"},
      {Treatment::several_processes, fields, "no fields are written"},
      {Treatment::several_processes, contact, "no contact is solved"},
      {Treatment::several_processes, strain, "soil does not follow its strain"},
      {Treatment::checkpoints, contact, "a run with contact keeps none"},
      {Treatment::checkpoints, strain, "a run with soil that follows its strain keeps none"}};
  return list;
}

}  // namespace

std::vector<Exclusion> excluded(const Scene& scene, Treatment way) {
  std::vector<Exclusion> list;
  for (const Row& row : rows()) {
    if (row.way != way) continue;
    for (std::string& key : row.feature.asked(scene)) list.push_back({std::move(key), row.why});
  }
  return list;
}

std::string exclusion_table() {
  std::string text = "| cannot do | what a case asks for | why |\n|---|---|---|\n";
  for (const Row& row : rows())
    text += std::string("| ") + way_names[static_cast<std::size_t>(row.way)] + " | " + row.feature.name + " | " +
            row.why + " |\n";
  return text;
}

}  // namespace upbead
