// What fills a region: a rigid body, a dry solid, a porous soil, free water. Plain SI data with the constants of Biot's
// equations.
#pragma once

#include <array>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "upbead/base/error.h"
#include "upbead/material/elastic_law.h"

namespace upbead {

/// G = reference (sigma'_m / pressure)^exponent with the mean effective stress sigma'_m = (s'_x + s'_y + s'_z)/3 of the
/// static state; Richart, Hall and Woods (1970) have exponent 0.5 for sands.
struct StressLaw {
  double reference = 0.;   ///< G at `pressure` (Pa)
  double pressure = 98e3;  ///< Pa
  double exponent = 0.5;
  /// Least sigma'_m that counts (Pa), as G vanishes at free surfaces; none: a tenth of the region's mean, so that
  /// similar scenes stay similar.
  std::optional<double> floor;
};

/// G (Pa) at a mean effective stress (Pa), not below the floor.
double shear_modulus(const StressLaw& law, double stress, double floor);

/// Secant stiffness and damping as functions of the amplitude gamma of the shear strain. Without tables, by Hardin and
/// Drnevich (1972): G/G_max = 1/(1 + gamma/gamma_r), damping = smallest + (largest - smallest) (1 - G/G_max).
struct StrainLaw {
  double reference_strain = 1e-3;  ///< gamma_r, where G is half of G_max
  double smallest_damping = 0.02;  ///< ratio at vanishing strain
  double largest_damping = 0.20;   ///< ratio at large strain
  double effective = 0.65;         ///< effective over largest shear strain; Schnabel, Lysmer and Seed (1972)
  std::vector<std::array<double, 2>> modulus;  ///< (gamma, G/G_max), linear in log gamma; instead of the formula
  std::vector<std::array<double, 2>> damping;  ///< (gamma, ratio), likewise
};

double modulus_ratio(const StrainLaw& law, double strain);  ///< G/G_max
double damping_ratio(const StrainLaw& law, double strain);

/// How the stress of a soil follows its strain, see docs/yielding.md.
enum class SoilLaw {
  elastic,       ///< linear, or equivalent-linear where a strain law is given
  hysteretic,    ///< overlay of elastic-plastic elements, fitted to the curve of G over strain
  mohr_coulomb,  ///< elastic and perfectly plastic
  python,        ///< asked of a function of Python while the program runs
};

/// The part of the stress at rest that the overlay of hysteretic soil bears at the start.
enum class RestStart {
  k0,       ///< the stress of level ground, with horizontal stress K_0 times vertical
  virgin,   ///< none, as if the soil had never been loaded
  gravity,  ///< all, as if all weights had been put on at once
};

/// Weight on the ground before the waves arrive. It has no mass.
struct Surcharge {
  std::string boundary;            ///< the curve that it lies on
  double weight = 0.;              ///< submerged, per horizontal area (Pa)
  std::optional<double> from, to;  ///< x of its ends (m); none: those of the curve
};

/// The state before the waves.
struct InitialState {
  std::optional<double> water_level;  ///< height y of still water (m); none: the top of the regions of water
  std::optional<double> k0;           ///< s'_x = s'_z = K_0 s'_y; none: all stresses from the elastic solution
  std::map<std::string, Surcharge> surcharge{};
  RestStart start = RestStart::k0;  ///< of hysteretic soil
  bool bounds = true;               ///< whether soil that yields is solved also from the two other starts
  bool safety = false;              ///< whether to find the factor by which strength may fall at rest
  /// Height y of still water behind the caisson (m), where water_level is that of the sea; none: one level.
  std::optional<double> harbour_level{};
};

enum class ContactKind {
  bonded,    ///< it neither slips nor lifts
  friction,  ///< Coulomb friction and no tension, node by node
};

/// Where the water comes from that fills the gap under an edge that has lifted.
enum class GapSource {
  pores,  ///< from the pores beneath alone
  sea,    ///< from the sea: the gap has the pressure of the loads at the foot of the wall above it
};

struct ContactLaw {
  ContactKind kind = ContactKind::bonded;
  std::optional<double> coefficient;  ///< mu; none: that of [sliding], or 0.6
  GapSource gap = GapSource::pores;
};

/// Forces on the middle of the caisson's base from what stands for its ground, per unit of its motions and per metre of
/// breakwater: springs (Pa, Pa, N) or dashpots (Pa s, Pa s, N s).
struct BaseSupport {
  double horizontal = 0., vertical = 0., rotation = 0.;
};

/// Heights above the caisson's base (m) of water beside its walls that is not meshed, and swings with them as a mass.
struct WallWater {
  double seaward = 0., landward = 0.;
};

/// A rectangle of a rigid body with a density of its own, such as a parapet, a crown wall or another fill.
struct BodyPart {
  std::array<double, 2> x{}, y{};  ///< its sides, ascending (m)
  double density = 0.;             ///< kg/m3
  double area() const { return (x[1] - x[0]) * (y[1] - y[0]); }
};

/// Pore water and sea water.
struct Fluid {
  double density = 1030.;                 ///< rho_f (kg/m3)
  double bulk_modulus = 2.2e9;            ///< K_f (Pa), may be infinite
  double viscosity = 1.07e-3;             ///< mu (Pa s); sea water of 20 degrees
  double atmospheric_pressure = 101325.;  ///< on still water; compresses the air in pores (Pa)
};

enum class RegionKind { rigid, solid, porous, water };

/// How the pore water moves: see docs/theory.md. `automatic` is resolved by choose_flow.
enum class Flow { automatic, darcy, inertial, drained };

/// Whether a solid deforms or moves as a rigid body. `automatic` is resolved by choose_deformation.
enum class Deformation { automatic, elastic, rigid };

/// Whether free water stores volume under pressure. `automatic` is resolved by choose_compressibility.
enum class Compressibility { automatic, compressible, incompressible };

/// Where Rayleigh damping has the ratio that is asked for.
enum class RayleighFit {
  ends,  ///< at both frequencies; less between them
  band,  ///< as near as possible on the band between them: as far above at the ends as below in the middle
};

/// Rayleigh damping that gives `ratio` at, or between, two frequencies: C = mass_factor M + stiffness_factor K.
struct Rayleigh {
  double ratio = 0.;                           ///< zeta
  std::array<double, 2> frequencies{1., 10.};  ///< Hz
  RayleighFit fit = RayleighFit::ends;
  double mass_factor() const;               ///< 2 zeta w1 w2 / (w1 + w2) (1/s), zeta the ratio at the ends
  double stiffness_factor() const;          ///< 2 zeta / (w1 + w2) (s)
  double ratio_at(double frequency) const;  ///< zeta at a frequency (Hz)
  double error() const;                     ///< largest relative deviation from `ratio` between both frequencies
};

/// Mohr-Coulomb strength of a soil. Where the soil's law is elastic, the strength is not in the equations: the computed
/// stresses are compared with it.
struct Strength {
  double friction_angle = 35.;  ///< phi' (degrees)
  double cohesion = 0.;         ///< c' (Pa)
  double dilatancy_angle = 0.;  ///< psi' (degrees), of Mohr-Coulomb soil
  double tension = 0.;          ///< largest tensile stress (Pa), likewise
};

/// How a soil that yields packs denser under cycles of shear: Byrne (1991), see docs/yielding.md.
struct Densification {
  std::optional<double> relative_density;  ///< D_r, gives C1 = 7600 (100 D_r)^-2.5; or c1
  std::optional<double> c1, c2;            ///< c2 = 0.4/c1 where it is not given
  double threshold = 0.;                   ///< amplitude of shear strain up to which it does not pack denser
  double C1() const;
  double C2() const;
};

/// Sand in which cycles of shear build pore pressure: N cycles of amplitude tau liquefy it where tau/sigma'_0 =
/// alpha N^beta, see docs/cycles.md.
struct CyclicSoil {
  std::optional<double> relative_density;  ///< D_r, gives alpha and beta, and C1 of its densification
  std::optional<double> alpha, beta;       ///< instead of those by D_r
  double alpha_r() const;
  double beta_r() const;
};

/// One physical surface of the mesh. Optional members belong to some kinds only; diagnose() says which are missing.
struct Region {
  RegionKind kind = RegionKind::porous;
  SoilLaw law = SoilLaw::elastic;                          ///< porous, solid
  std::optional<double> shear_modulus;                     ///< G (Pa)
  std::optional<StressLaw> stress_law;                     ///< porous: G by stress, instead of G
  std::optional<StrainLaw> strain_law;                     ///< porous, solid: G and damping as functions of strain
  std::optional<double> youngs_modulus;                    ///< E (Pa), instead of G
  std::optional<double> poissons_ratio;                    ///< nu of the drained skeleton
  std::optional<double> density;                           ///< rigid, solid (kg/m3)
  std::optional<double> mass;                              ///< rigid, instead of density (kg/m)
  std::optional<std::array<double, 2>> centre_of_gravity;  ///< rigid (m); default: centroid of the area
  std::optional<double> moment_of_inertia;                 ///< rigid, about the centre of gravity (kg m2/m)
  std::map<std::string, BodyPart> parts{};                 ///< rigid, where density does not hold
  std::optional<double> porosity;                          ///< n
  std::optional<double> grain_density;                     ///< rho_s (kg/m3)
  std::optional<double> hydraulic_conductivity;            ///< k (m/s)
  std::optional<double> permeability;                      ///< kappa (m2), instead of k = kappa rho_f g / mu
  std::optional<double> forchheimer;                       ///< b of i = w/k + b |w| w (s2/m2); none: 0
  double conductivity_ratio = 1.;                          ///< k_y/k_x; those above are of the horizontal flow
  double saturation = 1.;                                  ///< S, water in the volume of pores; the rest is air
  bool air_by_depth = false;                               ///< whether the air has the pressure at each cell's depth
  std::optional<double> pore_fluid_modulus;                ///< of water with its air (Pa); none: K_f
  Flow flow = Flow::automatic;
  double tortuosity = 1.;
  double biot = 1.;                                                     ///< alpha
  double grain_bulk_modulus = std::numeric_limits<double>::infinity();  ///< K_s (Pa)
  std::optional<Rayleigh> damping;
  std::optional<Strength> strength;                              ///< porous, solid
  std::optional<Densification> densification;                    ///< porous
  std::optional<CyclicSoil> cyclic;                              ///< porous
  std::optional<ContactLaw> interface;                           ///< rigid, solid: of the caisson's bottom
  std::optional<BaseSupport> springs, dashpots;                  ///< rigid: of the caisson, in place of ground
  std::optional<WallWater> added_mass;                           ///< rigid: of the caisson, in place of seas
  Deformation deformation = Deformation::automatic;              ///< solid
  Compressibility compressibility = Compressibility::automatic;  ///< water
  /// Mass of a body of this area (m2), by density and those of its parts, or as given (kg/m).
  double mass_over(double area) const;
};

/// The constants of the equations of motion of one region, ready for the kernels; the law is that of the skeleton.
struct Material : ElasticLaw {
  double rho = 0.;            ///< (1 - n) rho_s + n rho_f, or the solid's density (kg/m3)
  double rho_f = 0.;          ///< fluid density (kg/m3)
  double a = 0.;              ///< tortuosity rho_f / n (kg/m3)
  double b = 0.;              ///< rho_f g / k (Pa s/m2)
  double mobility = 0.;       ///< 1/b (m2/(Pa s)); infinite where no k is given
  double vertical_flow = 1.;  ///< k_y/k_x: b and mobility are those of horizontal flow
  /// k along a unit vector n over k_x.
  double flow_along(double n_y) const { return 1. + (vertical_flow - 1.) * n_y * n_y; }
  double alpha = 0.;                                 ///< Biot's coefficient
  double storage = 0.;                               ///< 1/Q = n/K_f + (alpha - n)/K_s; of water 1/K_f (1/Pa)
  double mass_damping = 0., stiffness_damping = 0.;  ///< Rayleigh factors (1/s, s)
};

/// k (m/s) of horizontal flow in a porous region, from whichever key it has, conductivity or permeability; none where
/// it has neither.
std::optional<double> conductivity(const Region& region, const Fluid& fluid, double gravity);

/// Bulk modulus (Pa) of water with bubbles of air at an absolute pressure (Pa), 1/K = S/K_f + (1 - S)/p: the air obeys
/// Boyle's law, without surface tension, and none dissolves (Verruijt 1969).
double pore_fluid_modulus(const Fluid& fluid, double saturation, double absolute_pressure);

/// Constants of a region that has passed diagnose(); of a rigid region only rho, where it is given. Water whose
/// compressibility is not yet decided is compressible.
Material material(const Region& region, const Fluid& fluid, double gravity);

/// Whether a region of that kind takes the member named `key`.
bool belongs(const std::string& key, RegionKind kind);

/// Everything that is missing, unneeded or contradictory in a region.
Diagnostics diagnose(const Region& region);

}  // namespace upbead
