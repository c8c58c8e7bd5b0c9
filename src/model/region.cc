#include "upbead/model/region.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/numbers.h"
#include "base/text.h"
#include "material/asked_law.h"
#include "model/member_rules.h"
#include "model/soil_law_row.h"
#include "model/words.h"

namespace upbead {

namespace {

using K = RegionKind;
using Rules = std::vector<MemberRule<Region, RegionKind>>;

template <class Member>
std::function<bool(const Region&)> changed(Member member) {
  return [member](const Region& region) { return region.*member != Region{}.*member; };
}

const Rules& member_rules() {
  using R = Region;
  static const Rules rules{
      {"shear_modulus", {K::solid, K::porous}, false, is_set(&R::shear_modulus)},
      {"shear_modulus.reference", {K::porous}, false, is_set(&R::stress_law)},
      {"law", {K::solid, K::porous}, false, changed(&R::law)},
      {"strain", {K::solid, K::porous}, false, is_set(&R::strain_law)},
      {"youngs_modulus", {K::solid, K::porous}, false, is_set(&R::youngs_modulus)},
      {"poissons_ratio", {K::solid, K::porous}, true, is_set(&R::poissons_ratio)},
      {"density", {K::rigid, K::solid}, false, is_set(&R::density)},
      {"mass", {K::rigid}, false, is_set(&R::mass)},
      {"centre_of_gravity", {K::rigid}, false, is_set(&R::centre_of_gravity)},
      {"moment_of_inertia", {K::rigid}, false, is_set(&R::moment_of_inertia)},
      {"parts", {K::rigid}, false, [](const R& region) { return !region.parts.empty(); }},
      {"porosity", {K::porous}, true, is_set(&R::porosity)},
      {"grain_density", {K::porous}, true, is_set(&R::grain_density)},
      {"hydraulic_conductivity", {K::porous}, false, is_set(&R::hydraulic_conductivity)},
      {"permeability", {K::porous}, false, is_set(&R::permeability)},
      {"forchheimer", {K::porous}, false, is_set(&R::forchheimer)},
      {"conductivity_ratio", {K::porous}, false, changed(&R::conductivity_ratio)},
      {"saturation", {K::porous}, false, changed(&R::saturation)},
      {"air_by_depth", {K::porous}, false, changed(&R::air_by_depth)},
      {"flow", {K::porous}, false, changed(&R::flow)},
      {"tortuosity", {K::porous}, false, changed(&R::tortuosity)},
      {"biot", {K::porous}, false, changed(&R::biot)},
      {"grain_bulk_modulus", {K::porous}, false, changed(&R::grain_bulk_modulus)},
      {"damping", {K::solid, K::porous}, false, is_set(&R::damping)},
      {"strength", {K::solid, K::porous}, false, is_set(&R::strength)},
      {"densification", {K::porous}, false, is_set(&R::densification)},
      {"cyclic", {K::porous}, false, is_set(&R::cyclic)},
      {"interface", {K::rigid, K::solid}, false, is_set(&R::interface)},
      {"springs", {K::rigid}, false, is_set(&R::springs)},
      {"dashpots", {K::rigid}, false, is_set(&R::dashpots)},
      {"added_mass", {K::rigid}, false, is_set(&R::added_mass)},
      {"deformation", {K::solid}, false, changed(&R::deformation)},
      {"compressibility", {K::water}, false, changed(&R::compressibility)},
  };
  return rules;
}

class Checker {
 public:
  explicit Checker(const Region& region)
      : region_(region),
        whose_("a " + word_of(region.kind, region_kind_words) + " region"),
        list_(diagnose_members(member_rules(), region, region.kind, whose_)) {}

  Diagnostics run() {
    if (region_.kind == K::rigid) exactly_one("density", region_.density.has_value(), "mass", region_.mass.has_value());
    if (region_.kind == K::solid || region_.kind == K::porous)
      exactly_one("shear_modulus", region_.shear_modulus || region_.stress_law, "youngs_modulus",
                  region_.youngs_modulus.has_value());
    if (!region_.parts.empty()) check_parts();
    if (region_.kind == K::solid && !region_.density) add_missing("density", whose_, list_);
    if (region_.kind == K::porous) check_porous();
    if (region_.dashpots && !region_.springs)
      add("dashpots", "dashpots are given without springs, which hold the caisson",
          "add springs = { horizontal = 5e8, vertical = 6e8, rotation = 2e10 }");
    if (region_.strain_law) check_strain(*region_.strain_law);
    check_law();
    if (region_.densification) check_densification(*region_.densification);
    if (region_.cyclic) check_cyclic(*region_.cyclic);
    if (region_.damping && region_.damping->frequencies[0] >= region_.damping->frequencies[1])
      add("damping", "the two frequencies of damping do not ascend", "give the lower one first, such as [1.0, 10.0]");
    return std::move(list_);
  }

