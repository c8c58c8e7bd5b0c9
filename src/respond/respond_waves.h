// The response of a reduced model to waves: histories of P and F_T, peaks, sliding.
#pragma once

#include <optional>
#include <vector>

#include "output/wave_response.h"
#include "respond/wave_files.h"
#include "upbead/output/model_file.h"

namespace upbead {

struct RespondOptions {
  std::optional<double> end;            ///< end of the response (s); none: end of the waves, or of the case if later
  std::optional<ModelSliding> sliding;  ///< for S; its uplift is not `history`
};

/// Computes all waves on all cores; the numbers do not depend on how many. Throws InputError where the model has no
/// caisson, or where the results would not fit into memory.
std::vector<WaveResponses> respond_to_waves(const ReducedModelFile& model, const std::vector<WaveFile>& files,
                                            const RespondOptions& options);

}  // namespace upbead
