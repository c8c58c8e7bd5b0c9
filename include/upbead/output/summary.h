// summary.json: what a run found, in SI numbers. Where each number is made, with its key, unit and meaning:
// src/findings; docs/output.md is made from these.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "upbead/base/numbered_warning.h"
#include "upbead/dynamics/energy.h"
#include "upbead/fem/load_on_caisson.h"
#include "upbead/output/check.h"
#include "upbead/response/findings.h"
#include "upbead/sliding/base_pressure.h"
#include "upbead/sliding/history_sliding.h"
#include "upbead/waves/breaking_impact.h"
#include "upbead/waves/standing_stability.h"

namespace upbead {

/// One way of solving, and why it was refused, if it was.
struct LadderStep {
  std::string way;      ///< for people: "reduced", "sdirk4", "sdirk4, steps of 0.001 s"
  std::string refused;  ///< the reason with its numbers; "" where it was taken
};

/// In the order in which they were tried; the last one was taken.
using Ladder = std::vector<LadderStep>;

/// How near the bonded caisson comes to slipping or lifting, at the node where it comes nearest.
struct BondedDemand {
  double slip = 0.;          ///< largest |T_i| / (mu N_i); infinite (null in the file) where a node pulls
  double least_normal = 0.;  ///< least N_i over N_i at rest; below 0 where a node pulls
  double margin = 0.;        ///< of both, allowing for errors of the forces; 0 where it was marched
  bool reached = false;      ///< whether one of the two reaches its limit within the margin
};

/// The model of the ground with which contact node by node was solved.
struct ContactGround {
  int coordinates = 0;                              ///< besides the motions of the nodes
  int solves = 0;                                   ///< of the whole ground, to make it
  double slip = 0., peak_shear = 0., history = 0.;  ///< errors of S (m), and of peak F_T and F_T(t), relative
  double others = 0.;                               ///< largest of all other readings, over its peak
  std::vector<InexactReading> inexact;              ///< those that do not meet their tolerance
  double tolerance_of_others = 0.;
};

/// What the bottom did, node by node.
struct NodeContact {
  double slip = 0.;                      ///< S
  std::optional<double> error_estimate;  ///< none where the case asks for none
  double largest_slip = 0., least_slip = 0.;
  double opening_seaward = 0., opening_landward = 0.;
  double least_contact = 1., least_normal_force = 0.;
  std::optional<double> first_slip, first_open;
  double lift_energy = 0.;             ///< largest that the weight gains by openings (J/m)
  double closing_speed = 0.;           ///< largest at which an end closes (m/s)
  std::optional<double> closing_time;  ///< of that (s); none: neither end opens and closes
  std::optional<double> last_closing;  ///< since when all nodes touch (s); none: no node opened, or one is open
  double open_in_end = 0.;             ///< share of the width
  std::optional<double> gap_force;     ///< largest that the sea in gaps adds (N/m); none: they take it from the pores
  double dissipated = 0.;
  double end_velocity = 0.;             ///< in the last step, of the node that slips least then (m/s)
  int slip_steps = 0, open_steps = 0;   ///< steps in which a node slipped, was open
  int impacts = 0;                      ///< how often a node closed
  int fallbacks = 0;                    ///< contact problems that were solved by the slower method
  std::optional<ContactGround> ground;  ///< none where all unknowns were marched
};

struct ContactSummary {
  double friction = 0.;  ///< mu
  double weight = 0.;    ///< sum of N_i at rest (N/m)
  int nodes = 0;
  BondedDemand demand;
  std::optional<NodeContact> solved;  ///< none where the bonded solution obeys the law of contact
};

/// At the ends of the steps; N by step and node, row by row.
struct ContactHistory {
  std::vector<double> position, length;           ///< of the nodes (m)
  std::vector<double> time;                       ///< s
  std::vector<double> slip, opening;              ///< m
  std::vector<double> shear_force, normal_force;  ///< T_i, landward on the ground, and effective N_i (N/m)
  /// What the sea in gaps adds to a prescribed uplift: force (N/m), and moment about x = 0, overturning landward
  /// positive (N m/m), by step; empty where gaps take water from the pores alone.
  std::vector<double> gap_force, gap_moment;
};

/// S by tau_0 of eqs. (8)-(11) of Shimosako and Takahashi (1994) and the run's own F_Smax.
struct PulseSliding {
  double standing_duration = 0., factor = 0., duration = 0.;  ///< tau_0F (s), k(alpha*), tau_0 (s)
  double paper = 0.;                                          ///< S_CAL, eq. (7) (m)
  PaperParts paper_parts;                                     ///< S_1 and S_2
  double exact = 0.;                                          ///< by integrating eqs. (4) and (6) (m)
};

/// At the samples of the loads.
struct CoupledHistoryTable {
  std::vector<double> time;                       ///< s
  std::vector<double> shear_force, normal_force;  ///< F_T, N' (N/m)
  std::vector<double> velocity, slip;             ///< s' (m/s), s (m)
  std::vector<double> displacement;               ///< x_G, the slip included (m)
};

/// S of a caisson that slips as a whole, together with the motion of soil, mound and water of the scene.
struct CoupledSummary {
  Sliding slip;  ///< over the mound
  double dissipated = 0., peak_shear = 0., least_normal = 0., lifted_time = 0.;
  int vectors = 0;                      ///< 0 where the bonded caisson does not reach its friction
  double error = 0., glued_error = 0.;  ///< between nested models, and from the bonded solution
  double growth = 0.;                   ///< of the fastest vibration that friction feeds
  double damping_time = 0., damping_effect = 0.;
  double seconds = 0.;                         ///< wall time to find it
  std::optional<CoupledHistoryTable> history;  ///< where it slips
  std::optional<double> error_estimate;
};

/// The triangular pulse with the peak and the impulse of F_S.
struct EqualImpulse {
  double duration = 0., paper = 0., exact = 0.;  ///< as of PulseSliding
};

/// S by eq. (4) on F_T(t) (m), for each course that a prescribed peak of U may take.
struct UpliftCourses {
  double held = 0., in_phase = 0.;
};

/// The S to design by.
struct DesignSliding {
  double value = 0.;                     ///< m
  std::string measure;                   ///< the key of the summary that gives it
  std::string why;                       ///< this measure was chosen
  std::optional<double> error_estimate;  ///< m
  double largest = 0.;                   ///< of largest magnitude on the way, by the same measure (m)
  double end_velocity = 0.;              ///< at the end of the run (m/s)
  bool rests = true;                     ///< whether the loads at the end of the run let the caisson come to rest
  std::string why_not_all = {};          ///< why the value is not the whole distance though it rests; else ""
};

struct SlidingSummary {
  double weight = 0., submerged_weight = 0., friction = 0., drag = 0.;  ///< W, W', mu, F_D over velocity
  std::string uplift;                                                   ///< none, prescribed or computed
  HistorySliding history;
  DesignSliding design;
  std::optional<UpliftCourses> courses;       ///< where a peak of U is prescribed without its course
  std::optional<PulseSliding> pulse;          ///< where the case names a wave
  std::optional<EqualImpulse> equal_impulse;  ///< where F_S has a landward peak
  std::optional<CoupledSummary> coupled;      ///< where it could be computed
  std::string why_not_coupled;                ///< else
  bool coupled_failed = false;                ///< whether the numerics failed; false: the scene does not allow it
  std::optional<double> error_estimate;       ///< of S by eq. (4) on F_T(t) (m)
  std::string why_no_estimate;                ///< else
  double lift_of_loads = 0.;                  ///< largest force of the loads on the caisson upward (N/m)
};

/// Still water at two levels, in front of a caisson and behind it.
struct HarbourSummary {
  double front = 0., back = 0.;  ///< heights y of the levels (m)
  double push = 0.;              ///< of both waters at rest, landward (N/m)
  double weight_gained = 0.;     ///< by which W' exceeds that in water as high as the higher level (N/m)
  bool counted = false;          ///< whether it is in all numbers, by initial.harbour_level
};

/// What presses on the base.
struct BaseSummary : BaseExtremes {
  /// Largest of the edges under the loads without motion (Pa); none where their resultant leaves the base.
  std::optional<double> static_heel_pressure, static_toe_pressure;
  std::optional<double> static_overturning_margin;  ///< least under the loads without motion
  std::optional<double> peak_computed_pressure;     ///< largest at a node of the bottom (Pa); none where it is not read
  double peak_computed_pressure_at = 0., peak_computed_pressure_time = 0.;  ///< where (m) and when
  std::optional<double> limit;                                              ///< of heel and toe pressure in motion (Pa)
};

struct Discretisation {
  int cells = 0, unknowns = 0, degree = 0;
  std::string scheme;
  double time_step = 0.;  ///< the largest
  int steps = 0, solves = 0, factorisations = 0, processes = 1;
  std::string why_scheme, why_step;  ///< this way was taken, and its steps are as long as they are
  bool stopped_early = false;        ///< as little energy was left, which the case allows
};

/// Errors of a reduced model: the differences of two nested models. The larger one is used, and its errors are smaller.
struct ReductionSummary {
  int vectors = 0, modes = 0;
  double error = 0., error_peak = 0., error_of_others = 0.;
  std::optional<double> error_of_states;  ///< where fields or strengths were asked for, see energy_distance()
  /// Estimated, of the history of F_T over its peak, where one model answers all soils; none where this soil was
  /// reduced.
  std::optional<double> error_of_soils;
  double highest_frequency = 0.;        ///< up to which the transfer function of F_T has been checked
  std::vector<InexactReading> inexact;  ///< readings other than F_T that do not meet their tolerance
  double tolerance_of_others = 0.;      ///< of these readings
};

/// Estimated errors of the peak of F_T, or of its history over the largest |F_T|, one for each source of error. Each
/// estimate is meant as a bound; docs/accuracy.md has how often it held.
struct ErrorEstimate {
  double mesh = 0.;           ///< from the size of the cells
  double time = 0.;           ///< from the length of the steps; 0 where a reduced model is exact in time
  double reduced_model = 0.;  ///< from the number of vectors; 0 where it was marched
  double far_boundary = 0.;   ///< from waves that the far sides reflect; 0 for the history: walls_too_near warns
  double total() const { return mesh + time + reduced_model + far_boundary; }
};

/// Soil whose stiffness and damping follow the strain of the response, or whose drag follows the pore water's velocity.
struct SoilSummary {
  int iterations = 0;      ///< of linear solutions after the first
  bool converged = false;  ///< whether the last change was below 1 %
  double change = 1.;      ///< of the peak of |F_T|, or of the velocity, in the last iteration, relative
  /// Peak |F_T| at vanishing strain and velocity and in the last iteration; without a caisson, strains or velocities.
  double linear = 0., settled = 0.;
  double largest_strain = 0., least_modulus_ratio = 1., largest_damping = 0.;
  double largest_velocity = 0., least_conductivity_ratio = 1.;
};

/// The excess pore pressure of largest magnitude that is left at the end of a run.
struct PorePressureLeft {
  double value = 0.;                 ///< Pa
  std::array<double, 2> at{0., 0.};  ///< where (m)
};

/// The largest shear strain of a cell of soil that yields, at its middle, at any time.
struct PeakStrain {
  double value = 0.;
  std::array<double, 2> at{0., 0.};       ///< where (m)
  std::optional<double> over_neighbours;  ///< over the mean of the cells beside it; none where these are at rest
};

/// How much of its strength, by its law, a region of soil that yields mobilised. The value of a cell is the mean of its
/// points.
struct MobilisedRegion {
  std::string region, law;
  double initial = 0.;               ///< largest at rest
  double initial_share = 0.;         ///< share of the area where all strength is mobilised at rest
  double largest = 0.;               ///< at any time
  std::array<double, 2> at{0., 0.};  ///< where that is (m)
  double time = 0.;                  ///< and when (s)
  double share = 0.;                 ///< share of the area where all strength was mobilised at some time
};

/// Where the caisson came to rest, at the end of the run.
struct ResidualSummary {
  double displacement_x = 0., displacement_y = 0.;  ///< of the centre of gravity, landward and upward (m)
  double rotation = 0.;                             ///< rad
  std::optional<PorePressureLeft> pore_pressure;    ///< in the soil; none where it has no pore water
  /// Least and largest of these in the last fifth of the run (m, m, rad).
  std::array<double, 2> range_x{0., 0.}, range_y{0., 0.}, range_rotation{0., 0.};
};

/// The result with another start of hysteretic soil.
struct StartBound {
  std::string start;                           ///< virgin, k0 or gravity
  double peak_shear = 0.;                      ///< N/m
  std::optional<double> shear_to_force_ratio;  ///< as of ShearResponse
  ResidualSummary residual;
};

/// How Mohr-Coulomb soil came to rest under its weights.
struct RestSummary {
  int steps = 0, iterations = 0;  ///< steps of the weights; iterations of Newton's method in them
  double share_at_strength = 0.;  ///< share of that soil's area where its strength is reached
  double out_of_balance = 0.;     ///< forces out of balance over the weights
};

/// Bounds of the factor by which the strength of all soils may fall at rest.
struct SafetySummary {
  std::optional<double> lower, upper;  ///< it stands at `lower`, it does not at `upper`
  std::string fails_at;                ///< where it gives way at `upper`
  std::string why_open;                ///< why the bounds are no closer; "" where they are as close as asked for
};

/// How the caisson moved in a stage of construction, or since it was set down, and how it presses then.
struct CaissonMotion {
  double settlement = 0., displacement_x = 0., rotation = 0.;  ///< downward, landward (m); top landward (rad)
};

/// A stage of construction, drained, when it is done.
struct StageSummary {
  std::string name, regions;         ///< regions: those that appear, with commas
  double weight = 0.;                ///< of all that stands, in water (N/m)
  std::optional<double> settlement;  ///< largest of the ground in this stage, downward (m); none in the first stage
  std::array<double, 2> settlement_at{0., 0.};  ///< m
  std::optional<CaissonMotion> caisson;         ///< in this stage; none before it is set down
  /// Of the edges, stress varying linearly (Pa); none before, of a solid caisson, and where the resultant leaves them.
  std::optional<double> heel_pressure, toe_pressure;
  std::optional<double> mobilised;             ///< largest share of the strength; none where no region has one
  std::array<double, 2> mobilised_at{0., 0.};  ///< m
  std::string mobilised_in;                    ///< region
  std::optional<double> share_at_strength;     ///< of Mohr-Coulomb soil that stands; none without any
};

/// How the section was built.
struct ConstructionSummary {
  std::vector<StageSummary> stages;      ///< as far as they stand
  std::optional<CaissonMotion> caisson;  ///< since it was set down
  std::string falls_in;                  ///< the stage that has no rest; "" where all have
};

/// Bounds of the factor by which the strength of all soils may fall while the base presses as at a moment of the wave.
struct PeakSafety {
  std::optional<double> lower, upper;          ///< the ground bears it at `lower`, it does not at `upper`
  double time = 0.;                            ///< s
  std::string pressure;                        ///< in the pores: still, computed
  double force = 0., shear = 0., moment = 0.;  ///< N', F_T (N/m) and M' (N m/m) of the base
  std::string fails_at;                        ///< where it gives way at `upper`
  std::string moves;  ///< how the base moves as it fails: landward, seaward, and whether it turns or sinks; or ""
  std::array<double, 2> centre{0., 0.};  ///< about which the base turns then (m)
  std::optional<double> depth;           ///< below the base, above which 95 % of that work of shearing is done (m)
  std::optional<double> circle;          ///< F of the least circle then, with the same pressure
  std::optional<double> block;           ///< likewise of the least block
  int moments = 0;                       ///< that were looked at
  std::string why_open;                  ///< why the bounds are no closer; "" where they are as close as asked for
};

/// Where the flow upward out of the ground comes nearest to lifting it, in one region on one side of the caisson.
struct LiquefiedPlace {
  std::string region;                 ///< its name
  std::string side;                   ///< of the caisson: sea, harbour; "" without a caisson
  std::optional<double> factor;       ///< effective stress at rest over excess pressure; none: nothing presses upward
  double pressure = 0., stress = 0.;  ///< excess pressure over that on the surface above; s'_v at rest (Pa)
  std::array<double, 2> at{0., 0.};   ///< m
  double below = 0.;                  ///< depth of that place under the surface (m)
  double time = 0.;                   ///< s
  double depth = 0.;                  ///< below the surface, down to which no stress is left at some time (m)
  std::optional<double> depth_x;      ///< where that is (m); none: nowhere
  std::optional<double> depth_time;   ///< and when (s)
  double cell = 0.;                   ///< height of the cell under the surface there (m)
};

/// Momentary liquefaction of the ground beside the caisson.
struct Liquefaction {
  std::vector<LiquefiedPlace> places;  ///< by region and side
  std::optional<double> factor;        ///< the least of them
  std::string coarse{};                ///< why it is too large, by cells under the surface; "" where it is not
};

/// The least factor over time of the circles that were found; NaN where nothing drives one with the width upon it.
struct SlipCircleCourse {
  std::vector<double> time, factor;  ///< s, 1
};

/// The slices of a circle, from left to right.
struct SlipCircleSlices {
  std::vector<double> x, width;       ///< middle, width (m)
  std::vector<double> base, surface;  ///< y (m)
  std::vector<double> weight;         ///< w + q (Pa)
  std::vector<double> pressure;       ///< excess pore pressure at the base (Pa)
};

/// The least safe slip circle through the ground under the caisson, and what pressed on the ground then.
struct SlipCircleFound {
  double factor = 0.;                          ///< F by Bishop's simplified method
  double driving = 0.;                         ///< moment that drives over the radius (N/m)
  std::optional<double> time;                  ///< s; none: at rest
  std::string slips;                           ///< landward or seaward
  std::array<double, 2> centre{0., 0.};        ///< m
  double radius = 0., from = 0., to = 0.;      ///< of the circle, and x of its ends on the surface (m)
  double force = 0., shear = 0., moment = 0.;  ///< N', F_T (N/m) and M' (N m/m) of the base
  double strip_from = 0., strip_to = 0.;       ///< x of the ends of the effective width (m)
};

/// The least safe block that slips on a level plane through the ground between two wedges, at one moment.
struct SlipBlockFound {
  double factor = 0.;        ///< F by horizontal forces, without Janbu's f_0
  std::vector<double> x, y;  ///< corners, from left to right (m)
  bool at_limit = false;     ///< where the method or the search ends: a less safe block may have no factor
};

/// Slip circles under the caisson: at rest, and in motion with the pore pressure of still water and with that computed.
struct SlipCircles {
  std::optional<SlipCircleFound> at_rest, still, computed;  ///< none: no circle has a factor, or not looked for
  std::string why_not_computed;            ///< why there is none by the computed pressure; "" where there is
  std::optional<SlipCircleFound> governs;  ///< the least of them
  std::string by;                          ///< which that is: at_rest, still, computed
  std::optional<SlipBlockFound> block;     ///< of the moment and pressure that govern; none where no block has a factor
  std::optional<SlipCircleFound>
      static_design;                          ///< the least under the loads without motion, in still water's pressure
  std::optional<double> dynamic_load_factor;  ///< factor of static_design over that in motion
  SlipCircleCourse course;                    ///< with the pressure that governs
  SlipCircleSlices slices;                    ///< of it
  std::optional<double> leaves_time;          ///< when the resultant leaves the base, so that no strip bears it (s)
  std::string uncut;        ///< regions without a strength, which no circle cuts; "" where there are none
  double share_steep = 0.;  ///< of the circles tried: left out, as the method does not hold for them
};

/// What the cycles of a storm left in a region whose sand builds pore pressure.
struct CyclicRegion {
  std::string region;
  double alpha = 0., beta = 0.;              ///< tau/sigma'_0 = alpha N^beta
  double largest_shear = 0.;                 ///< amplitude of the run's wave (Pa)
  double largest_stress_ratio = 0.;          ///< tau/sigma'_0 of the largest waves of the storm
  double least_cycles = 0.;                  ///< of these that liquefy the soil, N_l
  double largest_ratio = 0.;                 ///< p/sigma'_0 at any time
  std::array<double, 2> at{0., 0.};          ///< where that is (m)
  double time = 0.;                          ///< and when, from the storm's beginning (s)
  double ratio_at_end = 0.;                  ///< largest p/sigma'_0 when the storm ends
  double share_liquefied = 0.;               ///< of the area where p reached sigma'_0
  double left_out = 0.;                      ///< share of the area without an effective stress to speak of
  std::optional<double> largest_compaction;  ///< volumetric strain by cycles of shear; none without D_r
};

/// How the caisson has settled once all residual pressure is gone.
struct CaissonSettling {
  double settlement = 0.;  ///< downward (m)
  double tilt = 0.;        ///< landward positive (rad)
};

/// By active cell index of the mesh; NaN where there is none.
struct CycleFields {
  std::vector<double> effective_stress, shear;  ///< mean at rest, and cyclic amplitude in the run's wave (Pa)
  std::vector<double> pressure;                 ///< residual, when the storm ends (Pa)
  std::vector<double> largest_ratio;            ///< p/sigma'_0
  std::vector<double> compaction, drained;      ///< volumetric strain by shear, and by the water that was pressed out
};

/// Volumes of water per metre over storm and calm (m2): source = stored + outflow + shed.
struct ResidualWater {
  double source = 0.;   ///< pressed out of the soil by shear
  double stored = 0.;   ///< still under pressure in the end
  double outflow = 0.;  ///< that has drained
  double shed = 0.;     ///< that liquefied soil does not press out, as it bears no more
  double error = 0.;    ///< of the balance, over the source
};

/// Residual pore pressure, settlement and tilt of a storm.
struct CyclesSummary {
  double waves = 0., duration = 0., calm = 0.;  ///< number; of the storm and of the time followed after it (s)
  double largest_ratio = 0.;                    ///< p/sigma'_0
  std::array<double, 2> at{0., 0.};             ///< where that is (m)
  double time = 0.;                             ///< and when (s)
  int cells_liquefied = 0;
  double area_liquefied = 0.;             ///< m2
  std::optional<double> first_liquefied;  ///< when the first cell liquefies (s)
  double ratio_left = 0.;                 ///< largest p/sigma'_0 at the end of the calm
  ResidualWater water;
  std::optional<CaissonSettling> by_compaction, by_drainage;
  std::string why_no_settling;  ///< why both are missing; "" where one is there
  std::vector<CyclicRegion> regions;
  std::vector<double> history_time, history_ratio;  ///< s; largest p/sigma'_0 then
  std::shared_ptr<const CycleFields> fields;
};

/// What it cost to solve soil that yields, and how far it yielded.
struct NonlinearSummary {
  std::string start;
  int stages = 0, iterations = 0;  ///< stages solved, and updates of all stresses in them
  int factorisations = 0;
  int cut_steps = 0;                 ///< steps that were halved because a stage did not converge
  double share_skipped = 0.;         ///< share of the updates of cells left out because the cell could not yield
  double share_yielded = 0.;         ///< share of the area of soil that yields, where it lost energy
  double share_beyond_at_rest = 0.;  ///< share of this area where the stress at rest exceeds the strength
  std::optional<RestSummary> rest;   ///< none without Mohr-Coulomb soil
  std::string why_no_rest;           ///< why that soil has no state at rest; "" where it has, and without such soil
  PeakStrain peak_strain;
  std::vector<MobilisedRegion> regions;
  std::vector<StartBound> bounds;
};

/// How the program read a record of a CFD program.
struct FlowSummary {
  std::string name;  ///< of the load
  std::string layout;
  int files = 0, samples = 0;
  double begin = 0., end = 0.;                   ///< of the record in the run's time (s)
  std::optional<double> thickness;               ///< of the domain, by which its forces were divided (m)
  double peak_force = 0., peak_force_time = 0.;  ///< landward, over still water (N/m; s)
  std::optional<double> arm;                     ///< of it (m)
  double still_force = 0.;                       ///< of still water, subtracted (N/m)
  std::optional<double> difference;              ///< of pressures and forces
  std::vector<std::string> told;
};

std::string text_of(const std::vector<FlowSummary>& flows);

/// What transducers along a wall or a bottom measured.
struct GaugeSummary {
  std::string name;  ///< of the load; "sliding.uplift"
  int gauges = 0, samples = 0;
  double interval = 0.;                          ///< between samples, mean (s)
  std::string peak_gauge;                        ///< transducer with the largest pressure
  double peak_pressure = 0., peak_at = 0.;       ///< that pressure, and where (Pa, m)
  double peak_pressure_time = 0.;                ///< s
  double peak_force = 0., peak_force_time = 0.;  ///< largest magnitude of their resultant (N/m, s)
  std::optional<double> arm;  ///< of that force above the bottom; of an uplift, landward of the bottom's middle (m)
  double force_error = 0.,
         arm_error = 0.;            ///< by interpolation: of the force, relative; of the arm, over the row's length
  std::optional<double> load_cell;  ///< largest force by the load cell (N/m)
};

/// A load by a wave, by Goda's formulas; forces do not include the load's factor unless a comment says so.
struct WaveLoadSummary {
  std::string name, course;
  double height = 0., significant_height = 0., period = 0., angle = 0.;  ///< H, H_1/3 (m), T (s), beta (degrees)
  double wavelength = 0.;                                                ///< L (m)
  WavePressure pressure;                                                 ///< with alpha*
  double peak = 0., peak_uplift = 0.;                                    ///< of the load, with its factor (N/m)
  std::optional<double> trough_force;        ///< of a standing wave: least P, with the factor (N/m)
  double rise = 0., duration = 0.;           ///< of the impulsive part; of a sine, of the whole (s)
  double standing_force = 0., impulse = 0.;  ///< peak of the slow part (N/m), integral (N s/m); with factor
  double end = 0.;                           ///< when the load ends (s)
  std::optional<double> peak_over_goda;      ///< peak of the load over Goda's P with alpha*, both with the factor
  std::optional<Stability> stability;        ///< by Goda's formulas, with the factor; none of a load that pulls seaward
  StandingResult standing;                   ///< the wave in case it does not break, with the factor
  std::optional<BreakingImpact> impact;      ///< by PROVERBS, without the factor; none where the peak is not by it
  std::optional<double> direction;  ///< from which the wave comes, from north (degrees); none where beta is given
  std::optional<double> sliding;    ///< S of that P by eqs. (4) and (6), tau_0 = k(alpha*) tau_0F (m)
  std::optional<double> sliding_combined;  ///< with the standing wave besides, Shimosako and Takahashi (1998) (m)
  std::vector<std::string> assumptions;
};

/// A measured history, compared with the computed one.
struct MeasuredSummary {
  std::string name, reading, unit;
  Comparison comparison;
};

/// What was left out, and why.
struct Skipped {
  std::string what;
  std::string why;
};

/// Wall times (s). `factorise` and `march` do not overlap; `total` runs from the start of the program.
struct Timing {
  double mesh = 0., compile = 0., factorise = 0., march = 0., output = 0., total = 0.;
};

struct Summary {
  std::string title;
  Discretisation discretisation;
  std::optional<ShearResponse> response;  ///< none without a caisson
  std::vector<LoadOnCaisson> loads;
  std::vector<GaugeSummary> gauges;
  std::vector<FlowSummary> flows;
  std::vector<WaveLoadSummary> waves;
  std::vector<MeasuredSummary> measured;
  std::optional<EnergyAccount> energy;              ///< none where no march kept an account
  std::optional<ReductionSummary> reduction;        ///< none where it was marched
  std::vector<NaturalPeriod> periods;               ///< of F_T; none where no reduced model was made
  std::string why_no_periods;                       ///< of a scene that is marched
  std::optional<ErrorEstimate> error;               ///< of the peak; none where the mesh error was not estimated
  std::optional<ErrorEstimate> history_error;       ///< of the whole history; with it
  std::optional<SlidingSummary> sliding;            ///< none without [sliding]
  std::optional<HarbourSummary> harbour;            ///< none where still water has one level
  std::optional<BaseSummary> base;                  ///< none where the forces on the base at rest are not known
  std::optional<ContactSummary> contact;            ///< none where the bottom is bonded
  std::optional<SoilSummary> soil;                  ///< none where no soil depends on strain
  std::optional<NonlinearSummary> nonlinear;        ///< none where no soil yields
  std::optional<ResidualSummary> residual;          ///< where soil yields, of a caisson
  bool loads_elsewhere = false;                     ///< loads on the caisson are not all that presses it
  std::vector<CompactedSoil> densification;         ///< of the regions that pack denser
  std::optional<SafetySummary> safety;              ///< where it is asked for, and where no rest was found
  std::optional<ConstructionSummary> construction;  ///< none where it is not built in stages
  std::optional<SlipCircles> circles;               ///< none where no region has a strength, or no base presses on it
  std::string why_no_circles;                       ///< why not; "" where they are there
  std::optional<PeakSafety> peak_safety;            ///< where it is asked for
  std::string why_no_peak_safety;                   ///< why it was not found; "" where it was, or was not asked for
  std::optional<Liquefaction> liquefaction;         ///< where it is asked for
  std::string why_no_liquefaction;                  ///< why it was not found; "" where it was, or was not asked for
  std::optional<CyclesSummary> cycles;              ///< none where no storm builds pressure
  std::string why_no_cycles;                        ///< why not, where a storm is given; "" where it is there
  std::string why_void;                             ///< why nothing that was marched holds; "" where it does
  std::optional<Verdict> verdict;                   ///< drawn from checks and warnings
  Checks checks;                                    ///< of the section, in the order of a sheet
  Checks formula_checks;                            ///< of its loads by waves, which `checks` end with
  std::vector<MobilisedStrength> strength;          ///< of the regions whose strength is given
  NumberedWarnings warnings;                        ///< docs/warnings.md
  Ladder ladder;                                    ///< the ways tried; the last one was taken
  std::vector<Skipped> skipped;
  Timing timing;
};

}  // namespace upbead