 private:
  void add(const std::string& key, const std::string& what, const std::string& cure) {
    list_.add(at_key(key), what, cure);
  }

  void exactly_one(const std::string& a, bool has_a, const std::string& b, bool has_b) {
    if (has_a && has_b) add(b, "both '" + a + "' and '" + b + "' are given", "keep one of them");
    if (!has_a && !has_b)
      add(a, "neither '" + a + "' nor '" + b + "' is given, one of which " + whose_ + " needs",
          "add " + a + " or " + b);
  }

  /// Rectangles beside each other, of a body whose mass follows from densities.
  void check_parts() {
    const bool given = region_.mass || region_.centre_of_gravity || region_.moment_of_inertia;
    if (given)
      add("parts", "mass, centre_of_gravity and moment_of_inertia are those of the whole, with all parts",
          "remove these, so that the densities tell them, or remove parts");
    for (auto one = region_.parts.begin(); one != region_.parts.end(); ++one) {
      const BodyPart& part = one->second;
      if (!(part.x[0] < part.x[1] && part.y[0] < part.y[1]))
        add("parts." + one->first, "its sides do not ascend", "give the lower side first: x = [-9, -5], y = [18, 22]");
      for (auto other = std::next(one); other != region_.parts.end(); ++other)
        if (overlap(part.x, other->second.x) && overlap(part.y, other->second.y))
          add("parts." + other->first, "it overlaps with '" + one->first + "'", "give parts beside each other");
    }
  }

  static bool overlap(const std::array<double, 2>& a, const std::array<double, 2>& b) {
    constexpr double round_off = 1e-9;
    return std::min(a[1], b[1]) - std::max(a[0], b[0]) > round_off * std::max(a[1] - a[0], b[1] - b[0]);
  }

  void check_strain(const StrainLaw& law) {
    if (!region_.damping && region_.law == SoilLaw::elastic)
      add("damping", "'damping' is missing, whose frequencies strain-dependent damping needs",
          "add damping = { ratio = 0.05, frequencies = [1.0, 10.0] }");
    if (law.largest_damping < law.smallest_damping)
      add("strain", "largest_damping is less than smallest_damping", "give the damping at large strain as the larger");
    for (const auto* table : {&law.modulus, &law.damping})
      for (std::size_t i = 0; i < table->size(); ++i)
        if ((*table)[i][0] <= 0. || (*table)[i][1] < 0. || (i > 0 && (*table)[i][0] <= (*table)[i - 1][0])) {
          add("strain", "a table of strain does not ascend from above 0, or has a negative value",
              "give pairs (strain, value) in ascending strain");
          break;
        }
    for (const auto& pair : law.modulus)
      if (pair[1] == 0. || pair[1] > 1.) {
        add("strain", "G/G_max of a table lies outside (0, 1]", "give ratios of the secant to the largest stiffness");
        break;
      }
    for (const auto& pair : law.damping)
      if (pair[1] >= 1.) add("strain", "a damping ratio of a table is not below 1", "give ratios, not percent");
  }

  void check_law() {
    if (const SoilLawRow* row = row_of(region_.law)) check_needs(*row);
    if (!region_.strength) return;
    if (region_.strength->dilatancy_angle > region_.strength->friction_angle)
      add("strength", "dilatancy_angle is more than friction_angle", "give an angle from 0 to friction_angle");
    const double apex = region_.strength->cohesion / std::tan(region_.strength->friction_angle * pi / 180.);
    if (region_.strength->tension > apex)
      add("strength",
          "tension is more than the tip of the strength, cohesion / tan(friction_angle) = " + significant(apex) + " Pa",
          "lower tension, or raise cohesion");
  }

