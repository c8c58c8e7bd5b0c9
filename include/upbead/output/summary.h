// summary.json: what a run found, in SI numbers.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "upbead/base/numbered_warning.h"
#include "upbead/dynamics/energy.h"
#include "upbead/output/contact_summary.h"
#include "upbead/output/ladder.h"
#include "upbead/output/sliding_summary.h"
#include "upbead/response/comparison.h"
#include "upbead/response/mobilisation.h"
#include "upbead/response/reduction.h"
#include "upbead/response/shear_response.h"

namespace upbead {

struct Discretisation {
  int cells = 0;
  int unknowns = 0;
  int degree = 0;
  std::string scheme;
  double time_step = 0.;  ///< the largest (s)
  int steps = 0;
  int solves = 0;
  int factorisations = 0;
  int processes = 1;
};

/// How good a reduced model is: the differences of two nested ones, which the larger one undercuts.
struct ReductionSummary {
  int vectors = 0;  ///< of the Krylov space
  int modes = 0;
  double error = 0.;                ///< of the history of F_T, over its largest value
  double error_peak = 0.;           ///< of its peaks
  double error_of_others = 0.;      ///< the largest of all other readings' histories, each over its largest value
  double highest_frequency = 0.;    ///< up to which the transfer function of F_T has been checked (Hz)
  std::vector<LooseReading> loose;  ///< readings that have not come close enough, besides F_T
  double tolerance_of_others = 0.;  ///< that these were to meet
};

/// How wrong the peak of F_T is, or its history over the largest |F_T|, by where it comes from; each is meant as a
/// bound: how often it held is measured in docs/accuracy.md.
struct ErrorEstimate {
  double mesh = 0.;           ///< cells too large
  double time = 0.;           ///< steps too long; 0 where a reduced model answers in time exactly
  double reduced_model = 0.;  ///< vectors too few; 0 where it was marched
  double far_boundary = 0.;   ///< what the far sides send back; of the history 0: walls_too_near tells
  double total() const { return mesh + time + reduced_model + far_boundary; }
};

/// What the strain of the response made of the soil.
struct SoilSummary {
  int iterations = 0;               ///< of linear solutions after the first
  bool converged = false;           ///< whether the last change was below 1 %
  double change = 1.;               ///< of the peak of |F_T| in the last one, relative
  double linear = 0.;               ///< peak |F_T| with stiffness and damping at vanishing strain (N/m)
  double settled = 0.;              ///< peak |F_T| in the last one (N/m); without a caisson both are strains
  double largest_strain = 0.;       ///< largest effective shear strain of a cell
  double least_modulus_ratio = 1.;  ///< least G/G_max
  double largest_damping = 0.;      ///< largest damping ratio
};

/// What transducers along a wall or a bottom measured.
struct GaugeSummary {
  std::string name;  ///< of the load; "sliding.uplift"
  int gauges = 0, samples = 0;
  double interval = 0.;                          ///< between samples, mean (s)
  std::string peak_gauge;                        ///< that saw the largest pressure
  double peak_pressure = 0., peak_at = 0.;       ///< it, and where (Pa, m)
  double peak_pressure_time = 0.;                ///< s
  double peak_force = 0., peak_force_time = 0.;  ///< largest magnitude of their resultant (N/m, s)
  std::optional<double> arm;  ///< of it, above the bottom; of an uplift landward of the bottom's middle (m)
  double force_error = 0.,
         arm_error = 0.;            ///< by interpolation: of the force, relative; of the arm, over the row's length
  std::optional<double> load_cell;  ///< largest force by the load cell (N/m)
};

/// A measured history against the computed one.
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
  std::vector<MeasuredSummary> measured;
  std::optional<EnergyAccount> energy;         ///< none where no march kept an account
  std::optional<ReductionSummary> reduction;   ///< none where it was marched
  std::optional<ErrorEstimate> error;          ///< of the peak; none where the mesh was not made for the tolerance
  std::optional<ErrorEstimate> history_error;  ///< of the whole history; with it
  std::optional<SlidingSummary> sliding;       ///< none without [sliding]
  std::optional<ContactSummary> contact;       ///< none where the bottom is tied
  std::optional<SoilSummary> soil;             ///< none where no soil depends on strain
  std::vector<MobilisedStrength> strength;     ///< of the regions whose strength is given
  NumberedWarnings warnings;                   ///< docs/warnings.md
  Ladder ladder;                               ///< the ways tried; the last one was taken
  std::vector<Skipped> skipped;
  Timing timing;
};

/// An object by name, as below the key `gauges`.
std::string gauges_json(const std::vector<GaugeSummary>& gauges);

/// JSON with the keys of docs/output.md; null where a value does not exist. Throws NumericsError where one is not
/// finite.
std::string to_json(const Summary& summary);

}  // namespace upbead
