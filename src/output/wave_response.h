// responses.h5 and its summary: the results of `upbead respond` for each wave.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "dynamics/batch_response.h"
#include "output/output_schema.h"
#include "upbead/base/numbered_warning.h"
#include "upbead/output/model_file.h"
#include "upbead/output/sliding_summary.h"
#include "upbead/sliding/base_pressure.h"

namespace upbead {

/// Results for a caisson that slides as a rigid block on the moving ground. Landward positive.
struct CoupledWave {
  double sliding = 0.;      ///< S, after it has come to rest (m)
  double largest = 0.;      ///< value of largest magnitude during the motion (m)
  int slips = 0;            ///< one ends where it stops or turns
  double dissipated = 0.;   ///< by friction (J/m)
  double lifted_time = 0.;  ///< time in which N' would have been negative (s)
};

/// The least safe circle of a model's family in a wave.
struct CircleInWave {
  double factor =
      0.;            ///< F by Bishop's simplified method; 0 where the resultant leaves the base, then without a circle
  double time = 0.;  ///< s
  std::string slips, by;                          ///< landward or seaward; still or computed pore pressure
  std::optional<std::array<double, 2>> centre{};  ///< m
  std::optional<double> radius{}, from{}, to{};   ///< of the circle, and x of its ends (m)
  double force = 0., shear = 0., moment = 0.;     ///< N', F_T (N/m), M' (N m/m) then
};

/// F_T of the caisson as it stands.
struct PeaksOfShear {
  double peak_shear = 0., peak_shear_time = 0., peak_shear_seaward = 0.;  ///< as in WaveResponse
};

/// Results for one wave. Landward positive, as in a run.
struct WaveResponse {
  double peak_force = 0.;          ///< largest P (N/m)
  double peak_force_seaward = 0.;  ///< least P (N/m)
  double peak_shear = 0.;          ///< largest F_T (N/m)
  double peak_shear_time = 0.;     ///< s
  double peak_shear_seaward = 0.;  ///< least F_T (N/m)
  std::optional<double> ratio;     ///< peak F_T / peak P, both seaward where the largest |P| is; none where P = 0
  double beyond_band = 0.;         ///< share of F_T above the model's highest frequency, over the largest |F_T|
  /// Bound of the model's error in the history of F_T, over the largest |F_T|; none where the model cannot estimate
  /// it.
  std::optional<double> error_estimate{};
  /// S by eq. (4) on F_T, after it has come to rest (m); none where it was not asked for.
  std::optional<double> sliding{};
  /// Whether it slides while the last loads, as they are then, exceed the friction: S holds if they stop there.
  bool slides_on = false;
  double left_out_uplift = 0.;                                      ///< largest of the pores, where S counts none (N/m)
  bool slides_by_left_out_uplift = false;                           ///< whether it would slide by that
  std::optional<double> peak_heel_pressure{}, peak_toe_pressure{};  ///< Pa; none as in BaseExtremes, or not known
  std::optional<double> least_overturning_margin{};                 ///< none likewise
  /// mu N'/F_T while F_T acts that way; none where it never does, S was not asked for, or the base is not known.
  std::optional<double> least_sliding_factor{}, least_sliding_factor_seaward{};
  std::optional<EdgeStress> tension{};   ///< of an edge that would lift, as the base of a model is bonded
  std::optional<CircleInWave> circle{};  ///< none where the model has no circles, or none has a factor
  std::optional<CoupledWave> coupled{};  ///< none where it was not asked for, or could not be computed
  std::string why_not_coupled{};         ///< why a result that was asked for could not be computed; else ""
  /// Slip and lift node by node; none where the model has none.
  std::optional<ContactSummary> contact{};
  std::optional<PeaksOfShear> response{};  ///< with it; none where it could not be answered
  std::string why_not_contact{};           ///< then; else ""
};

/// A reading that was asked for by name, over the times of its file.
struct WaveHistory {
  ReadingLabel label;
  WaveSamples value;      ///< a row for each wave
  Eigen::VectorXd error;  ///< of each wave, estimated, over the largest magnitude; empty where nothing tells it
};

/// Results for all waves of one file, at the same times.
struct WaveResponses {
  std::string name;                 ///< of the file, without folder and ending
  std::vector<double> time;         ///< N (s)
  WaveSamples force;                ///< P, a row for each wave (N/m)
  WaveSamples shear_force;          ///< F_T of a caisson that sticks (N/m)
  std::vector<WaveResponse> waves;  ///< one for each row
  std::vector<WaveHistory> histories{};

  /// "name", or "name[3]" where the file holds several waves.
  std::string wave_name(std::size_t wave) const;
};

/// Wall times (s).
struct RespondTiming {
  double read = 0., respond = 0., write = 0., total = 0.;
};

/// What was answered: a model, its file, and the soil where it has many (key and value).
struct AnsweredModel {
  const ReducedModelFile& model;
  std::string path;
  std::map<std::string, double> soil{};
};

/// The bytes of responses.h5: one group for each file, as docs/output.md describes it. Throws NumericsError where a
/// number is not finite.
std::string response_file(const AnsweredModel& of, const std::vector<WaveResponses>& files);

/// A wave with the keys that it has in the summary. Throws NumericsError where a number is not finite.
std::string to_json(const WaveResponse& wave);

/// summary.json of `respond`. `warnings`: docs/warnings.md. To be called after response_file(), which checks the
/// numbers.
Json to_json(const AnsweredModel& of, const std::vector<WaveResponses>& files, const RespondTiming& timing,
             const NumberedWarnings& warnings = {});

/// What a server of soils says of one of them, on one line: docs/soils.md. Throws NumericsError where a number is not
/// finite.
std::string soil_line(const AnsweredModel& of, const std::vector<WaveResponses>& files,
                      const NumberedWarnings& warnings);

/// The same of a soil that could not be answered; one that could not be read is null.
std::string soil_line(const std::optional<std::map<std::string, double>>& soil, const std::string& why);

/// The keys of summary.json of `respond`.
std::vector<OutputRow> rows_of_respond();

}  // namespace upbead