  void check_needs(const SoilLawRow& row) {
    const std::string soil = row.soil;
    if (row.needs == SoilNeeds::curve_or_strength && !region_.strain_law && !region_.strength)
      add("law", "neither 'strain' nor 'strength' is given, one of which " + soil + " needs",
          "add strain = { reference_strain = 5e-4 }, or strength = { friction_angle = 35 }");
    if (row.needs == SoilNeeds::strength && !region_.strength)
      add("law", "'strength' is missing, which " + soil + " needs",
          "add strength = { friction_angle = 35, cohesion = 0 }");
    if (row.needs == SoilNeeds::strength && region_.strain_law)
      add("strain", soil + " is elastic up to its strength and follows no strain",
          "remove strain, or write law = \"hysteretic\"");
    if (row.needs != SoilNeeds::function) return;
    if (!laws_are_answered())
      add("law", "\"" + std::string(row.word) + "\" asks a function of Python for stresses, and none is there",
          "run the scene by upbead.run in Python, with the function as its law, or choose another law");
    if (region_.strain_law) add("strain", soil + " follows that alone", "remove strain");
    if (region_.strength) add("strength", soil + " follows that alone", "remove strength");
  }

  void check_densification(const Densification& d) {
    if (d.relative_density && d.c1)
      add("densification", "both 'relative_density' and 'c1' are given", "keep one of them");
    if (!d.relative_density && !d.c1)
      add("densification", "neither 'relative_density' nor 'c1' is given, one of which densification needs",
          "add relative_density = 0.5, or the measured c1");
    if (d.c2 && !d.c1)
      add("densification", "c2 is given without c1", "give both, or relative_density alone, which gives both");
    if (const SoilLawRow* row = row_of(region_.law); !row || !row->compacting)
      add("densification", "soil that packs denser needs a law that follows its history",
          "add law = \"hysteretic\" or law = \"mohr_coulomb\"");
  }

  void check_cyclic(const CyclicSoil& soil) {
    if (!soil.relative_density && !(soil.alpha && soil.beta))
      add("cyclic", "neither 'relative_density' nor both of 'alpha' and 'beta' are given, which cyclic needs",
          "add relative_density = 0.5, or alpha and beta of cyclic tests");
    if (region_.law != SoilLaw::elastic)
      add("cyclic", "the shear of soil that yields is not proportional to the wave, as cycles of a storm need",
          "write law = \"elastic\", or use densification, which follows every cycle, instead of cyclic");
  }

  void check_porous() {
    if (!region_.hydraulic_conductivity && !region_.permeability && region_.flow != Flow::drained)
      add_missing("hydraulic_conductivity", whose_, list_);
    if (region_.hydraulic_conductivity && region_.permeability)
      add("permeability", "both 'hydraulic_conductivity' and 'permeability' are given", "keep one of them");
    if (region_.forchheimer && region_.flow == Flow::drained)
      add("forchheimer", "flow = \"drained\" leaves out the pore water whose drag forchheimer tells",
          "remove one of them");
    if (region_.forchheimer && region_.conductivity_ratio != 1.)
      add("forchheimer", "drag that grows with velocity is that of stones, which are alike in all directions",
          "remove forchheimer or conductivity_ratio");
    if (region_.air_by_depth && region_.saturation == 1.)
      add("air_by_depth", "air_by_depth without air: saturation is 1", "give a saturation below 1, or remove it");
    // with rigid grains the Biot coefficient is a measured number like any other, and the run warns of it; with
    // compressible grains, the pores' storage could be negative
    if (region_.porosity && *region_.porosity <= 1. && region_.biot < *region_.porosity &&
        std::isfinite(region_.grain_bulk_modulus))
      add("biot", "biot is less than the porosity, and the grains are compressible",
          "give a Biot coefficient within [porosity, 1], or leave out grain_bulk_modulus");
  }

