// What `upbead expected` computes for a design, and its output: summary.json, results.h5, and in brief.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "case/records/record_layout.h"
#include "design.h"
#include "design/lives.h"
#include "expected/dynamic_law.h"
#include "expected/wave_sample.h"
#include "output/checks.h"
#include "upbead/expected/life.h"
#include "upbead/expected/sliding_law.h"

namespace upbead {

struct OutputRow;
struct ReducedModelFile;

inline const std::vector<Law> all_laws{Law::paper, Law::exact, Law::combined, Law::dynamic};

/// The pressures on the base in the highest wave of one sea state, or of all.
struct HighestOnBase {
  double height = 0.;                ///< exceeded by one wave of the sea state, or the limit (m)
  WorstBase goda;                    ///< by Goda's formulas, with alpha*
  std::optional<WorstBase> dynamic;  ///< by the reduced model
  std::string why_not_dynamic;
};

/// Results of one sea state by quadrature; those of the law dynamic only where there is a model.
struct StateAnswer {
  SeaState state;
  RayleighHeights heights;  ///< after the limit
  SeaBefore before;         ///< where its waves break, whether or not breaking limits them
  std::map<Law, Expectation> by_law;
  HighestOnBase base{};
};

/// Distribution of the heights of all waves, and sliding by height in one sea state.
struct HeightCurves {
  SeaState state;                                   ///< the sea state with the most sliding by the law exact
  std::vector<double> height;                       ///< m
  std::vector<double> waves;                        ///< of all sea states (1/m)
  std::map<Law, std::vector<double>> distance;      ///< S(H) (m)
  std::map<Law, std::vector<double>> contribution;  ///< to the expectation of that sea state (m/m)
  std::vector<double> peak_force, peak_shear;  ///< largest P and F_T of the law dynamic (N/m); empty without a model
  std::vector<double> heel_pressure;           ///< by Goda's formulas (Pa)
};

/// Number of waves above a height that the design asks for.
struct Exceedance {
  std::string name;
  double height = 0., waves = 0.;
};

struct ModelUsed {
  std::string title, load;
  double step = 0.;           ///< of all responses (s)
  double shortest_rise = 0.;  ///< of the waves that might slide the caisson (s)
  NumberedWarnings warnings;  ///< of the scene that it was made of
};

/// The worst value of each life, and their statistics.
struct WorstOfLives {
  std::vector<double> values;
  LifeStatistics statistics;       ///< of the values
  std::optional<Exceeded> beyond;  ///< how often the limit is passed, where there is one
};

struct BaseOfLives {
  WorstOfLives heel_pressure, toe_pressure, eccentricity, overturning_margin;
};

/// The worst of every way to fail in each life, over the worst wave of each of its storms.
struct WaysOfLives {
  WorstOfLives sliding, sliding_seaward, overturning, heel_pressure, toe_pressure, circles;
  double waves = 0.;  ///< answered, in all lives
  /// The largest share by which a factor under a lower wave of some of the seas is below that under the highest.
  double lower_worse = 0.;
};

struct MonteCarlo {
  Law law = Law::exact;
  LifeStatistics statistics;
  std::vector<double> sliding;            ///< S of each life (m)
  double waves = 0.;                      ///< in all lives
  double answered = 0.;                   ///< number of these waves whose S was computed
  double taken = 0.;                      ///< number of these waves that the limit broke or left out
  double highest = 0.;                    ///< height, of waves whose S was computed (m)
  std::optional<double> without_scatter;  ///< expectation of a life by quadrature, where only heights scatter (m)
  std::optional<BaseOfLives> base;
  std::string why_no_base;
  std::optional<WaysOfLives> ways;  ///< where the reduced model has slip circles
  double seconds = 0.;
};

/// S with slip and lift node by node: of all waves of the lives, or of the record, from some of them.
struct NodeSliding {
  double mean = 0.;             ///< of a life (m)
  double draw_error = 0.;       ///< standard error of the mean by the draw of waves (m)
  double standard_error = 0.;   ///< and by that of lives (m)
  Interval interval{};          ///< of the mean, 95 % (m)
  double block = 0.;            ///< S by the law dynamic (m)
  std::optional<double> ratio;  ///< to that, of the same waves; none where no block slides
  double ground_error = 0.;     ///< bound of what the reduced ground adds (m)
  int waves = 0;                ///< different ones that were answered
  int unanswered = 0;           ///< those which were not
  bool is_whole = false;        ///< whether all waves were answered
  bool of_lives = false;        ///< of lives, not of the record
};

/// Answers waves node by node by a model with contact, one of whose loads is the wave.
using NodeAnswer =
    std::function<std::vector<DearSlip>(const ReducedModelFile& model, int load, const std::vector<WaveOnBottom>&)>;

/// The distance that is told first: the largest of all routes to it.
struct Headline {
  double value = 0.;  ///< m
  Law law = Law::exact;
  std::string why;
};

struct ExpectedAnswer {
  std::vector<StateAnswer> states;
  std::map<Law, Expectation> total;  ///< thresholds: the least of all sea states
  double waves = 0.;                 ///< of all sea states, without waves beyond a cut
  double taken = 0.;                 ///< waves that the limit changed: broken to its height, or beyond a cut
  double all = 0.;                   ///< waves of all sea states
  HighestOnBase base;                ///< the worst of all sea states; height: of the largest heel pressure
  double highest = 0.;               ///< exceeded by one wave of the record, or the limit (m)
  std::vector<Exceedance> exceedance;
  HeightCurves curves;
  std::optional<ModelUsed> model;
  std::optional<MonteCarlo> monte_carlo;
  std::optional<MonteCarlo> formula_lives;  ///< the same lives by formulas, beside those by own dynamics
  std::optional<NodeSliding> nodes;         ///< where the model has contact, and the law is dynamic
  std::string why_no_nodes;                 ///< why not, where the model has contact; else ""
  double quadrature_seconds = 0., nodes_seconds = 0.;
  RecordNotes notes;  ///< how the sea states were read
};

/// The share of `all`; 0 where `all` is 0.
inline double share_of(double some, double all) {
  return all > 0. ? some / all : 0.;
}

/// Computes on all cores; the numbers do not depend on how many. `known`: all lives, which are not computed then;
/// `nodes`: where waves are also to be answered node by node. Throws NumericsError where a number is not finite.
ExpectedAnswer find_expected(const Design& design, const LivesByLaw* known = nullptr,
                             const NodeAnswer& nodes = nullptr);

/// Wall times (s).
struct ExpectedTiming {
  double read = 0., total = 0.;
};

/// Throws NumericsError where a number is not finite.
Json to_json(const Design& design, const ExpectedAnswer& answer, const ExpectedTiming& timing);
/// The keys of that JSON.
std::vector<OutputRow> rows_of_expected();
/// The bytes of results.h5.
std::string expected_file(const Design& design, const ExpectedAnswer& answer);
/// The numbers that people came for, for the terminal.
std::string brief(const Design& design, const ExpectedAnswer& answer, const Json& summary);

/// The largest expected distance, of all laws; and the largest mean S of a life, of both routes.
Headline headline_of(const ExpectedAnswer& answer);
Headline headline_of_life(const ExpectedAnswer& answer);

/// Checks of the record and of the lives against [limits], and what makes the numbers doubtful.
Checks checks_of(const Design& design, const ExpectedAnswer& answer);
NumberedWarnings warnings_of(const Design& design, const ExpectedAnswer& answer);
/// "213 of 9400 waves (2.3 %)".
std::string some_of(double some, double all);
/// What limits the heights: breaking, cut or none.
const char* word(const HighestWave& highest);

}  // namespace upbead
