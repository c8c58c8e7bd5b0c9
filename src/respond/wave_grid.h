// The times at which a reduced model is asked about a wave.
#pragma once

#include <optional>

#include "respond/wave_files.h"
#include "upbead/dynamics/modal_response.h"

namespace upbead {

/// Begins at 0 and ends where the answer ends; holds every time of the waves up to there.
struct WaveGrid {
  std::vector<double> time;         ///< s
  std::optional<double> equal;      ///< the step, where all are equal (s)
  std::size_t first = 0;            ///< index of the waves' first time
  std::optional<std::size_t> last;  ///< index of the waves' last time, where the grid goes on beyond
};

/// No part of the grid is longer than `longest_step` (s). Times that start at 0 with equal steps no longer than that
/// are kept, and go on at the same step up to `end` or the first time past it; longer ones are cut into equal parts
/// where that meets `end`. Throws InputError (without a place) where there would be more than 10,000,000 of them.
WaveGrid make_wave_grid(const std::vector<double>& time, double longest_step, double end);

/// A wave at the times of the grid, K rows; straight between its own times and zero outside them.
WaveSamples on_grid(const WaveFile& file, int wave, const std::vector<double>& time);

/// The same for the exact response: it jumps from zero to its first value, and from its last value to zero.
SampledLoads with_jumps(const WaveSamples& samples, const WaveGrid& grid);

/// Equally spaced times from 0 to `until` or just past it, to look at frequencies: those of the grid where they are
/// equal, else not longer apart than the grid's, but never closer than a tenth of `longest_step`.
std::vector<double> equal_times(const WaveGrid& grid, double longest_step, double until);

}  // namespace upbead