  const Region& region_;
  std::string whose_;
  Diagnostics list_;
};

/// zeta at the ends of the range over zeta at sqrt(f1 f2), where it is least.
double sag(const Rayleigh& r) {
  return 0.5 * (r.frequencies[0] + r.frequencies[1]) / std::sqrt(r.frequencies[0] * r.frequencies[1]);
}

/// zeta at the ends: ratio (1 + e), e = (s - 1)/(s + 1), if the relative deviations at the ends and in the middle are
/// equal.
double ratio_at_ends(const Rayleigh& r) {
  return r.fit == RayleighFit::ends ? r.ratio : r.ratio * 2. * sag(r) / (sag(r) + 1.);
}

}  // namespace

double Region::mass_over(double area) const {
  if (mass) return *mass;
  double sum = density.value_or(0.) * area;
  for (const auto& [name, part] : parts) sum += (part.density - density.value_or(0.)) * part.area();
  return sum;
}

double Rayleigh::mass_factor() const {
  const double w1 = 2. * pi * frequencies[0], w2 = 2. * pi * frequencies[1];
  return 2. * ratio_at_ends(*this) * w1 * w2 / (w1 + w2);
}

double Rayleigh::stiffness_factor() const {
  return ratio_at_ends(*this) / (pi * (frequencies[0] + frequencies[1]));
}

double Rayleigh::ratio_at(double frequency) const {
  const double w = 2. * pi * frequency;
  return 0.5 * (mass_factor() / w + stiffness_factor() * w);
}

double Rayleigh::error() const {
  const double s = sag(*this);
  return fit == RayleighFit::ends ? 1. - 1. / s : (s - 1.) / (s + 1.);
}

double Densification::C1() const {
  return c1 ? *c1 : 7600. * std::pow(100. * *relative_density, -2.5);
}

double Densification::C2() const {
  return c2.value_or(0.4 / C1());
}

// Sumer, Kirca and Fredsoe (2012), fitted to the tests of De Alba, Seed and Chan (1976) with D_r of 0.54 to 0.90;
// recalled, not looked up: told as assumed
double CyclicSoil::alpha_r() const {
  return alpha ? *alpha : 0.34 * *relative_density + 0.084;
}

double CyclicSoil::beta_r() const {
  return beta ? *beta : 0.37 * *relative_density - 0.46;
}

bool belongs(const std::string& key, RegionKind kind) {
  for (const auto& rule : member_rules())
    if (rule.key == key) return rule.belongs_to(kind);
  return key == "kind";
}

Diagnostics diagnose(const Region& region) {
  return Checker(region).run();
}

std::optional<double> conductivity(const Region& region, const Fluid& fluid, double gravity) {
  if (!region.permeability) return region.hydraulic_conductivity;
  return *region.permeability * fluid.density * gravity / fluid.viscosity;
}

double pore_fluid_modulus(const Fluid& fluid, double saturation, double absolute_pressure) {
  return 1. / (saturation / fluid.bulk_modulus + (1. - saturation) / absolute_pressure);
}

Material material(const Region& region, const Fluid& fluid, double gravity) {
  Material m;
  if (region.kind != K::porous) m.rho = region.density.value_or(0.);
  if (region.kind == K::rigid) return m;
  if (region.kind == K::water) {
    m.rho = m.rho_f = fluid.density;
    if (region.compressibility != Compressibility::incompressible) m.storage = 1. / fluid.bulk_modulus;
    return m;
  }
  const double nu = *region.poissons_ratio;
  static_cast<ElasticLaw&>(m) =
      elastic_law(region.shear_modulus ? *region.shear_modulus : *region.youngs_modulus / (2. * (1. + nu)), nu);
  if (region.damping) {
    m.mass_damping = region.damping->mass_factor();
    m.stiffness_damping = region.damping->stiffness_factor();
  }
  if (region.kind == K::solid) return m;
  const double n = *region.porosity;
  m.rho = (1. - n) * *region.grain_density + n * fluid.density;
  m.rho_f = fluid.density;
  m.a = region.tortuosity * fluid.density / n;
  if (const auto k = conductivity(region, fluid, gravity)) m.b = fluid.density * gravity / *k;
  m.mobility = 1. / m.b;
  m.vertical_flow = region.conductivity_ratio;
  m.alpha = region.biot;
  m.storage = n / region.pore_fluid_modulus.value_or(fluid.bulk_modulus) + (m.alpha - n) / region.grain_bulk_modulus;
  return m;
}

double shear_modulus(const StressLaw& law, double stress, double floor) {
  return law.reference * std::pow(std::max(stress, floor) / law.pressure, law.exponent);
}

namespace {

/// Linear over the logarithm of the strain, constant beyond the ends.
double interpolate(const std::vector<std::array<double, 2>>& table, double strain) {
  if (strain <= table.front()[0]) return table.front()[1];
  for (std::size_t i = 1; i < table.size(); ++i)
    if (strain < table[i][0]) {
      const double part = std::log(strain / table[i - 1][0]) / std::log(table[i][0] / table[i - 1][0]);
      return (1. - part) * table[i - 1][1] + part * table[i][1];
    }
  return table.back()[1];
}

}  // namespace

double modulus_ratio(const StrainLaw& law, double strain) {
  if (!law.modulus.empty()) return interpolate(law.modulus, strain);
  return 1. / (1. + strain / law.reference_strain);
}

double damping_ratio(const StrainLaw& law, double strain) {
  if (!law.damping.empty()) return interpolate(law.damping, strain);
  return law.smallest_damping + (law.largest_damping - law.smallest_damping) * (1. - modulus_ratio(law, strain));
}

}  // namespace upbead
