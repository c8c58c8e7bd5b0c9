// The response of a reduced model to waves: histories of P and F_T, peaks, sliding.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "output/wave_response.h"
#include "respond/wave_files.h"
#include "respond/wave_histories.h"
#include "upbead/output/model_file.h"

namespace upbead {

struct RespondOptions {
  std::optional<double> end;  ///< of the response (s); none: of the case, or later of the waves with their echo
  std::optional<ModelSliding> sliding;  ///< for S; its uplift is not `history`
  std::string why_no_slip{};            ///< why a model has no coupled slip that others have where S is asked for
  AskedHistories histories{};           ///< readings whose histories are kept
};

/// Of a period after a short pulse, when the section has rebounded (Chopra, Dynamics of Structures, ch. 4).
constexpr double of_rebound = 0.75;

/// The period of the mode that makes most of F_T under a load that lasts (s): with it the caisson swings.
double swing_period_of(const ModalModel& modes);

/// When the answer to a file's waves ends where nobody asks for less (s).
double whole_answer(const ReducedModelFile& model, const WaveFile& file);

/// How long the section swings on after a load (s): three of its longest periods, after which a hundredth is left where
/// it loses a quarter in each, as settled_end() has it, but not longer than the model's case was given after its loads;
/// in each case until it has answered most and rebounded, which answer_warnings() asks of a run.
double echo_of(const ReducedModelFile& model);

/// Computes all waves on all cores; the numbers do not depend on how many. Throws InputError where the model has no
/// caisson, or where the results would not fit into memory; std::out_of_range where it lacks a reading.
std::vector<WaveResponses> respond_to_waves(const ReducedModelFile& model, const std::vector<WaveFile>& files,
                                            const RespondOptions& options);

}  // namespace upbead
