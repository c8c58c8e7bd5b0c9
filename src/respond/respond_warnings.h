// What may be wrong with the answers of a reduced model though nothing failed: docs/warnings.md.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "output/wave_response.h"
#include "respond/wave_files.h"

namespace upbead {

/// Warnings of how waves were read, and of waves that are zero throughout.
NumberedWarnings warnings_of_files(const std::vector<WaveFile>& files);

/// Warning load_left_out of loads of the model's case that no wave has; implausible where the largest force of all
/// waves is none beside the caisson's weight; loads of unit size, powers of ten, are asked for ratios.
NumberedWarnings force_warnings(const ReducedModelFile& model, const std::vector<WaveFile>& files,
                                const std::vector<WaveResponses>& responses);

/// Warnings load_cut, load_zero and answer_cut of waves whose answer --end cuts, as of a run.
NumberedWarnings cut_warnings(const ReducedModelFile& model, const std::vector<WaveFile>& files,
                              const std::vector<WaveResponses>& responses);

/// Warning uplift_left_out: the case's prescribed uplift is a record of its own wave, which no answer has.
NumberedWarnings uplift_warnings(const ReducedModelFile& model);

/// Waves beyond the model's frequencies, of a large error or without one, slips that could not be computed, slip
/// circles.
NumberedWarnings warnings_of_answers(const ReducedModelFile& model, const std::vector<WaveResponses>& files);

/// "1.23 landward at 0.5 s".
std::string circle_text(const std::optional<CircleInWave>& circle);

}  // namespace upbead
