#include "case_schema.h"
#include "material/soil_law.h"
#include "model/words.h"

namespace upbead {

namespace {

TableSchema<Rayleigh> damping_schema() {
  TableSchema<Rayleigh> table;
  table.key("ratio", &Rayleigh::ratio, "", "damping ratio at both frequencies", from_to_below(0., 1.)).required();
  table.key("frequencies", &Rayleigh::frequencies, "Hz",
            "two frequencies, ascending, at or between which the ratio holds", above(0.));
  table.choice("fit", &Rayleigh::fit, rayleigh_fit_words,
               "where the ratio holds; ends: at both frequencies, less between them; band: between them, as much above "
               "it at the ends as below it in the middle");
  return table;
}

TableSchema<StressLaw> stress_law_schema() {
  TableSchema<StressLaw> table;
  table.key("reference", &StressLaw::reference, "Pa", "shear modulus G at the stress `pressure`", above(0.)).required();
  table.key("pressure", &StressLaw::pressure, "Pa", "mean effective stress to which `reference` belongs", above(0.));
  table.key("exponent", &StressLaw::exponent, "", "exponent of the stress", from_to(0., 1.));
  table
      .key("floor", &StressLaw::floor, "Pa",
           "least mean effective stress that counts; near free surfaces G would vanish", above(0.))
      .fallback("a tenth of the region's mean");
  return table;
}

TableSchema<StrainLaw> strain_law_schema() {
  TableSchema<StrainLaw> table;
  table.key("reference_strain", &StrainLaw::reference_strain, "",
            "shear strain at which G is half of that at vanishing strain (Hardin and Drnevich)", above(0.));
  table.key("smallest_damping", &StrainLaw::smallest_damping, "", "damping ratio at vanishing strain",
            from_to_below(0., 1.));
  table.key("largest_damping", &StrainLaw::largest_damping, "", "damping ratio at large strain", from_to_below(0., 1.));
  table.key("effective", &StrainLaw::effective, "", "effective over largest shear strain of a cell", above(0.));
  table
      .key("modulus", &StrainLaw::modulus, "",
           "pairs of shear strain and G/G_max, straight over the logarithm of the strain")
      .fallback("by reference_strain");
  table.key("damping", &StrainLaw::damping, "", "pairs of shear strain and damping ratio, likewise")
      .fallback("by smallest_damping and largest_damping");
  return table;
}

TableSchema<Strength> strength_schema() {
  TableSchema<Strength> table;
  table
      .key("friction_angle", &Strength::friction_angle, "degrees", "effective angle of friction phi'",
           from_to_below(0., 90.))
      .required();
  table.key("cohesion", &Strength::cohesion, "Pa", "effective cohesion c'", at_least(0.));
  table.key("dilatancy_angle", &Strength::dilatancy_angle, "degrees",
            "angle of dilatancy psi' of Mohr-Coulomb soil, up to friction_angle", from_to_below(0., 90.));
  table.key("tension", &Strength::tension, "Pa",
            "largest tensile stress of Mohr-Coulomb soil, up to cohesion / tan(friction_angle)", at_least(0.));
  return table;
}

TableSchema<CyclicSoil> cyclic_schema() {
  TableSchema<CyclicSoil> table;
  table.key(
      "relative_density", &CyclicSoil::relative_density, "",
      "relative density D_r; gives alpha = 0.34 D_r + 0.084 and beta = 0.37 D_r - 0.46, which are assumed, and the "
      "densification of Byrne (1991); or alpha and beta",
      from_to(0.2, 1.));
  table
      .key("alpha", &CyclicSoil::alpha, "",
           "shear stress over mean effective stress at rest that liquefies the soil in one cycle: tau/sigma'_0 = alpha "
           "N^beta",
           above(0.))
      .fallback("by relative_density");
  table.key("beta", &CyclicSoil::beta, "", "exponent of the number of cycles, below 0", between(-5., 0.))
      .fallback("by relative_density");
  return table;
}

TableSchema<Densification> densification_schema() {
  TableSchema<Densification> table;
  table.key("relative_density", &Densification::relative_density, "",
            "relative density D_r; gives c1 = 7600 (100 D_r)^-2.5 (Byrne 1991); or c1", from_to(0.2, 1.));
  table.key("c1", &Densification::c1, "",
            "volumetric strain over shear strain of the first cycle, instead of relative_density", above(0.));
  table.key("c2", &Densification::c2, "", "how fast later cycles add less, with c1", at_least(0.)).fallback("0.4 / c1");
  table.key("threshold", &Densification::threshold, "",
            "amplitude of the shear strain up to which nothing is added; sand has about 1e-4", at_least(0.));
  return table;
}

TableSchema<ContactLaw> contact_schema() {
  const auto slips = [](const ContactLaw& law) { return law.kind == ContactKind::friction; };
  TableSchema<ContactLaw> table;
  table
      .choice("kind", &ContactLaw::kind, contact_kind_words,
              "bonded: it neither slips nor lifts; friction: Coulomb friction and no tension, node by node")
      .formerly_word("tied", "bonded");
  table.key("coefficient", &ContactLaw::coefficient, "", "friction coefficient mu", above(0.))
      .fallback("friction of [sliding], or 0.6")
      .when("kind", slips, "where the contact is by friction");
  table
      .choice("gap", &ContactLaw::gap, gap_source_words,
              "where an edge has lifted; pores: its gap takes water from the pores beneath alone; sea: the gap has the "
              "pressure of the loads at the foot of the wall above it, from where it falls in a straight line")
      .when("kind", slips, "where the contact is by friction");
  return table;
}

TableSchema<BaseSupport> springs_schema() {
  TableSchema<BaseSupport> table;
  table
      .key("horizontal", &BaseSupport::horizontal, "Pa", "force per displacement and per metre of breakwater, landward",
           above(0.))
      .required();
  table.key("vertical", &BaseSupport::vertical, "Pa", "force per displacement and per metre, upward", above(0.))
      .required();
  table.key("rotation", &BaseSupport::rotation, "N", "moment per angle (rad) and per metre of breakwater", above(0.))
      .required();
  return table;
}

TableSchema<BaseSupport> dashpots_schema() {
  TableSchema<BaseSupport> table;
  table.key("horizontal", &BaseSupport::horizontal, "Pa s", "force per velocity and per metre of breakwater, landward",
            at_least(0.));
  table.key("vertical", &BaseSupport::vertical, "Pa s", "force per velocity and per metre, upward", at_least(0.));
  table.key("rotation", &BaseSupport::rotation, "N s", "moment per angular velocity and per metre of breakwater",
            at_least(0.));
  return table;
}

TableSchema<WallWater> added_mass_schema() {
  TableSchema<WallWater> table;
  table.key("seaward", &WallWater::seaward, "m", "height of the sea above the caisson's base", at_least(0.));
  table.key("landward", &WallWater::landward, "m", "height of the harbour's water above the caisson's base",
            at_least(0.));
  return table;
}

TableSchema<BodyPart> part_schema() {
  TableSchema<BodyPart> table;
  table.key("x", &BodyPart::x, "m", "x of its seaward and its landward side").required();
  table.key("y", &BodyPart::y, "m", "y of its lower and its upper side").required();
  table.key("density", &BodyPart::density, "kg/m3", "its density", above(0.)).required();
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
  limit(table.choice("law", &Region::law, soil_law_words, how_laws_follow_strain()));
  limit(table.table("strain", &Region::strain_law, strain_law_schema())
            .doc("Of elastic soil: equivalent-linear, G and damping by the strain of the response, iterated cell by "
                 "cell; linear without this table. Of hysteretic soil: its curve of G, from which damping follows."));
  limit(table.key("youngs_modulus", &Region::youngs_modulus, "Pa", "Young modulus E of the skeleton; or shear_modulus",
                  above(0.)));
  limit(table.key("poissons_ratio", &Region::poissons_ratio, "", "Poisson ratio of the drained skeleton; needed",
                  from_to_below(0., 0.5)));
  limit(table.table("damping", &Region::damping, damping_schema())
            .doc("Rayleigh damping; without this table there is none."));
  limit(table.table("strength", &Region::strength, strength_schema())
            .doc("Mohr-Coulomb strength. Stresses of elastic soil, static plus dynamic, are compared with it and do "
                 "not change; other laws yield at it."));
  limit(table.table("densification", &Region::densification, densification_schema())
            .doc("Sand that packs denser under cycles of shear, with law hysteretic or mohr_coulomb: pore pressure "
                 "where its water stays, settlement where it goes. Without this table it keeps its volume."));
  limit(table.table("cyclic", &Region::cyclic, cyclic_schema())
            .doc("Sand in which the cycles of a storm, [cycles], build pore pressure, with law elastic. Without this "
                 "table it builds none: clay, rubble."));
}

void declare_mass(TableSchema<Region>& table) {
  limit(table.key("density", &Region::density, "kg/m3", "density; needed in a solid, in a rigid region density or mass",
                  above(0.)));
  limit(table.key("mass", &Region::mass, "kg/m", "mass of the region per metre; or density", above(0.)));
  limit(table.key("centre_of_gravity", &Region::centre_of_gravity, "m", "centre of gravity (x, y)")
            .fallback("that of the area"));
  limit(table
            .key("moment_of_inertia", &Region::moment_of_inertia, "kg m2/m",
                 "moment of inertia about the centre of gravity", above(0.))
            .fallback("that of the area, evenly filled"));
  limit(
      table.tables("parts", &Region::parts, part_schema())
          .doc("Rectangles of the meshed body with a density of their own, such as a parapet or a fill; density holds "
               "for all the rest, and mass, centre of gravity and moment of inertia follow."));
  limit(table.table("interface", &Region::interface, contact_schema())
            .doc("How the bottom of the region caisson stands on its ground; bonded without this table."));
  limit(
      table.table("springs", &Region::springs, springs_schema())
          .doc(
              "Springs at the middle of the base of the region caisson, in place of ground, of which the mesh then has "
              "none (geometry = \"caisson\"): for published lumped models."));
  limit(table.table("dashpots", &Region::dashpots, dashpots_schema())
            .doc("Dashpots beside these springs; without this table there are none."));
  limit(
      table.table("added_mass", &Region::added_mass, added_mass_schema())
          .doc("Of the region caisson: water beside its walls that the mesh has not, as a mass that swings with them, "
               "7/8 fluid.density sqrt(height depth) per area (Westergaard 1933); without this table there is none."));
}

void declare_pores(TableSchema<Region>& table) {
  limit(table.key("porosity", &Region::porosity, "", "share of the pores in the volume; needed", between(0., 1.)));
  limit(table.key("grain_density", &Region::grain_density, "kg/m3", "density of the grains; needed", above(0.)));
  limit(table.key("hydraulic_conductivity", &Region::hydraulic_conductivity, "m/s",
                  "hydraulic conductivity k; or permeability; needed unless flow is drained", above(0.)));
  limit(table.key("permeability", &Region::permeability, "m2",
                  "intrinsic permeability kappa; instead of k = kappa rho_f g / mu, mu = fluid.viscosity", above(0.)));
  limit(
      table.key("forchheimer", &Region::forchheimer, "s2/m2",
                "b of drag that grows with the velocity w, i = w/k + b |w| w (Forchheimer 1901), as in stones, beta "
                "(1 - n)/(n^3 g d_50), beta about 1.1 (Van Gent 1995); made linear cell by cell at the velocity of the "
                "response, by iteration",
                above(0.)));
  limit(table.key("conductivity_ratio", &Region::conductivity_ratio, "",
                  "vertical over horizontal conductivity, k_y/k_x; hydraulic_conductivity and permeability are the "
                  "horizontal ones. Layered sand has 0.1 to 0.5",
                  above(0.)));
  limit(table.key("saturation", &Region::saturation, "",
                  "share of water in the volume of the pores; the rest is bubbles of air, which make the water softer: "
                  "1/K = S/K_f + (1 - S)/p, p absolute at rest in the middle of the region's height",
                  from_to(0.8, 1.)));
  limit(table.key("air_by_depth", &Region::air_by_depth, "",
                  "whether that p is the pressure at rest at each cell's own depth; matters in a high region"));
  limit(table.choice("flow", &Region::flow, flow_words,
                     "how the pore water moves; drained: no pore pressure; auto: darcy or inertial by k omega/(g n)"));
  limit(table.key("tortuosity", &Region::tortuosity, "", "tortuosity of the pores", at_least(1.)));
  limit(table.key("biot", &Region::biot, "", "Biot coefficient alpha; not below the porosity of real soils",
                  from_to(0., 1.)));
  limit(table.key("grain_bulk_modulus", &Region::grain_bulk_modulus, "Pa", "bulk modulus of the grains",
                  above(0.).or_infinite()));
}

void declare_choices(TableSchema<Region>& table) {
  limit(table.choice(
      "deformation", &Region::deformation, deformation_words,
      "whether the solid deforms; auto: rigid where it is so stiff that the shear force does not feel it"));
  limit(table.choice(
      "compressibility", &Region::compressibility, compressibility_words,
      "whether the water stores volume under pressure; auto: by the time that sound takes over its depth"));
}

}  // namespace

TableSchema<Region> region_schema() {
  TableSchema<Region> table;
  table.choice("kind", &Region::kind, region_kind_words, "what fills the region").required();
  declare_skeleton(table);
  declare_mass(table);
  declare_pores(table);
  declare_choices(table);
  return table;
}

}  // namespace upbead
