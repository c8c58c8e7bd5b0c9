// S of waves of lives with slip and lift node by node, on the reduced ground of a model.
#pragma once

#include <vector>

#include "expected/dynamic_law.h"
#include "expected/wave_sample.h"
#include "upbead/output/model_file.h"

namespace upbead {

/// Answers the waves on all cores, each from rest; `load`: of the model, which stands for the wave. The model has
/// contact. S is how far the bottom as a whole slid: local slip at edges that lift hardly grows from one equal wave to
/// the next. N at rest is that of the model, scaled to W' of the wave, and S is inversely proportional to the mass, as
/// in a block. The uplift is Goda's triangle.
std::vector<DearSlip> node_slips(const ReducedModelFile& model, int load, const std::vector<WaveOnBottom>& waves);

}  // namespace upbead
