// responses.h5 and its summary: what `upbead respond` finds of each wave.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dynamics/batch_response.h"
#include "upbead/base/numbered_warning.h"
#include "upbead/output/model_file.h"

namespace upbead {

struct OutputRow;

/// What becomes of a caisson that slips as a whole on the ground that it shakes. Landward positive.
struct CoupledWave {
  double sliding = 0.;      ///< S, where it comes to rest (m)
  double largest = 0.;      ///< of largest magnitude on the way (m)
  int slips = 0;            ///< one ends where it stops or turns
  double dissipated = 0.;   ///< by friction (J/m)
  double lifted_time = 0.;  ///< time in which N' would have been negative (s)
};

/// One wave. Landward positive, as in a run.
struct WaveResponse {
  double peak_force = 0.;          ///< largest P (N/m)
  double peak_shear = 0.;          ///< largest F_T (N/m)
  double peak_shear_time = 0.;     ///< s
  double peak_shear_seaward = 0.;  ///< least F_T (N/m)
  std::optional<double> ratio;     ///< peak F_T / peak P, both seaward where the largest |P| is; none where P = 0
  double beyond_band = 0.;         ///< part of F_T from frequencies beyond the model's, over the largest |F_T|
  /// Bound of the error of F_T's history by the model, over the largest |F_T|; none where the model cannot tell.
  std::optional<double> error_estimate{};
  /// S by eq. (4) on F_T, where it comes to rest (m); none where nobody asked.
  std::optional<double> sliding{};
  std::optional<double> peak_heel_pressure{}, peak_toe_pressure{};  ///< Pa; none as in BaseExtremes, or not known
  std::optional<double> least_overturning_margin{};                 ///< likewise
  std::optional<CoupledWave> coupled{};  ///< none where nobody asked, or the model cannot tell
  std::string why_not_coupled{};         ///< where somebody asked and this wave's cannot be told
};

/// All waves of one file, at the same times.
struct WaveResponses {
  std::string name;                 ///< of the file, without folder and ending
  std::vector<double> time;         ///< N (s)
  WaveSamples force;                ///< P, one wave a row (N/m)
  WaveSamples shear_force;          ///< F_T of a caisson that sticks (N/m)
  std::vector<WaveResponse> waves;  ///< one a row

  /// "name", or "name[3]" where the file holds several waves.
  std::string wave_name(std::size_t wave) const;
};

/// Wall times (s).
struct RespondTiming {
  double read = 0., respond = 0., write = 0., total = 0.;
};

/// The bytes of responses.h5: a group per file as docs/output.md has it. Throws NumericsError where a number is not
/// finite.
std::string response_file(const std::string& title, const std::vector<WaveResponses>& files);

/// summary.json of `respond`. `path`: that of the model; `warnings`: docs/warnings.md. Call after response_file(),
/// which checks the numbers.
std::string to_json(const ReducedModelFile& model, const std::string& path, const std::vector<WaveResponses>& files,
                    const RespondTiming& timing, const NumberedWarnings& warnings = {});

/// Its keys.
std::vector<OutputRow> rows_of_respond();

}  // namespace upbead
