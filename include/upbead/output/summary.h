// summary.json: what a run found, in SI numbers. Where each number is made, with its key, unit and meaning:
// src/findings; docs/output.md is made from these.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "upbead/base/numbered_warning.h"
#include "upbead/dynamics/energy.h"
#include "upbead/fem/load_on_caisson.h"
#include "upbead/output/check.h"
#include "upbead/output/ground_summary.h"
#include "upbead/output/sliding_summary.h"
#include "upbead/response/findings.h"
#include "upbead/sliding/base_pressure.h"
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
