#include "model/exclusions.h"

#include <array>

namespace upbead {

namespace {

using Keys = std::vector<std::string>;

Keys when(bool asked, const std::string& key) {
  return asked ? Keys{key} : Keys();
}

/// Keys of the regions that have the table `name`.
template <class Table>
Keys in_regions(const Scene& scene, std::optional<Table> Region::*table, const std::string& name) {
  Keys keys;
  for (const auto& [region, values] : scene.regions)
    if (values.*table) keys.push_back("regions." + region + "." + name);
  return keys;
}

/// Keys of the laws of regions whose law is one of these.
Keys of_laws(const Scene& scene, bool (*is_meant)(SoilLaw law)) {
  Keys keys;
  for (const auto& [region, values] : scene.regions)
    if (is_meant(values.law)) keys.push_back("regions." + region + ".law");
  return keys;
}

/// Keys of the outer sides where `member` has the value of an absorbing side.
template <class Member, class Value>
Keys absorbing(const Scene& scene, Member member, Value value, const std::string& key) {
  Keys keys;
  for (const auto& [name, side] : scene.boundaries)
    if (side.*member == value) keys.push_back("boundaries." + name + "." + key);
  return keys;
}

/// Keys of the regions where a member has a value.
template <class Member, class Value>
Keys regions_with(const Scene& scene, Member member, Value value, const std::string& key) {
  Keys keys;
  for (const auto& [name, region] : scene.regions)
    if (region.*member == value) keys.push_back("regions." + name + "." + key);
  return keys;
}

bool deforms(const Scene& scene) {
  const auto caisson = scene.regions.find(caisson_name);
  return caisson != scene.regions.end() && caisson->second.kind == RegionKind::solid &&
         caisson->second.deformation != Deformation::rigid;
}

/// Something that a scene may ask for, and the keys that ask for it.
struct Feature {
  const char* name;
  Keys (*asked)(const Scene& scene);
};

const Feature fields{"fields", [](const Scene& s) { return when(s.fields_every.has_value(), "output.fields"); }};
const Feature early_stop{"an early stop",
                         [](const Scene& s) { return when(s.time.stop_at_energy.has_value(), "time.stop_at_energy"); }};
const Feature consolidation{"consolidation", [](const Scene& s) { return when(!s.time.inertia, "time.inertia"); }};
const Feature contact{"contact node by node",
                      [](const Scene& s) { return when(has_frictional_contact(s), "regions.caisson.interface"); }};
const Feature strain{"soil that follows its strain",
                     [](const Scene& s) { return in_regions(s, &Region::strain_law, "strain"); }};
const Feature yielding{"soil that yields",
                       [](const Scene& s) { return of_laws(s, [](SoilLaw law) { return law != SoilLaw::elastic; }); }};
const Feature densification{"soil that packs denser",
                            [](const Scene& s) { return in_regions(s, &Region::densification, "densification"); }};
const Feature motion{"a boundary whose motion is prescribed", [](const Scene& s) {
                       Keys keys;
                       for (const auto& [name, load] : s.loads) {
                         Scene alone;
                         alone.loads[name] = load;
                         alone.boundaries = s.boundaries;
                         if (has_prescribed_motion(alone)) keys.push_back("loads." + name + ".kind");
                       }
                       return keys;
                     }};
const Feature deforming_caisson{"a caisson that deforms",
                                [](const Scene& s) { return when(deforms(s), "regions.caisson.deformation"); }};
const Feature inertial_flow{"pore water with inertia",
                            [](const Scene& s) { return regions_with(s, &Region::flow, Flow::inertial, "flow"); }};
const Feature free_water{"free water",
                         [](const Scene& s) { return regions_with(s, &Region::kind, RegionKind::water, "kind"); }};
const Feature absorbing_side{"a side that absorbs waves of the skeleton", [](const Scene& s) {
                               return absorbing(s, &Boundary::displacement, DisplacementCondition::absorbing,
                                                "displacement");
                             }};
const Feature absorbing_pores{"a side that absorbs waves of the water", [](const Scene& s) {
                                return absorbing(s, &Boundary::pressure, PressureCondition::absorbing, "pressure");
                              }};

/// Keys of the loads that act and whose kind is one of those.
Keys loads_of_kind(const Scene& scene, bool (*is_one)(LoadKind)) {
  Keys keys;
  for (const auto& [name, load] : scene.loads)
    if (load.factor != 0. && is_one(load.kind)) keys.push_back("loads." + name + ".kind");
  return keys;
}

bool is_march(TimeScheme scheme) {
  return scheme != TimeScheme::automatic && scheme != TimeScheme::reduced;
}

const Feature by_stress{"stiffness that follows the stress at rest",
                        [](const Scene& s) { return in_regions(s, &Region::stress_law, "shear_modulus"); }};
const Feature air_by_depth{"air in pores by depth",
                           [](const Scene& s) { return regions_with(s, &Region::air_by_depth, true, "air_by_depth"); }};
const Feature strength{"a strength of linear soil",
                       [](const Scene& s) { return in_regions(s, &Region::strength, "strength"); }};
const Feature cycles{"cycles of a storm", [](const Scene& s) { return when(s.cycles.has_value(), "cycles"); }};
const Feature liquefaction{"momentary liquefaction", [](const Scene& s) {
                             return when(s.limits.liquefaction.has_value(), "limits.liquefaction");
                           }};
const Feature peak_safety{"strength at the peak",
                          [](const Scene& s) { return when(s.limits.peak_safety.has_value(), "limits.peak_safety"); }};
const Feature own_mesh_error{"an estimate of the mesh error",
                             [](const Scene& s) { return when(s.accuracy.estimate, "accuracy.estimate"); }};
const Feature adapted{"a mesh for the tolerance", [](const Scene& s) { return when(!s.mesh.refine, "mesh.refine"); }};
const Feature march_by_name{"a march by name",
                            [](const Scene& s) { return when(is_march(s.time.scheme), "time.scheme"); }};
const Feature shaking{"a base that is shaken", [](const Scene& s) { return loads_of_kind(s, is_motion); }};
const Feature volume_load{"gravity or a source of water as a load",
                          [](const Scene& s) { return loads_of_kind(s, is_on_volume); }};

const Feature two_levels{"sea and harbour at two levels", [](const Scene& s) {
                           return when(s.initial && s.initial->harbour_level, "initial.harbour_level");
                         }};

const Feature springs{"a caisson on springs",
                      [](const Scene& s) { return in_regions(s, &Region::springs, "springs"); }};

const Feature drag{"drag that grows with velocity",
                   [](const Scene& s) { return in_regions(s, &Region::forchheimer, "forchheimer"); }};

const Feature asked_law{"a law of stress in Python",
                        [](const Scene& s) { return of_laws(s, [](SoilLaw law) { return law == SoilLaw::python; }); }};

constexpr std::array way_names{"`time.scheme = \"reduced\"`",
                               "`time.scheme = \"generalised_alpha\"`",
                               "`mesh.refine = \"auto\"`",
                               "`upbead reduce`",
                               "one model for every soil",
                               "several processes",
                               "`--checkpoint`",
                               "contact node by node",
                               "consolidation"};

constexpr const char* no_waves = "without inertia (time.inertia = false) there are no waves to absorb";

struct Row {
  Treatment way;
  const Feature& feature;
  const char* why;
  const char* cure = "";
};

/// Of one model for every soil.
std::vector<Row> rows_of_soils() {
  return {{Treatment::soil_model, early_stop, "it keeps no account of energy to stop by"},
          {Treatment::soil_model, consolidation, "it needs inertia"},
          {Treatment::soil_model, contact, "it does not slip node by node"},
          {Treatment::soil_model, strain, "stiffness cell by cell is no sum of a few parts"},
          {Treatment::soil_model, by_stress, "stiffness cell by cell is no sum of a few parts"},
          {Treatment::soil_model, air_by_depth, "storage cell by cell is no sum of a few parts"},
          {Treatment::soil_model, drag, "conductivity cell by cell is no sum of a few parts"},
          {Treatment::soil_model, yielding, "soil that yields is not linear"},
          {Treatment::soil_model, shaking, "its parts would need loads of their own"},
          {Treatment::soil_model, volume_load, "its parts would need loads of their own"},
          {Treatment::soil_model, deforming_caisson, "its basis keeps the motions of a rigid caisson alone"},
          {Treatment::soil_model, fields, "it holds readings alone"},
          {Treatment::soil_model, strength, "it holds readings alone, and strength is compared everywhere"},
          {Treatment::soil_model, cycles, "it holds readings alone"},
          {Treatment::soil_model, liquefaction, "it holds readings alone"},
          {Treatment::soil_model, peak_safety, "it holds readings alone"},
          {Treatment::soil_model, own_mesh_error, "each soil would be solved on other meshes, too"},
          {Treatment::soil_model, adapted, "each soil has a mesh of its own"},
          {Treatment::soil_model, march_by_name, "it marches nothing"},
          {Treatment::soil_model, springs, "no soil is under it"}};
}

std::vector<Row> rows_of_the_rest() {
  return {{Treatment::reduced_model, early_stop, "it keeps no account of energy to stop by"},
          {Treatment::reduced_model, consolidation, "it needs inertia"},
          {Treatment::reduced_model, yielding, "soil that yields has no modes"},
          {Treatment::reduced_model, motion, "a motion that is prescribed is marched"},
          {Treatment::generalised_alpha, contact, "it does not follow friction at the caisson's bottom"},
          {Treatment::generalised_alpha, yielding, "soil that yields is marched by a scheme of its own"},
          {Treatment::adapted_mesh, consolidation, "time.inertia = false leaves nothing dynamic to tell"},
          {Treatment::adapted_mesh, yielding, "its errors are those of linear soil"},
          {Treatment::adapted_mesh, motion, "its errors are those of forces and pressures"},
          {Treatment::reduce_command, motion, "a motion that is prescribed is marched"},
          {Treatment::reduce_command, yielding, "soil that yields has no modes"},
          {Treatment::reduce_command, drag, "every wave has a drag of its own"},
          {Treatment::reduce_command, consolidation, "consolidation cannot be reduced: inertia = false"},
          {Treatment::several_processes, densification, "no soil packs denser"},
          {Treatment::several_processes, springs, "no caisson stands on springs"},
          {Treatment::adapted_mesh, springs, "there is no ground whose cells it could split"},
          {Treatment::checkpoints, densification, "a run with soil that packs denser keeps none"},
          {Treatment::checkpoints, contact, "a run with contact keeps none"},
          {Treatment::checkpoints, strain, "a run with soil that follows its strain keeps none"},
          {Treatment::checkpoints, drag, "a run with such drag keeps none"},
          {Treatment::checkpoints, asked_law, "its memory is in Python"},
          {Treatment::contact, deforming_caisson, "a caisson that deforms cannot slip",
           "give it kind = \"rigid\", or deformation = \"rigid\""},
          {Treatment::contact, springs, "springs at its middle do not lift from its edges",
           "write kind = \"bonded\": [sliding] tells how far it slips as a whole"},
          {Treatment::contact, two_levels, "friction node by node begins without the shear of still water",
           "write kind = \"bonded\", or give one level"},
          {Treatment::consolidation, springs, "without inertia a caisson on springs only follows its load: F_T = P",
           "write inertia = true"},
          {Treatment::consolidation, inertial_flow, "flow = \"inertial\" contradicts time.inertia = false",
           "write flow = \"auto\" or inertia = true"},
          {Treatment::consolidation, free_water, "free water is its own inertia, which time.inertia = false leaves out",
           "remove the region, and give the water's pressure on bed and mound as a load"},
          {Treatment::consolidation, absorbing_side, no_waves, "say \"roller\""},
          {Treatment::consolidation, absorbing_pores, no_waves, "say \"sealed\""}};
}

const std::vector<Row>& rows() {
  static const std::vector<Row> list = [] {
    std::vector<Row> all = rows_of_the_rest();
    for (const Row& row : rows_of_soils()) all.push_back(row);
    return all;
  }();
  return list;
}

}  // namespace

std::vector<Exclusion> excluded(const Scene& scene, Treatment way) {
  std::vector<Exclusion> list;
  for (const Row& row : rows()) {
    if (row.way != way) continue;
    for (std::string& key : row.feature.asked(scene)) list.push_back({std::move(key), row.why, row.cure});
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
