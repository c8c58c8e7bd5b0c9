#include "case_schema.h"
#include "material/soil_law.h"
#include "model/words.h"

namespace upbead {

namespace {

TableSchema<Rayleigh> damping_schema() {
  TableSchema<Rayleigh> table;
  table.key("ratio", &Rayleigh::ratio).range(from_to_below(0., 1.)).required().doc("damping ratio at both frequencies");
  table.key("frequencies", &Rayleigh::frequencies)
      .unit("Hz")
      .range(above(0.))
      .doc("two frequencies, ascending, at or between which the ratio holds");
  table.choice("fit", &Rayleigh::fit, rayleigh_fit_words)
      .doc(
          "where the ratio holds; ends: at both frequencies, less between them; band: between them, as much above it "
          "at "
          "the ends as below it in the middle");
  return table;
}

TableSchema<StressLaw> stress_law_schema() {
  TableSchema<StressLaw> table;
  table.key("reference", &StressLaw::reference)
      .unit("Pa")
      .range(above(0.))
      .required()
      .doc("shear modulus G at the stress `pressure`");
  table.key("pressure", &StressLaw::pressure)
      .unit("Pa")
      .range(above(0.))
      .doc("mean effective stress to which `reference` belongs");
  table.key("exponent", &StressLaw::exponent).range(from_to(0., 1.)).doc("exponent of the stress");
  table.key("floor", &StressLaw::floor)
      .unit("Pa")
      .range(above(0.))
      .fallback("a tenth of the region's mean")
      .doc("least mean effective stress that counts; near free surfaces G would vanish");
  return table;
}

TableSchema<StrainLaw> strain_law_schema() {
  TableSchema<StrainLaw> table;
  table.key("reference_strain", &StrainLaw::reference_strain)
      .range(above(0.))
      .doc("shear strain at which G is half of that at vanishing strain (Hardin and Drnevich)");
  table.key("smallest_damping", &StrainLaw::smallest_damping)
      .range(from_to_below(0., 1.))
      .doc("damping ratio at vanishing strain");
  table.key("largest_damping", &StrainLaw::largest_damping)
      .range(from_to_below(0., 1.))
      .doc("damping ratio at large strain");
  table.key("effective", &StrainLaw::effective).range(above(0.)).doc("effective over largest shear strain of a cell");
  table.key("modulus", &StrainLaw::modulus)
      .fallback("by reference_strain")
      .doc("pairs of shear strain and G/G_max, straight over the logarithm of the strain");
  table.key("damping", &StrainLaw::damping)
      .fallback("by smallest_damping and largest_damping")
      .doc("pairs of shear strain and damping ratio, likewise");
  return table;
}

TableSchema<Strength> strength_schema() {
  TableSchema<Strength> table;
  table.key("friction_angle", &Strength::friction_angle)
      .unit("degrees")
      .range(from_to_below(0., 90.))
      .required()
      .doc("effective angle of friction phi'");
  table.key("cohesion", &Strength::cohesion).unit("Pa").range(at_least(0.)).doc("effective cohesion c'");
  table.key("dilatancy_angle", &Strength::dilatancy_angle)
      .unit("degrees")
      .range(from_to_below(0., 90.))
      .doc("angle of dilatancy psi' of Mohr-Coulomb soil, up to friction_angle");
  table.key("tension", &Strength::tension)
      .unit("Pa")
      .range(at_least(0.))
      .doc("largest tensile stress of Mohr-Coulomb soil, up to cohesion / tan(friction_angle)");
  return table;
}

TableSchema<Densification> densification_schema() {
  TableSchema<Densification> table;
  table.key("relative_density", &Densification::relative_density)
      .range(from_to(0.2, 1.))
      .doc("relative density D_r; gives c1 = 7600 (100 D_r)^-2.5 (Byrne 1991); or c1");
  table.key("c1", &Densification::c1)
      .range(above(0.))
      .doc("volumetric strain over shear strain of the first cycle, instead of relative_density");
  table.key("c2", &Densification::c2)
      .range(at_least(0.))
      .fallback("0.4 / c1")
      .doc("how fast later cycles add less, with c1");
  table.key("threshold", &Densification::threshold)
      .range(at_least(0.))
      .doc("amplitude of the shear strain up to which nothing is added; sand has about 1e-4");
  return table;
}

TableSchema<ContactLaw> contact_schema() {
  TableSchema<ContactLaw> table;
  table.choice("kind", &ContactLaw::kind, contact_kind_words)
      .formerly_word("tied", "bonded")
      .doc("bonded: it neither slips nor lifts; friction: Coulomb friction and no tension, node by node");
  table.key("coefficient", &ContactLaw::coefficient)
      .range(above(0.))
      .fallback("friction of [sliding], or 0.6")
      .doc("friction coefficient mu")
      .when(
          "kind", [](const ContactLaw& law) { return law.kind == ContactKind::friction; },
          "where the contact is by friction");
  return table;
}

/// Marks a key as belonging to some kinds of region only.
void limit(const Entry<Region>& entry) {
  std::vector<std::string> kinds;
  for (const auto& [word, kind] : region_kind_words)
    if (belongs(entry.name(), kind)) kinds.push_back(word);
  entry.when(
      "kind", [key = entry.name()](const Region& region) { return belongs(key, region.kind); },
      "in " + join(kinds, " and ") + " regions");
}

std::string how_laws_follow_strain() {
  std::string text = "how stress follows strain; elastic: linear, or equivalent-linear with a table strain";
  for (const SoilLawRow* row : soil_law_rows()) text += std::string("; ") + row->word + ": " + row->how;
  return text;
}

void declare_skeleton(TableSchema<Region>& table) {
  limit(table.key_or_table("shear_modulus", &Region::shear_modulus, &Region::stress_law, stress_law_schema())
            .unit("Pa")
            .range(above(0.))
            .doc("shear modulus G of the skeleton; or youngs_modulus; as a table, of a porous region: G = reference "
                 "(mean effective stress / pressure)^exponent"));
  limit(table.choice("law", &Region::law, soil_law_words).doc(how_laws_follow_strain()));
  limit(table.table("strain", &Region::strain_law, strain_law_schema())
            .doc("Of elastic soil: equivalent-linear, G and damping by the strain of the response, iterated cell by "
                 "cell; linear without this table. Of hysteretic soil: its curve of G, from which damping follows."));
  limit(table.key("youngs_modulus", &Region::youngs_modulus)
            .unit("Pa")
            .range(above(0.))
            .doc("Young modulus E of the skeleton; or shear_modulus"));
  limit(table.key("poissons_ratio", &Region::poissons_ratio)
            .range(from_to_below(0., 0.5))
            .doc("Poisson ratio of the drained skeleton; needed"));
  limit(table.table("damping", &Region::damping, damping_schema())
            .doc("Rayleigh damping; without this table there is none."));
  limit(table.table("strength", &Region::strength, strength_schema())
            .doc("Mohr-Coulomb strength. Stresses of elastic soil, static plus dynamic, are compared with it and do "
                 "not change; other laws yield at it."));
  limit(table.table("densification", &Region::densification, densification_schema())
            .doc("Sand that packs denser under cycles of shear, with law hysteretic or mohr_coulomb: pore pressure "
                 "where its water stays, settlement where it goes. Without this table it keeps its volume."));
}

void declare_mass(TableSchema<Region>& table) {
  limit(table.key("density", &Region::density)
            .unit("kg/m3")
            .range(above(0.))
            .doc("density; needed in a solid, in a rigid region density or mass"));
  limit(table.key("mass", &Region::mass).unit("kg/m").range(above(0.)).doc("mass of the region per metre; or density"));
  limit(table.key("centre_of_gravity", &Region::centre_of_gravity)
            .unit("m")
            .fallback("that of the area")
            .doc("centre of gravity (x, y)"));
  limit(table.key("moment_of_inertia", &Region::moment_of_inertia)
            .unit("kg m2/m")
            .range(above(0.))
            .fallback("that of the area, evenly filled")
            .doc("moment of inertia about the centre of gravity"));
  limit(table.table("interface", &Region::interface, contact_schema())
            .doc("How the bottom of the region caisson stands on its ground; bonded without this table."));
}

void declare_pores(TableSchema<Region>& table) {
  limit(
      table.key("porosity", &Region::porosity).range(between(0., 1.)).doc("share of the pores in the volume; needed"));
  limit(table.key("grain_density", &Region::grain_density)
            .unit("kg/m3")
            .range(above(0.))
            .doc("density of the grains; needed"));
  limit(table.key("hydraulic_conductivity", &Region::hydraulic_conductivity)
            .unit("m/s")
            .range(above(0.))
            .doc("hydraulic conductivity k; or permeability; needed unless flow is drained"));
  limit(table.key("permeability", &Region::permeability)
            .unit("m2")
            .range(above(0.))
            .doc("intrinsic permeability kappa; instead of k = kappa rho_f g / mu, mu = fluid.viscosity"));
  limit(table.key("saturation", &Region::saturation)
            .range(from_to(0.8, 1.))
            .doc("share of water in the volume of the pores; the rest is bubbles of air, which make the water softer: "
                 "1/K = S/K_f + (1 - S)/p, p absolute at rest in the middle of the region's height"));
  limit(table.choice("flow", &Region::flow, flow_words)
            .doc("how the pore water moves; drained: no pore pressure; auto: darcy or inertial by k omega/(g n)"));
  limit(table.key("tortuosity", &Region::tortuosity).range(at_least(1.)).doc("tortuosity of the pores"));
  limit(table.key("biot", &Region::biot)
            .range(from_to(0., 1.))
            .doc("Biot coefficient alpha; not below the porosity of real soils"));
  limit(table.key("grain_bulk_modulus", &Region::grain_bulk_modulus)
            .unit("Pa")
            .range(above(0.).or_infinite())
            .doc("bulk modulus of the grains"));
}

void declare_choices(TableSchema<Region>& table) {
  limit(table.choice("deformation", &Region::deformation, deformation_words)
            .doc("whether the solid deforms; auto: rigid where it is so stiff that the shear force does not feel it"));
  limit(table.choice("compressibility", &Region::compressibility, compressibility_words)
            .doc("whether the water stores volume under pressure; auto: by the time that sound takes over its depth"));
}

}  // namespace

TableSchema<Region> region_schema() {
  TableSchema<Region> table;
  table.choice("kind", &Region::kind, region_kind_words).required().doc("what fills the region");
  declare_skeleton(table);
  declare_mass(table);
  declare_pores(table);
  declare_choices(table);
  return table;
}

}  // namespace upbead
