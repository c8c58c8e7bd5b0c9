// What a run found of the ground: its stiffness, strength and rest, pore pressure, slip circles, storms, construction.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace upbead {

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

}  // namespace upbead
