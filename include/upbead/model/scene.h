// A scene: everything that a run needs to know, in SI units, without files and without a mesh.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "upbead/base/time_function.h"
#include "upbead/model/load.h"
#include "upbead/model/region.h"

namespace upbead {

/// What must meet the tolerance: the peak of F_T alone, or F_T at every time, which includes the peak.
enum class AccuracyOf { peak, history };

struct AccuracyChoice {
  AccuracyOf of = AccuracyOf::history;
  bool estimate = false;  ///< where the case sets the refinement: solve once more on cells half as large
};

enum class UpliftKind {
  prescribed,  ///< given by the user, from a measurement or a formula
  computed,    ///< the scene's own excess pore pressure on the bottom
  wave,        ///< of a case only: the uplift of the load by a wave, prescribed in the scene
};

/// The course in time of a prescribed uplift without a history of its own.
enum class UpliftCourse {
  in_phase,  ///< proportional to P(t) while that is landward
  held,      ///< in_phase up to the largest P, then at its peak: on the safe side where F_T comes after P
};

/// The distribution over the bottom of a prescribed uplift of which only the force U is known.
enum class UpliftDistribution {
  triangle,  ///< 2 U/B at the seaward edge, zero at the heel, after Goda (2000)
  uniform,   ///< U/B everywhere
};

/// A part of the uplift pressure p_u(x, t) = sum shape(x) pressure(t), linear between the points of its shape and zero
/// beyond.
struct UpliftPart {
  std::vector<std::array<double, 2>> shape;  ///< x (m), and the pressure per unit of the history
  TimeFunction pressure;
};

struct UpliftChoice {
  UpliftKind kind = UpliftKind::prescribed;
  std::optional<double> peak;  ///< prescribed, without a history (N/m)
  UpliftCourse course = UpliftCourse::held;
  double lag = 0.;                                                 ///< by which U comes after P (s)
  TimeFunction history;                                            ///< prescribed, without a peak: U(t) (N/m)
  std::vector<UpliftPart> parts;                                   ///< of a history by transducers: their pressures
  UpliftDistribution distribution = UpliftDistribution::triangle;  ///< where there are no parts
};

/// The wave for which tau_0 of Shimosako and Takahashi (1994), eqs. (8)-(11), is computed.
struct SlidingWave {
  double height = 0.;            ///< H (m)
  double depth = 0.;             ///< h (m)
  double period = 0.;            ///< T (s)
  double alpha_star = 0.;        ///< max(alpha_I, alpha_2)
  std::optional<double> factor;  ///< k in tau_0 = k tau_0F; none: that of alpha* by eqs. (8), (9)
};

struct SlidingChoice {
  double friction = 0.6;         ///< mu
  double submerged_weight = 0.;  ///< W', in still water (N/m)
  std::optional<double> weight;  ///< W, in air with fill (N/m); none: mass x g of the caisson
  double drag = 0.;              ///< F_D over velocity, eq. (2) (N s/m2)
  std::optional<UpliftChoice> uplift;
  std::optional<SlidingWave> wave;
};

/// The waves of a storm, of which the run is one, in parts that follow each other in time: docs/cycles.md.
struct Cycles {
  std::vector<double> number;        ///< of waves in each part
  std::vector<double> period;        ///< s
  std::vector<double> height;        ///< of waves (m); empty: all are as the run's
  std::optional<double> run_height;  ///< of the run's wave (m); where there are heights
  std::optional<double> calm;        ///< time after the storm that is followed (s); none: until little pressure is left
  /// Amplitude of shear of a part over that of the run.
  double share(std::size_t part) const { return height.empty() ? 1. : height[part] / *run_height; }
};

/// Everything that is missing or contradictory in [cycles].
Diagnostics diagnose(const Cycles& cycles);

/// Limits of the checks; without a limit there is no check.
struct Limits {
  std::optional<double> sliding;                 ///< S (m)
  std::optional<double> base_pressure;           ///< of p_e by formulas, under heel and toe (Pa)
  std::optional<double> dynamic_base_pressure;   ///< of heel and toe in motion (Pa)
  std::optional<double> overturning;             ///< least margin against it
  std::optional<double> safety;                  ///< least factor of strength at rest; 1 where none is given
  std::optional<double> circles;                 ///< least factor of slip circles under the caisson
  std::optional<double> peak_safety;             ///< least factor of strength at the peak of the wave; asks for it
  std::optional<double> liquefaction;            ///< least factor against momentary liquefaction; asks for it
  std::optional<double> sliding_factor;          ///< least factor against sliding landward by formulas; else 1
  std::optional<double> seaward_sliding_factor;  ///< likewise seaward; else as sliding_factor
  std::optional<double> settlement;              ///< of the caisson, left in the end, downward (m)
  std::optional<double> tilt;                    ///< of the caisson, left in the end (rad)
  std::optional<double> pressure_ratio;          ///< largest residual pore pressure over the effective stress at rest
  std::optional<double> lives_beyond;            ///< share of lives that may slide farther than `sliding`
};

enum class DisplacementCondition {
  fixed,      ///< no motion, or the motion that a load prescribes
  roller,     ///< no motion along its normal, or the motion that a load prescribes
  free,       ///< held by nothing but springs and dashpots, if any
  absorbing,  ///< waves leave
  plate,      ///< stays straight under a rigid smooth plate, which moves along its normal and does not turn
  level,      ///< no vertical motion: a side of ground that is shaken horizontally
};
enum class PressureCondition { sealed, open, absorbing, surface_waves };

/// One table [boundaries.NAME].
struct Boundary {
  DisplacementCondition displacement = DisplacementCondition::free;
  std::optional<PressureCondition> pressure;       ///< needed where the boundary meets pore water or free water
  std::optional<std::array<double, 2>> spring{};   ///< along normal and tangent: stress per displacement (Pa/m)
  std::optional<std::array<double, 2>> dashpot{};  ///< likewise, stress per velocity (Pa s/m)
};

struct MeshChoice {
  std::optional<std::string> geometry;       ///< name of a shipped geometry: composite, column
  std::optional<std::string> file;           ///< or a path
  std::map<std::string, double> parameters;  ///< overrides of the .geo's own parameters
  std::optional<int> refine = 0;             ///< uniform refinements; none: as the tolerance asks
  int degree = 2;                            ///< of u; phi has degree - 1
  bool full_domain = false;                  ///< keep also cells too far away to change a reading before the end
};

enum class TimeScheme { automatic, generalised_alpha, sdirk4, reduced };

struct TimeChoice {
  double end = 1.;             ///< s
  std::optional<double> step;  ///< s; none: chosen from the loads
  TimeScheme scheme = TimeScheme::automatic;
  bool inertia = true;  ///< false: quasi-static (consolidation)
  /// In consolidation, the factor by which steps grow every eighth step once the loads keep their values; 1: no growth.
  double growth = 2.;
  /// Stop once the loads are over and the energy has fallen below this fraction of its largest.
  std::optional<double> stop_at_energy;
};

struct Probe {
  std::array<double, 2> at{0., 0.};  ///< m
};

/// A stage in which the section is built: what appears in it, without stress, on what stands already.
struct ConstructionStage {
  int order = 1;                     ///< stages follow each other by it
  std::vector<std::string> regions;  ///< that appear
  /// Share of the caisson's weight in air that stands after this stage; none: as before, and all of a new caisson.
  std::optional<double> caisson_share;
  std::optional<double> water_level;  ///< of still water in this stage (m); none: that before the waves
};

struct Scene {
  std::string title;
  double gravity = 9.81;  ///< m/s2
  Fluid fluid;
  MeshChoice mesh;
  std::map<std::string, Region> regions;
  std::map<std::string, Boundary> boundaries;
  std::map<std::string, Load> loads;
  TimeChoice time;
  std::optional<InitialState> initial;                    ///< for stiffness that depends on stress
  std::map<std::string, ConstructionStage> construction;  ///< empty: all weights are put on at once
  double tolerance = 0.005;                               ///< relative, of what `accuracy` names
  AccuracyChoice accuracy;
  std::map<std::string, Probe> probes;
  std::optional<double> fields_every;  ///< s; none: no fields
  std::vector<double> output_times;    ///< at which all readings and fields are written (s), ascending
  std::optional<double> output_every;  ///< s between values of the histories; none: the steps' own times
  bool base_stress = false;            ///< whether stress and pore pressure along the caisson's bottom are read
  bool periods = false;                ///< whether the natural periods are sought where the scene is marched, too
  std::optional<SlidingChoice> sliding;
  std::optional<Cycles> cycles;
  Limits limits;
};

/// The region whose shear force at the bottom is read.
inline const std::string caisson_name = "caisson";

/// Whether some load prescribes how a boundary that is held moves.
bool has_prescribed_motion(const Scene& scene);

/// Whether the caisson may slip and lift on its ground, node by node.
bool has_frictional_contact(const Scene& scene);

/// Whether some region's stiffness and damping follow the strain.
bool follows_strain(const Scene& scene);

/// Whether in some region the drag of the pore water grows with its velocity.
bool follows_velocity(const Scene& scene);

/// Whether some region's law lets it yield.
bool yields(const Scene& scene);

/// Whether some region has a strength that is not part of its law: stresses are compared with it.
bool has_strength(const Scene& scene);

/// Whether cycles of a storm build pore pressure in some region.
bool builds_pressure(const Scene& scene);

/// The friction coefficient of that contact: its own, that of [sliding], or 0.6.
double contact_friction(const Scene& scene);

/// Names of the stages in the order in which they are built.
std::vector<std::string> stages_in_order(const Scene& scene);

/// The shortest time in which a load rises and falls (s): Load::duration where it is set (a sine: half its period),
/// else twice the least distance of two kinks; 0 where a load jumps, infinity where no load has a kink.
double shortest_duration(const Scene& scene);

/// The frequency (rad/s) beyond which the spectrum |F(omega)| of no load exceeds a hundredth of the integral of |f|,
/// its bound at omega = 0: from |F| <= V / omega^2, V the total variation of f'. Of a triangle 40 / duration. Infinite
/// where a load jumps, 0 where there is none.
double bandwidth(const Scene& scene);

}  // namespace upbead
