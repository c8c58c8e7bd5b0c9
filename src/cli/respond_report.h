// What `upbead respond` tells a person.
#pragma once

#include <string>
#include <vector>

#include "output/wave_response.h"
#include "upbead/base/numbered_warning.h"

namespace upbead {

/// A table of a few waves; of many, their number, ranges and the worst.
std::string describe(const ReducedModelFile& model, const std::vector<WaveResponses>& files,
                     const RespondTiming& timing);

/// A warning where the coupled S of waves is not told; else "".
std::string slip_warning(const std::vector<WaveResponses>& files);

/// A warning where waves have more beyond the model's highest frequency than its tolerance; else "".
std::string band_warning(const ReducedModelFile& model, const std::vector<WaveResponses>& files);

/// Waves whose error estimate exceeds the model's tolerance; models that cannot tell any: docs/warnings.md.
NumberedWarnings error_warnings(const ReducedModelFile& model, const std::vector<WaveResponses>& files);

}  // namespace upbead
