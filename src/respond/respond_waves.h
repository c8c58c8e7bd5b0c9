// What a reduced model answers to waves: histories of P and F_T, peaks, sliding.
#pragma once

#include <optional>
#include <vector>

#include "output/wave_response.h"
#include "respond/wave_files.h"
#include "upbead/output/model_file.h"

namespace upbead {

struct RespondOptions {
  std::optional<double> end;  ///< how long to answer (s); none: to the end of the waves, or of the case if later
  std::optional<ModelSliding> sliding;  ///< what S is asked with; its uplift is not `history`
};

/// Answers all waves on all cores; the same numbers whatever the number of cores. Throws InputError where the model has
/// no caisson or the answers would be too many to hold.
std::vector<WaveResponses> respond_to_waves(const ReducedModelFile& model, const std::vector<WaveFile>& files,
                                            const RespondOptions& options);

}  // namespace upbead
